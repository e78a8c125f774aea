#include "evaluation/readers/gwy_items.h"

#include <algorithm>
#include <utility>

#include "brdf/error.h"
#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

constexpr std::size_t window_bytes = 1 << 16;

/// Of a value without a length of its own; 0 for strings, objects and arrays.
std::uint64_t fixed_size(char type) {
  switch (type) {
    case 'b':
    case 'c':
      return 1;
    case 'i':
      return 4;
    case 'q':
    case 'd':
      return 8;
    default:
      return 0;
  }
}

void require_short(const FileSource& source, FileRange name) {
  if (name.size > longest_name)
    refuse_gwy(source.name(), "a name has " + std::to_string(name.size) +
                                  " bytes, must be at most " + std::to_string(longest_name));
}

char element_type(char array) {
  constexpr std::string_view arrays = "CIQDSO", elements = "ciqdso";
  const std::size_t at = arrays.find(array);
  return at == std::string_view::npos ? '\0' : elements[at];
}

}  // namespace

std::optional<GwyItem> GwyItems::next() {
  if (at_end()) return std::nullopt;
  GwyItem item{};
  item.key = name();
  item.type = character();
  if (item.type == 'o') {
    GwyItem inner = object();
    item.object = std::move(inner.object);
    item.value = inner.value;
  } else {
    item.value = value(item.type);
  }
  return item;
}

GwyItem GwyItems::object() {
  GwyItem item{};
  item.type = 'o';
  item.object = name();
  item.value = take(count());
  return item;
}

FileRange GwyItems::value(char type) {
  if (const std::uint64_t size = fixed_size(type)) return take(size);
  if (type == 's') return text(longest_text);
  const char element = element_type(type);
  if (element == '\0') refuse("an item has the unknown type '" + std::string(1, type) + "'");
  const std::uint64_t many = count();
  if (const std::uint64_t size = fixed_size(element)) return take(many * size);
  const std::uint64_t begin = at_;
  for (std::uint64_t i = 0; i < many; ++i) element == 's' ? text(longest_text) : object().value;
  return {begin, at_ - begin};
}

std::string_view GwyItems::at_hand(std::uint64_t at, std::size_t least) {
  least = std::min<std::uint64_t>(least, end_ - at);
  if (at < window_at_ || window_at_ + window_.size() < at + least || window_.empty()) {
    window_.resize(std::min<std::uint64_t>(window_bytes, end_ - at));
    source_.read_at(at, window_.data(), window_.size());
    window_at_ = at;
  }
  return std::string_view(window_).substr(at - window_at_, end_ - at);
}

FileRange GwyItems::take(std::uint64_t count) {
  if (count > end_ - at_)
    refuse(std::to_string(count) + " bytes are said to follow where " + std::to_string(end_ - at_) +
           " are left; file is truncated or damaged");
  at_ += count;
  return {at_ - count, count};
}

char GwyItems::character() {
  const FileRange one = take(1);
  return at_hand(one.begin, 1)[0];
}

std::uint32_t GwyItems::count() {
  const FileRange number = take(sizeof(std::uint32_t));
  return stored_number<std::uint32_t>(at_hand(number.begin, number.size).data());
}

FileRange GwyItems::text(std::uint64_t longest) {
  const std::uint64_t begin = at_;
  for (std::uint64_t at = at_; at < end_;) {
    if (at - begin > longest) refuse("a text is longer than " + std::to_string(longest) + " bytes");
    const std::string_view bytes = at_hand(at, 1);
    const std::size_t end = bytes.find('\0');
    if (end != std::string_view::npos) {
      at_ = at + end + 1;
      return {begin, at + end - begin};
    }
    at += bytes.size();
  }
  refuse("a text does not end; file is truncated or damaged");
}

std::string GwyItems::name() {
  const FileRange range = text(longest_name);
  require_short(source_, range);
  return std::string(at_hand(range.begin, range.size).substr(0, range.size));
}

void GwyItems::refuse(const std::string& what) const {
  refuse_gwy(source_.name(), what);
}

std::string gwy_name(const FileSource& source, FileRange name) {
  require_short(source, name);
  return source.bytes_of(name);
}

void refuse_gwy(const std::string& name, const std::string& what) {
  throw brdf::Error(brdf::Errc::bad_input, name + ": GWY: " + what);
}

}  // namespace evaluation::detail
