#include "evaluation/readers/sdf_header.h"

#include <charconv>
#include <cmath>
#include <map>

#include "brdf/error.h"
#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

[[noreturn]] void refuse(const FileSource& source, const std::string& what) {
  throw brdf::Error(brdf::Errc::bad_input, source.name() + ": SDF: " + what);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

/// The lines "Key = value" up to the one that holds a star; comments run from ";" to the end.
class TextFields {
 public:
  explicit TextFields(const FileSource& source) : source_(source) {
    const std::string_view head = source.head();
    for (std::size_t at = head.find('\n') + 1; at != 0; at = head.find('\n', at) + 1) {
      const std::size_t end = head.find('\n', at);
      if (end == std::string_view::npos) break;
      std::string_view line = head.substr(at, end - at);
      line = trimmed(line.substr(0, line.find(';')));
      if (line == "*") {
        size_ = end + 1;
        return;
      }
      const std::size_t equals = line.find('=');
      if (!line.empty() && equals == std::string_view::npos)
        refuse(source, "header line \"" + std::string(line.substr(0, 40)) + "\" has no \"=\"");
      if (!line.empty())
        values_[std::string(trimmed(line.substr(0, equals)))] = trimmed(line.substr(equals + 1));
    }
    refuse(source,
           "header does not end with \"*\" within " + std::to_string(head.size()) + " bytes");
  }

  std::uint64_t size() const { return size_; }

  template <class T>
  T number(const std::string& key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) refuse(source_, "header has no " + key);
    const std::string_view text = found->second;
    T value{};
    const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (ec != std::errc{} || end != text.data() + text.size())
      refuse(source_, key + " is \"" + std::string(text.substr(0, 40)) + "\", not a number");
    return value;
  }

 private:
  const FileSource& source_;
  std::uint64_t size_ = 0;
  std::map<std::string, std::string_view> values_;
};

SdfHeader text_header(const FileSource& source) {
  const TextFields fields(source);
  return {fields.number<std::uint64_t>("NumPoints"),
          fields.number<std::uint64_t>("NumProfiles"),
          fields.number<double>("Xscale"),
          fields.number<double>("Yscale"),
          fields.number<double>("Zscale"),
          fields.number<std::uint64_t>("Compression"),
          fields.number<std::uint64_t>("DataType"),
          fields.number<std::uint64_t>("CheckType"),
          fields.size()};
}

/// Fields of fixed width, one after the other.
class BinaryFields {
 public:
  explicit BinaryFields(const FileSource& source) : source_(source) {}

  void skip(std::size_t count) { at_ += count; }
  std::uint64_t size() const { return at_; }

  template <class T>
  T next() {
    if (source_.head().size() < at_ + sizeof(T))
      refuse(source_, "header does not end; file is truncated");
    at_ += sizeof(T);
    return stored_number<T>(source_.head().data() + at_ - sizeof(T));
  }
  /// ISO 25178-71 widens the counts in its version 2.
  std::uint64_t next_count() {
    return source_.head().starts_with("bISO-2") ? next<std::uint32_t>() : next<std::uint16_t>();
  }

 private:
  const FileSource& source_;
  std::size_t at_ = 0;
};

SdfHeader binary_header(const FileSource& source) {
  BinaryFields fields(source);
  fields.skip(8 + 10 + 12 + 12);  // version, maker, dates of creation and change
  SdfHeader header;
  header.cols = fields.next_count();
  header.rows = fields.next_count();
  header.x_scale_m = fields.next<double>();
  header.y_scale_m = fields.next<double>();
  header.z_scale_m = fields.next<double>();
  fields.skip(sizeof(double));  // resolution, for people
  header.compression = fields.next<std::uint8_t>();
  header.data_type = fields.next<std::uint8_t>();
  header.check_type = fields.next<std::uint8_t>();
  header.size = fields.size();
  return header;
}

}  // namespace

bool is_sdf_text(std::string_view head) {
  return head.starts_with('a');
}

SdfHeader read_sdf_header(const FileSource& source) {
  const SdfHeader header = is_sdf_text(source.head()) ? text_header(source) : binary_header(source);
  for (const auto& [key, scale] :
       {std::pair{"Xscale", header.x_scale_m}, std::pair{"Yscale", header.y_scale_m},
        std::pair{"Zscale", header.z_scale_m}})
    if (!(scale > 0 && std::isfinite(scale)))
      refuse(source, std::string(key) + " is " + brdf::text(scale) + " m, must be > 0");
  for (const auto& [key, code] :
       {std::pair{"Compression", header.compression}, std::pair{"CheckType", header.check_type}})
    if (code != 0)
      refuse(source, std::string(key) + " " + std::to_string(code) + ", only 0 is read");
  return header;
}

}  // namespace evaluation::detail
