// Gwyddion's native format: "GWYP", then one serialised object, GwyContainer. Channel N is its item
// "/N/data", a GwyDataField, with "/N/data/title" and "/N/mask" beside it. Described in the chapter
// "Gwyddion File Format" of Gwyddion's user guide.
#include "evaluation/readers/gwy_reader.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "brdf/error.h"
#include "evaluation/lengths.h"
#include "evaluation/readers/gwy_items.h"
#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

using brdf::Length;

constexpr std::string_view magic = "GWYP";

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw brdf::Error(brdf::Errc::bad_input, name + ": GWY: " + what);
}

/// A GwyDataField, its numbers still in the file.
struct Field {
  std::int32_t cols = 0, rows = 0;
  std::optional<double> width, height;
  std::string xy_unit, z_unit;
  std::string_view data;

  std::uint64_t size() const {
    return static_cast<std::uint64_t>(cols) * static_cast<std::uint64_t>(rows);
  }
  double operator[](std::uint64_t i) const {
    return stored_number<double>(data.data() + sizeof(double) * i);
  }
};

/// What stands in the container under one number.
struct Channel {
  std::string_view field, mask, title;
};

std::string unit_of(std::string_view si_unit, const std::string& name) {
  GwyItems items(si_unit, name);
  while (const auto item = items.next())
    if (item->key == "unitstr" && item->type == 's') return std::string(item->bytes);
  return {};
}

Field field_of(std::string_view object, const std::string& name) {
  Field field;
  GwyItems items(object, name);
  while (const auto item = items.next()) {
    const auto is = [&](std::string_view key, char type) {
      return item->key == key && item->type == type;
    };
    const char* bytes = item->bytes.data();
    if (is("xres", 'i')) field.cols = stored_number<std::int32_t>(bytes);
    if (is("yres", 'i')) field.rows = stored_number<std::int32_t>(bytes);
    if (is("xreal", 'd')) field.width = stored_number<double>(bytes);
    if (is("yreal", 'd')) field.height = stored_number<double>(bytes);
    if (is("si_unit_xy", 'o')) field.xy_unit = unit_of(item->bytes, name);
    if (is("si_unit_z", 'o')) field.z_unit = unit_of(item->bytes, name);
    if (is("data", 'D')) field.data = item->bytes;
  }
  return field;
}

/// Holds the size against the limit and against the numbers that are there.
void require_whole(const Field& field, const HeightRequest& request, const std::string& name) {
  if (field.cols < 0 || field.rows < 0)
    refuse(name, std::to_string(field.cols) + " x " + std::to_string(field.rows) + " pixels");
  require_grid(static_cast<std::uint64_t>(field.cols), static_cast<std::uint64_t>(field.rows),
               request, name);
  if (field.data.size() != sizeof(double) * field.size())
    refuse(name, std::to_string(field.data.size() / sizeof(double)) + " numbers, " +
                     std::to_string(field.cols) + " x " + std::to_string(field.rows) +
                     " pixels need " + std::to_string(field.size()));
}

/// By their numbers in the container. Masks and titles without a field are left out.
std::vector<Channel> channels_of(const FileSource& source) {
  const std::string& name = source.name();
  GwyItems file(source.bytes().substr(magic.size()), name);
  const GwyItem container = file.object();
  if (container.object != "GwyContainer")
    refuse(name, "holds a " + std::string(container.object.substr(0, 40)) + ", no GwyContainer");
  if (!file.at_end()) refuse(name, "bytes follow the container");
  std::map<std::uint32_t, Channel> by_number;
  GwyItems items(container.bytes, name);
  while (const auto item = items.next()) {
    const std::string_view key = item->key;
    if (!key.starts_with('/')) continue;
    std::uint32_t number = 0;
    const auto [after, ec] = std::from_chars(key.data() + 1, key.data() + key.size(), number);
    if (ec != std::errc{}) continue;
    const std::string_view rest(after, static_cast<std::size_t>(key.end() - after));
    const bool is_field = item->type == 'o' && item->object == "GwyDataField";
    if (rest == "/data" && is_field) by_number[number].field = item->bytes;
    if (rest == "/mask" && is_field) by_number[number].mask = item->bytes;
    if (rest == "/data/title" && item->type == 's') by_number[number].title = item->bytes;
  }
  std::vector<Channel> channels;
  for (const auto& [number, channel] : by_number)
    if (!channel.field.empty()) channels.push_back(channel);
  return channels;
}

std::optional<Length> pixel(const std::optional<double>& side, const std::string& unit,
                            std::int32_t count, const std::string& name) {
  const std::optional<Length> one = length_unit(unit);
  if (!side || !one) return std::nullopt;
  if (!(*side > 0 && std::isfinite(*side)))
    refuse(name, "a side is " + brdf::text(*side) + " " + unit + ", must be > 0");
  return Length::um(*side * one->um() / count);
}

void take_out_masked(brdf::HeightArray& heights, const Field& mask, const std::string& name) {
  if (mask.cols != heights.cols() || mask.rows != heights.rows())
    refuse(name, "the mask has " + std::to_string(mask.cols) + " x " + std::to_string(mask.rows) +
                     " pixels, the channel " + std::to_string(heights.cols()) + " x " +
                     std::to_string(heights.rows()));
  for (std::uint64_t i = 0; i < mask.size(); ++i)
    if (mask[i] > 0) heights.data()[i] = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

bool is_gwy(std::string_view head) {
  return head.starts_with(magic);
}

RawHeights decode_gwy(const FileSource& source, const HeightRequest& request) {
  const std::string& name = source.name();
  const std::vector<Channel> channels = channels_of(source);
  RawHeights raw;
  std::vector<Field> fields;
  for (const Channel& channel : channels) {
    fields.push_back(field_of(channel.field, name));
    raw.channels.push_back({std::string(channel.title), fields.back().z_unit});
  }
  const std::size_t chosen = chosen_channel(raw.channels, request.channel, name);
  const Field& field = fields[chosen];
  require_whole(field, request, name);

  raw.format = "Gwyddion native, 64 bit float";
  raw.channel = raw.channels[chosen].title;
  raw.rounding = std::numeric_limits<double>::epsilon();
  raw.unit = length_unit(field.z_unit);
  raw.unit_name = field.z_unit;
  raw.pixel_x = pixel(field.width, field.xy_unit, field.cols, name);
  raw.pixel_y = pixel(field.height, field.xy_unit, field.rows, name);
  raw.values.resize(field.rows, field.cols);
  for (std::uint64_t i = 0; i < field.size(); ++i) raw.values.data()[i] = field[i];
  if (!channels[chosen].mask.empty()) {
    const Field mask = field_of(channels[chosen].mask, name);
    require_whole(mask, request, name);
    take_out_masked(raw.values, mask, name);
  }
  return raw;
}

}  // namespace evaluation::detail
