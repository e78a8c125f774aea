#include "evaluation/npy_header.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "brdf/error.h"

namespace evaluation {
namespace {

constexpr std::string_view magic{"\x93NUMPY", 6};

/// The value of a key of the header's Python dictionary, up to the comma or brace behind it.
std::optional<std::string_view> value_of(std::string_view header, std::string_view key) {
  const std::size_t at = header.find(std::string("'").append(key).append("'"));
  if (at == std::string_view::npos) return std::nullopt;
  std::size_t first = header.find(':', at);
  if (first == std::string_view::npos) return std::nullopt;
  first = header.find_first_not_of(' ', first + 1);
  if (first == std::string_view::npos) return std::nullopt;
  const char closing = header[first] == '(' ? ')' : ',';
  const std::size_t last = header.find_first_of(closing == ')' ? ")" : ",}", first);
  if (last == std::string_view::npos) return std::nullopt;
  return header.substr(first, last - first + (closing == ')' ? 1 : 0));
}

/// The extents of "(30, 650, 326)"; empty for anything else, or where one overflows.
std::optional<std::vector<std::size_t>> extents_of(std::string_view text) {
  if (!text.starts_with('(') || !text.ends_with(')')) return std::nullopt;
  std::vector<std::size_t> extents;
  const char *at = text.data() + 1, *end = text.data() + text.size() - 1;
  while (at != end) {
    std::size_t extent = 0;
    const auto [after, ec] = std::from_chars(at, end, extent);
    if (ec != std::errc{}) return std::nullopt;
    extents.push_back(extent);
    at = std::find_if(after, end, [](char c) { return c != ',' && c != ' '; });
  }
  return extents;
}

}  // namespace

std::optional<std::size_t> NpyHeader::number_bytes(std::size_t each) const {
  std::size_t all = each;
  for (const std::size_t extent : extents) {
    if (extent != 0 && all > std::numeric_limits<std::size_t>::max() / extent) return std::nullopt;
    all *= extent;
  }
  return all;
}

bool begins_as_npy(std::string_view head) {
  return head.starts_with(magic);
}

NpyHeader read_npy_header(std::string_view head, const std::string& name) {
  const auto refuse = [&](const std::string& what) {
    throw brdf::Error(brdf::Errc::bad_input, name + ": " + what);
  };
  const std::size_t version_at = magic.size();
  if (!begins_as_npy(head) || head.size() < version_at + 2 || head[version_at] < 1 ||
      head[version_at] > 3 || head[version_at + 1] != 0)
    refuse("is not NPY, format version 1.0, 2.0 or 3.0");
  // Version 1 has two bytes for the length, the others four.
  const std::size_t length_bytes = head[version_at] == 1 ? 2 : 4;
  const std::size_t begin = version_at + 2 + length_bytes;
  std::size_t length = 0;
  for (std::size_t i = begin; i-- > version_at + 2 && head.size() >= begin;)
    length = length << 8 | static_cast<unsigned char>(head[i]);
  if (length > max_npy_header)
    refuse("NPY header of " + std::to_string(length) + " bytes, at most " +
           std::to_string(max_npy_header) + " are read");
  if (head.size() < begin + length) refuse("NPY header is cut off");
  const std::string_view text = head.substr(begin, length);

  NpyHeader header;
  header.size = begin + length;
  header.type = value_of(text, "descr").value_or("missing");
  if (header.type.size() > 2 && header.type.front() == '\'' && header.type.back() == '\'')
    header.type = header.type.substr(1, header.type.size() - 2);
  const std::string_view order = value_of(text, "fortran_order").value_or("missing");
  if (order != "False" && order != "True")
    refuse("NPY fortran_order is " + std::string(order.substr(0, 40)) + ", not True or False");
  header.is_fortran_order = order == "True";
  header.shape = value_of(text, "shape").value_or("");
  const auto extents = extents_of(header.shape);
  if (!extents) refuse("NPY shape is not a tuple of whole numbers");
  header.extents = *extents;
  return header;
}

}  // namespace evaluation
