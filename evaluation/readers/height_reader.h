// Height fields from files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "brdf/height_field.h"

namespace evaluation {

/// What the user says of a file's scale. Each overrides what the file says of itself.
struct HeightScale {
  std::optional<brdf::Length> width;                           ///< columns x pixel
  std::optional<std::pair<brdf::Length, brdf::Length>> pixel;  ///< along x, along y
  std::optional<brdf::Length> height_range;  ///< of the full-scale code of an integer format
  std::optional<brdf::Length> height_unit;   ///< one unit of a floating-point format
};

/// A height field, and where it came from.
struct HeightFile {
  brdf::HeightField field;
  std::string format;  ///< for people, e.g. "PNG, 8 bit grey"
  std::string sha256;  ///< of the file's bytes
};

/// Most pixels that are read.
inline constexpr std::size_t max_pixels = std::size_t{1} << 28;

/// Reads PNG (8 or 16 bit grey, or colour where R = G = B) or Gwyddion Simple Field, recognised by
/// content.
///
/// Throws brdf::Error, one line naming file, place, value and limit. Errc::bad_input: missing,
/// empty, truncated or unknown file, too many pixels, heights that are not finite, a scale that
/// neither the file nor the user gives. Errc::invalid_argument: a scale that has no meaning for
/// the format.
HeightFile read_heights(const std::filesystem::path& path, const HeightScale& scale);

/// Whether a file begins like one of these formats; no for one that cannot be read.
bool holds_heights(const std::filesystem::path& path);

namespace detail {

/// Heights as stored, before any scale.
struct RawHeights {
  brdf::HeightArray values;
  std::string format;
  std::optional<double> full_scale;  ///< largest code of an integer format
  std::optional<brdf::Length> pixel_x, pixel_y;
  std::optional<brdf::Length> unit;  ///< of the values
};

bool is_png(std::string_view bytes);
bool is_gsf(std::string_view bytes);
RawHeights decode_png(std::string_view bytes, const std::string& name);
RawHeights decode_gsf(std::string_view bytes, const std::string& name);

/// Refuses a grid that is empty or larger than max_pixels, before memory is taken for it.
void require_grid(std::uint64_t cols, std::uint64_t rows, const std::string& name);

}  // namespace detail
}  // namespace evaluation
