#include "evaluation/readers/height_reader.h"

#include <cmath>
#include <fstream>
#include <limits>

#include "evaluation/readers/file_bytes.h"
#include "evaluation/sha256.h"

namespace evaluation {
namespace {

using brdf::Errc;
using brdf::Error;
using brdf::Length;

std::pair<Length, Length> pixel_size(const detail::RawHeights& raw, const HeightScale& scale,
                                     const std::string& name) {
  if (scale.width) {
    const Length pixel = Length::um(scale.width->um() / static_cast<double>(raw.values.cols()));
    return {pixel, pixel};
  }
  if (scale.pixel) return *scale.pixel;
  if (raw.pixel_x && raw.pixel_y) return {*raw.pixel_x, *raw.pixel_y};
  throw Error(Errc::bad_input, name + ": the file gives no lateral scale; give --width or --pixel");
}

/// Length of one unit of the stored values.
Length height_unit(const detail::RawHeights& raw, const HeightScale& scale,
                   const std::string& name) {
  if (raw.full_scale) {
    if (scale.height_unit)
      throw Error(Errc::invalid_argument, name + ": --height-unit is for floating-point heights; " +
                                              raw.format + " takes --height-range");
    if (!scale.height_range)
      throw Error(Errc::bad_input, name +
                                       ": the file gives no height scale; give --height-range, "
                                       "the height of the full-scale code");
    return Length::um(scale.height_range->um() / *raw.full_scale);
  }
  if (scale.height_range)
    throw Error(Errc::invalid_argument, name + ": --height-range is for integer codes; " +
                                            raw.format + " holds floating-point heights" +
                                            (raw.unit ? " with their unit" : "") +
                                            " (--height-unit sets it)");
  if (scale.height_unit) return *scale.height_unit;
  if (raw.unit) return *raw.unit;
  throw Error(Errc::bad_input, name + ": the file gives no unit of height; give --height-unit");
}

}  // namespace

void detail::require_grid(std::uint64_t cols, std::uint64_t rows, const std::string& name) {
  if (cols == 0 || rows == 0 || cols > max_pixels || rows > max_pixels || cols * rows > max_pixels)
    throw Error(Errc::bad_input, name + ": " + std::to_string(cols) + " x " + std::to_string(rows) +
                                     " pixels, must be from 1 to " + std::to_string(max_pixels) +
                                     " in all");
}

bool holds_heights(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(32, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return detail::is_png(head) || detail::is_gsf(head);
}

HeightFile read_heights(const std::filesystem::path& path, const HeightScale& scale) {
  const std::string name = path.string();
  const std::string bytes = read_file_bytes(path);
  detail::RawHeights raw;
  if (detail::is_png(bytes))
    raw = detail::decode_png(bytes, name);
  else if (detail::is_gsf(bytes))
    raw = detail::decode_gsf(bytes, name);
  else
    throw Error(Errc::bad_input,
                name + ": not a known format; PNG and Gwyddion Simple Field (.gsf) are read");

  const std::pair<Length, Length> pixel = pixel_size(raw, scale, name);
  const Length unit = height_unit(raw, scale, name);
  // Integer codes are one unit apart, floats one rounding of the largest value.
  const double code = raw.full_scale
                          ? 1.0
                          : raw.values.abs().maxCoeff() *
                                static_cast<double>(std::numeric_limits<float>::epsilon());
  raw.values *= unit.um();
  const Length step = Length::um(code * unit.um());
  return brdf::at_place(name, [&]() -> HeightFile {
    return {brdf::HeightField(std::move(raw.values), pixel.first, pixel.second, step), raw.format,
            sha256_hex(bytes)};
  });
}

}  // namespace evaluation
