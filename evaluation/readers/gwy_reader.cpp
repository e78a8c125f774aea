// Gwyddion's native format: "GWYP", then one serialised object, GwyContainer. Channel N is its item
// "/N/data", a GwyDataField, with "/N/data/title" and "/N/mask" beside it. Described in the chapter
// "Gwyddion File Format" of Gwyddion's user guide.
#include "evaluation/readers/gwy_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "brdf/error.h"
#include "evaluation/lengths.h"
#include "evaluation/readers/gwy_items.h"
#include "evaluation/readers/samples.h"
#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

using brdf::Length;

constexpr std::string_view magic = "GWYP";
constexpr std::size_t most_channels = 4096;

/// A GwyDataField, its numbers still in the file.
struct Field {
  std::int32_t cols = 0, rows = 0;
  std::optional<double> width, height;
  std::string xy_unit, z_unit;
  FileRange data;

  std::uint64_t size() const {
    return static_cast<std::uint64_t>(cols) * static_cast<std::uint64_t>(rows);
  }
};

/// What stands in the container under one number.
struct Channel {
  std::optional<FileRange> field, mask;
  FileRange title;
};

std::string unit_of(const FileSource& source, FileRange si_unit) {
  GwyItems items(source, si_unit);
  while (const auto item = items.next())
    if (item->key == "unitstr" && item->type == 's') return gwy_name(source, item->value);
  return {};
}

template <class Number>
Number number_at(const FileSource& source, FileRange place) {
  return stored_number<Number>(source.bytes_of(place).data());
}

Field field_of(const FileSource& source, FileRange object) {
  Field field;
  GwyItems items(source, object);
  while (const auto item = items.next()) {
    const auto is = [&](std::string_view key, char type) {
      return item->key == key && item->type == type;
    };
    if (is("xres", 'i')) field.cols = number_at<std::int32_t>(source, item->value);
    if (is("yres", 'i')) field.rows = number_at<std::int32_t>(source, item->value);
    if (is("xreal", 'd')) field.width = number_at<double>(source, item->value);
    if (is("yreal", 'd')) field.height = number_at<double>(source, item->value);
    if (is("si_unit_xy", 'o')) field.xy_unit = unit_of(source, item->value);
    if (is("si_unit_z", 'o')) field.z_unit = unit_of(source, item->value);
    if (is("data", 'D')) field.data = item->value;
  }
  return field;
}

/// Holds the size against the limit and against the numbers that are there.
void require_whole(const Field& field, const HeightRequest& request, const std::string& name) {
  if (field.cols < 0 || field.rows < 0)
    refuse_gwy(name, std::to_string(field.cols) + " x " + std::to_string(field.rows) + " pixels");
  require_grid(static_cast<std::uint64_t>(field.cols), static_cast<std::uint64_t>(field.rows),
               request, name);
  if (field.data.size != sizeof(double) * field.size())
    refuse_gwy(name, std::to_string(field.data.size / sizeof(double)) + " numbers, " +
                         std::to_string(field.cols) + " x " + std::to_string(field.rows) +
                         " pixels need " + std::to_string(field.size()));
}

/// Shows each number of a field with its place, a piece of the file at a time.
template <class Show>
void visit(const FileSource& source, const Field& field, Show show) {
  constexpr std::uint64_t piece = 8192;
  for (std::uint64_t first = 0; first < field.size(); first += piece) {
    const std::uint64_t count = std::min(piece, field.size() - first);
    const std::string bytes =
        source.bytes_of({field.data.begin + sizeof(double) * first, sizeof(double) * count});
    for (std::uint64_t i = 0; i < count; ++i)
      show(first + i, stored_number<double>(bytes.data() + sizeof(double) * i));
  }
}

/// By their numbers in the container. Masks and titles without a field are left out.
std::vector<Channel> channels_of(const FileSource& source) {
  const std::string& name = source.name();
  GwyItems file(source, {magic.size(), source.size() - magic.size()});
  const GwyItem container = file.object();
  if (container.object != "GwyContainer")
    refuse_gwy(name, "holds a " + container.object.substr(0, 40) + ", no GwyContainer");
  if (!file.at_end()) refuse_gwy(name, "bytes follow the container");
  std::map<std::uint32_t, Channel> by_number;
  GwyItems items(source, container.value);
  while (const auto item = items.next()) {
    const std::string_view key = item->key;
    if (!key.starts_with('/')) continue;
    std::uint32_t number = 0;
    const auto [after, ec] = std::from_chars(key.data() + 1, key.data() + key.size(), number);
    if (ec != std::errc{}) continue;
    const std::string_view rest(after, static_cast<std::size_t>(key.end() - after));
    const bool is_field = item->type == 'o' && item->object == "GwyDataField";
    if (rest == "/data" && is_field) by_number[number].field = item->value;
    if (rest == "/mask" && is_field) by_number[number].mask = item->value;
    if (rest == "/data/title" && item->type == 's') by_number[number].title = item->value;
    if (by_number.size() > most_channels)
      refuse_gwy(name, "more than " + std::to_string(most_channels) + " channels");
  }
  std::vector<Channel> channels;
  for (const auto& [number, channel] : by_number)
    if (channel.field) channels.push_back(channel);
  return channels;
}

std::optional<Length> pixel(const std::optional<double>& side, const std::string& unit,
                            std::int32_t count, const std::string& name) {
  const std::optional<Length> one = length_unit(unit);
  if (!side || !one) return std::nullopt;
  if (!(*side > 0 && std::isfinite(*side)))
    refuse_gwy(name, "a side is " + brdf::text(*side) + " " + unit + ", must be > 0");
  return Length::um(*side * one->um() / count);
}

void require_mask(const Field& mask, const Field& field, const HeightRequest& request,
                  const std::string& name) {
  require_whole(mask, request, name);
  if (mask.cols != field.cols || mask.rows != field.rows)
    refuse_gwy(name, "the mask has " + std::to_string(mask.cols) + " x " +
                         std::to_string(mask.rows) + " pixels, the channel " +
                         std::to_string(field.cols) + " x " + std::to_string(field.rows));
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
    fields.push_back(field_of(source, *channel.field));
    raw.channels.push_back({gwy_name(source, channel.title), fields.back().z_unit});
  }
  const std::size_t chosen = chosen_channel(raw.channels, request.channel, name);
  const Field& field = fields[chosen];
  require_whole(field, request, name);

  raw.format = "Gwyddion native, 64 bit float";
  raw.channel = raw.channels[chosen].title;
  raw.unit = length_unit(field.z_unit);
  raw.unit_name = field.z_unit;
  raw.pixel_x = pixel(field.width, field.xy_unit, field.cols, name);
  raw.pixel_y = pixel(field.height, field.xy_unit, field.rows, name);
  std::optional<Field> mask;
  if (channels[chosen].mask) {
    mask = field_of(source, *channels[chosen].mask);
    require_mask(*mask, field, request, name);
  }
  raw.values.resize(field.rows, field.cols);
  visit(source, field, [&](std::uint64_t i, double height) { raw.values.data()[i] = height; });
  if (mask)
    visit(source, *mask, [&](std::uint64_t i, double masked) {
      if (masked > 0) raw.values.data()[i] = std::numeric_limits<double>::quiet_NaN();
    });
  raw.step = step_of_doubles(raw.values);
  return raw;
}

}  // namespace evaluation::detail
