#include "evaluation/readers/gwy_items.h"

#include "brdf/error.h"
#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

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

char element_type(char array) {
  constexpr std::string_view arrays = "CIQDSO", elements = "ciqdso";
  const std::size_t at = arrays.find(array);
  return at == std::string_view::npos ? '\0' : elements[at];
}

}  // namespace

std::optional<GwyItem> GwyItems::next() {
  if (rest_.empty()) return std::nullopt;
  GwyItem item{};
  item.key = text();
  item.type = take(1)[0];
  if (item.type == 'o') {
    const GwyItem value = object();
    item.object = value.object;
    item.bytes = value.bytes;
  } else {
    item.bytes = value(item.type);
  }
  return item;
}

GwyItem GwyItems::object() {
  GwyItem item{};
  item.type = 'o';
  item.object = text();
  item.bytes = take(count());
  return item;
}

std::string_view GwyItems::value(char type) {
  if (const std::uint64_t size = fixed_size(type)) return take(size);
  if (type == 's') return text();
  const char element = element_type(type);
  if (element == '\0') refuse("an item has the unknown type '" + std::string(1, type) + "'");
  const std::uint64_t many = count();
  if (const std::uint64_t size = fixed_size(element)) return take(many * size);
  const std::string_view before = rest_;
  for (std::uint64_t i = 0; i < many; ++i) element == 's' ? text() : object().bytes;
  return before.substr(0, before.size() - rest_.size());
}

std::string_view GwyItems::take(std::uint64_t count) {
  if (count > rest_.size())
    refuse(std::to_string(count) + " bytes are said to follow where " +
           std::to_string(rest_.size()) + " are left; file is truncated or damaged");
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

std::string_view GwyItems::text() {
  const std::size_t end = rest_.find('\0');
  if (end == std::string_view::npos) refuse("a text does not end; file is truncated or damaged");
  return take(end + 1).substr(0, end);
}

std::uint32_t GwyItems::count() {
  return stored_number<std::uint32_t>(take(4).data());
}

void GwyItems::refuse(const std::string& what) const {
  throw brdf::Error(brdf::Errc::bad_input, name_ + ": GWY: " + what);
}

}  // namespace evaluation::detail
