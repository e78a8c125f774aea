// Gwyddion Simple Field: "Gwyddion Simple Field 1.0", lines `Key = value`, one to four NUL bytes up
// to a multiple of four, then rows of 32-bit little-endian floats, the first row first.
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>

#include "brdf/error.h"
#include "evaluation/lengths.h"
#include "evaluation/readers/height_formats.h"
#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

using brdf::Errc;
using brdf::Error;
using brdf::Length;

constexpr std::string_view magic = "Gwyddion Simple Field 1.0\n";

class GsfHeader {
 public:
  GsfHeader(std::string_view lines, const std::string& name) : name_(name) {
    int number = 1;
    while (!lines.empty()) {
      ++number;
      const std::size_t end = lines.find('\n');
      const std::string_view line = lines.substr(0, end);
      lines = end == std::string_view::npos ? std::string_view{} : lines.substr(end + 1);
      const std::size_t equals = line.find('=');
      if (equals == std::string_view::npos)
        refuse("line " + std::to_string(number) + " of the header has no \"=\"");
      values_[std::string(trimmed(line.substr(0, equals)))] = trimmed(line.substr(equals + 1));
    }
  }

  std::uint64_t count(const std::string& key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) refuse("header has no " + key);
    return parsed<std::uint64_t>(key, found->second);
  }

  /// Empty where there is none.
  std::string text(const std::string& key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? "" : std::string(found->second);
  }

  /// A positive length given as a number and a unit on two lines; empty where either is missing.
  std::optional<Length> length(const std::string& key, const std::string& unit_key) const {
    const auto value = values_.find(key);
    const std::optional<Length> one = length_unit(text(unit_key));
    if (value == values_.end() || !one) return std::nullopt;
    const double number = parsed<double>(key, value->second);
    if (!(number > 0 && std::isfinite(number)))
      refuse(key + " is " + std::string(value->second) + ", must be > 0");
    return Length::um(number * one->um());
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(Errc::bad_input, name_ + ": GSF: " + what);
  }

 private:
  static std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r";
    const std::size_t first = text.find_first_not_of(blank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
  }

  template <class T>
  T parsed(const std::string& key, std::string_view text) const {
    T value{};
    const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (ec != std::errc{} || end != text.data() + text.size())
      refuse(key + " is \"" + std::string(text.substr(0, 40)) + "\", not a number");
    return value;
  }

  const std::string& name_;
  std::map<std::string, std::string_view> values_;
};

}  // namespace

bool is_gsf(std::string_view head) {
  return head.starts_with(magic);
}

RawHeights decode_gsf(const FileSource& source, const HeightRequest& request) {
  const std::string& name = source.name();
  const std::size_t header_end = source.head().find('\0');
  if (header_end == std::string_view::npos)
    throw Error(Errc::bad_input, name + (source.size() > FileSource::head_bytes
                                             ? ": GSF: header does not end within " +
                                                   std::to_string(FileSource::head_bytes) + " bytes"
                                             : ": GSF: header does not end; file is truncated"));
  const std::string header_text(source.head().substr(magic.size(), header_end - magic.size()));
  const GsfHeader header(header_text, name);
  const std::uint64_t cols = header.count("XRes"), rows = header.count("YRes");
  require_grid(cols, rows, request, name);

  const std::size_t data = (header_end / 4 + 1) * 4;
  const std::size_t expected = data + 4 * cols * rows;
  if (source.size() != expected)
    header.refuse(std::to_string(source.size()) + " bytes, " + std::to_string(cols) + " x " +
                  std::to_string(rows) + " pixels need " + std::to_string(expected) +
                  (source.size() < expected ? ": file is truncated" : ""));
  const std::string_view bytes = source.bytes();

  RawHeights raw;
  raw.format = "Gwyddion Simple Field, 32 bit float";
  raw.channel = header.text("Title");
  raw.unit_name = header.text("ZUnits");
  raw.unit = length_unit(raw.unit_name);
  const auto pixel = [&](const char* key, std::uint64_t count) -> std::optional<Length> {
    const std::optional<Length> side = header.length(key, "XYUnits");
    if (!side) return std::nullopt;
    return Length::um(side->um() / static_cast<double>(count));
  };
  raw.pixel_x = pixel("XReal", cols);
  raw.pixel_y = pixel("YReal", rows);
  raw.values.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(cols));
  for (Eigen::Index i = 0; i < raw.values.size(); ++i)
    raw.values.data()[i] = static_cast<double>(
        stored_number<float>(bytes.data() + data + 4 * static_cast<std::size_t>(i)));
  return raw;
}

}  // namespace evaluation::detail
