#include "evaluation/readers/height_reader.h"

#include <cmath>
#include <limits>

#include "evaluation/readers/file_source.h"
#include "evaluation/readers/height_formats.h"
#include "evaluation/readers/samples.h"
#include "evaluation/readers/vendor_reader.h"

namespace evaluation {
namespace {

using brdf::Errc;
using brdf::Error;
using brdf::Length;

std::pair<Length, Length> pixel_size(const RawHeights& raw, const HeightScale& scale,
                                     const std::string& name) {
  if (scale.width) {
    const Length pixel = Length::um(scale.width->um() / static_cast<double>(raw.values.cols()));
    return {pixel, pixel};
  }
  if (scale.pixel) return *scale.pixel;
  if (raw.pixel_x && raw.pixel_y) return {*raw.pixel_x, *raw.pixel_y};
  throw Error(Errc::bad_input,
              name + ": the file gives no lateral scale that is a length; give --width or --pixel");
}

/// Height of a stored value: one unit of it times the value, from the origin.
struct StoredScale {
  Length unit, origin = {};
};

StoredScale stored_scale(const RawHeights& raw, const HeightScale& scale, const std::string& name) {
  if (raw.full_scale) {
    if (scale.height_unit)
      throw Error(Errc::invalid_argument, name + ": --height-unit is for floating-point heights; " +
                                              raw.format + " takes --height-range");
    if (scale.height_range) return {Length::um(scale.height_range->um() / *raw.full_scale)};
    if (!raw.code_heights)
      throw Error(Errc::bad_input, name +
                                       ": the file gives no height scale; give --height-range, "
                                       "the height of the full-scale code");
    const auto [lowest, highest] = *raw.code_heights;
    return {Length::um((highest.um() - lowest.um()) / *raw.full_scale), lowest};
  }
  if (scale.height_range)
    throw Error(Errc::invalid_argument, name + ": --height-range is for integer codes; " +
                                            raw.format + " holds heights as numbers" +
                                            (raw.unit ? " with their unit" : "") +
                                            " (--height-unit sets it)");
  if (scale.height_unit) return {*scale.height_unit};
  if (raw.unit) return {*raw.unit};
  throw Error(Errc::bad_input,
              name +
                  (raw.unit_name.empty() ? ": the file gives no unit of height"
                                         : ": the unit \"" + raw.unit_name + "\" is no length") +
                  "; give --height-unit");
}

/// Integer codes are one unit apart, floats one rounding of the largest value.
double stored_step(const RawHeights& raw) {
  if (raw.step) return *raw.step;
  if (raw.full_scale) return 1;
  return detail::step_at_largest(raw.values, std::numeric_limits<float>::epsilon());
}

RawHeights decoded(const FileSource& source, const HeightRequest& request) {
  const HeightFormat* format = height_format_of(source.head());
  if (format && format->is_built_in) return format->decode(source, request);
  if (format)
    throw Error(Errc::bad_input, source.name() + ": is " + std::string(format->name) +
                                     ", which this build cannot read: it was made without " +
                                     std::string(format->library));
  if (source.is_on_disk() && detail::is_vendor_name(source.name()))
    return detail::decode_through_gwyddion(source.name(), request);
  std::string names;
  for (const HeightFormat& known : height_formats())
    names.append(names.empty() ? "" : ", ").append(known.name);
  throw Error(Errc::bad_input, source.name() + ": not a known format; read are " + names);
}

}  // namespace

bool holds_heights(const std::filesystem::path& path) {
  try {
    return height_format_of(FileSource(path).head()) != nullptr;
  } catch (const Error&) {
    return false;
  }
}

HeightFile read_heights(const std::filesystem::path& path, const HeightChoice& choice) {
  return read_heights(FileSource(path), choice);
}

HeightFile read_heights(const FileSource& source, const HeightChoice& choice) {
  const std::string& name = source.name();
  RawHeights raw = decoded(source, {choice.channel, choice.max_pixels});
  if (choice.channel && raw.channels.empty())
    throw Error(Errc::invalid_argument,
                name + ": --channel has no meaning for " + raw.format + ", which holds one");
  const std::pair<Length, Length> pixel = pixel_size(raw, choice.scale, name);
  const StoredScale scale = stored_scale(raw, choice.scale, name);
  const std::size_t filled = fill_missing(raw.values, choice.missing, name);
  const Length step = Length::um(stored_step(raw) * std::abs(scale.unit.um()));
  raw.values *= scale.unit.um();
  // Not added where it is 0, which would take the sign of -0.
  if (scale.origin.um() != 0) raw.values += scale.origin.um();
  return brdf::at_place(name, [&]() -> HeightFile {
    return {brdf::HeightField(std::move(raw.values), pixel.first, pixel.second, step),
            raw.format,
            source.sha256(),
            raw.channel,
            raw.channels,
            filled,
            scale.unit};
  });
}

}  // namespace evaluation
