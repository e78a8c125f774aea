// The formats of height files: what each decoder gives, and the list of them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brdf/height_field.h"
#include "evaluation/readers/file_source.h"
#include "evaluation/readers/height_channels.h"

namespace evaluation {

/// What a decoder is asked for.
struct HeightRequest {
  std::optional<std::string> channel;  ///< title or number of one of several
  std::uint64_t max_pixels;            ///< more are refused before memory is taken
};

/// Heights as stored, before any scale. A pixel without a height is NaN.
struct RawHeights {
  brdf::HeightArray values;
  std::string format;                   ///< for people, e.g. "PNG, 8 bit grey"
  std::string channel;                  ///< title of what was read; empty where the format has none
  std::vector<HeightChannel> channels;  ///< all that there are
  std::optional<double> full_scale;     ///< largest code of an integer format
  /// Of code 0 and of the largest one, where the file says so.
  std::optional<std::pair<brdf::Length, brdf::Length>> code_heights;
  /// From a stored value to the next; nothing for codes and numbers of single precision.
  std::optional<double> step;
  std::optional<brdf::Length> pixel_x, pixel_y;
  std::optional<brdf::Length> unit;  ///< of the values
  std::string unit_name;             ///< the same as the file writes it, a length or not
};

/// A format: how it is recognised and decoded. One line in `height_formats`.
struct HeightFormat {
  std::string_view name;     ///< for people, e.g. "Gwyddion Simple Field (.gsf)"
  std::string_view library;  ///< that it needs, for the version; empty without one
  bool is_built_in;          ///< no where the library was missing
  bool (*recognises)(std::string_view head);
  /// Throws Errc::bad_input, one line naming file, place, value and limit. Null where not built in.
  RawHeights (*decode)(const FileSource& source, const HeightRequest& request);
};

/// All formats; the first that recognises a file reads it.
std::span<const HeightFormat> height_formats();

/// The format that recognises a file's beginning; null for none.
const HeightFormat* height_format_of(std::string_view head);

namespace detail {

/// Refuses a grid that is empty or larger than the limit, before memory is taken for it.
void require_grid(std::uint64_t cols, std::uint64_t rows, const HeightRequest& request,
                  const std::string& name);

bool is_png(std::string_view head);
RawHeights decode_png(const FileSource& source, const HeightRequest& request);
bool is_gsf(std::string_view head);
RawHeights decode_gsf(const FileSource& source, const HeightRequest& request);

}  // namespace detail
}  // namespace evaluation
