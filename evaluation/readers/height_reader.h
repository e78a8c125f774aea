// Height fields from files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brdf/height_field.h"
#include "evaluation/readers/height_channels.h"
#include "evaluation/readers/missing_heights.h"

namespace evaluation {

class FileSource;

/// What the user says of a file's scale. Each overrides what the file says of itself.
struct HeightScale {
  std::optional<brdf::Length> width;                           ///< columns x pixel
  std::optional<std::pair<brdf::Length, brdf::Length>> pixel;  ///< along x, along y
  std::optional<brdf::Length> height_range;  ///< of the full-scale code of an integer format
  std::optional<brdf::Length> height_unit;   ///< one unit of a floating-point format
};

/// Most pixels that are read, unless the user says otherwise.
inline constexpr std::uint64_t max_pixels = std::uint64_t{1} << 28;

/// What is taken from a file, and how.
struct HeightChoice {
  HeightScale scale = {};
  std::optional<std::string> channel = {};  ///< title or number of one of several
  MissingHeights missing = MissingHeights::refuse;
  std::uint64_t max_pixels = evaluation::max_pixels;
};

/// A height field, and where it came from.
struct HeightFile {
  brdf::HeightField field;
  std::string format;                        ///< for people, e.g. "PNG, 8 bit grey"
  std::string sha256;                        ///< of the file's bytes
  std::string channel = {};                  ///< title; empty where the format has none
  std::vector<HeightChannel> channels = {};  ///< all that there are
  std::size_t filled = 0;                    ///< pixels that had no height
  brdf::Length unit = {};                    ///< height of one unit, or code, of the stored values
};

/// Reads a height file of any of `height_formats`, recognised by content.
///
/// Throws brdf::Error, one line naming file, place, value and limit. Errc::bad_input: missing,
/// empty, truncated or unknown file, too many pixels, heights that are missing or not finite, a
/// scale that neither the file nor the user gives. Errc::invalid_argument: a scale that has no
/// meaning for the format, a channel that is not there.
HeightFile read_heights(const std::filesystem::path& path, const HeightChoice& choice);

/// The same of an open file, or of bytes in memory.
HeightFile read_heights(const FileSource& source, const HeightChoice& choice);

/// Whether a file begins like one of these formats; no for one that cannot be read.
bool holds_heights(const std::filesystem::path& path);

}  // namespace evaluation
