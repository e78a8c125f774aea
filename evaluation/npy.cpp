#include "evaluation/npy.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "brdf/error.h"
#include "evaluation/sha256.h"

namespace evaluation {
namespace {

namespace fs = std::filesystem;
using brdf::Errc;

static_assert(std::endian::native == std::endian::little, "NPY is written as it lies in memory");

constexpr std::string_view magic{"\x93NUMPY\x01\x00", 8};
constexpr std::size_t prefix_size = magic.size() + 2;  // and the length of the header
constexpr std::size_t alignment = 64;

struct TypeRow {
  NpyType type;
  std::string_view name;
  std::size_t numbers, number_bytes;
};
constexpr TypeRow types[] = {{NpyType::single, "<f4", 1, sizeof(float)},
                             {NpyType::real, "<f8", 1, sizeof(double)},
                             {NpyType::complex_value, "<c16", 2, sizeof(double)}};

const TypeRow& row_of(NpyType type) {
  return *std::find_if(std::begin(types), std::end(types),
                       [type](const TypeRow& row) { return row.type == type; });
}

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

/// The extents of "(30, 650, 326)"; empty for anything else, or where their product overflows.
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

std::optional<std::size_t> product(const std::vector<std::size_t>& extents, std::size_t each) {
  std::size_t all = each;
  for (const std::size_t extent : extents) {
    if (extent != 0 && all > std::numeric_limits<std::size_t>::max() / extent) return std::nullopt;
    all *= extent;
  }
  return all;
}

}  // namespace

bool is_npy(const fs::path& path) {
  constexpr std::size_t named = 6;  // without the version
  char head[named] = {};
  std::ifstream(path, std::ios::binary).read(head, named);
  return std::string_view(head, named) == magic.substr(0, named);
}

std::string npy_header(const NpyShape& shape) {
  std::string extents;
  for (const std::size_t extent : shape.extents) extents += std::to_string(extent) + ", ";
  if (shape.extents.size() > 1) extents.erase(extents.size() - 2);
  std::string header = "{'descr': '" + std::string(row_of(shape.type).name) +
                       "', 'fortran_order': False, 'shape': (" + extents + "), }";
  const std::size_t unpadded = prefix_size + header.size() + 1;
  header.append((alignment - unpadded % alignment) % alignment, ' ');
  header += '\n';
  std::string bytes(magic);
  bytes += static_cast<char>(header.size() & 255);
  bytes += static_cast<char>(header.size() >> 8);
  return bytes + header;
}

std::string_view npy_bytes(std::span<const float> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

std::string_view npy_bytes(std::span<const double> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

std::string_view npy_bytes(std::span<const std::complex<double>> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

NpyReader::NpyReader(const fs::path& path) : path_(path) {
  std::error_code ec;
  if (!fs::exists(path, ec)) refuse("no such file");
  if (!fs::is_regular_file(path, ec)) refuse("is not a regular file");
  const std::uintmax_t size = fs::file_size(path, ec);
  if (ec) refuse("cannot be read: " + ec.message());
  file_.open(path, std::ios::binary);
  std::string prefix(prefix_size, '\0');
  if (!file_.read(prefix.data(), static_cast<std::streamsize>(prefix_size)) ||
      !prefix.starts_with(magic))
    refuse("is not NPY, format version 1.0");
  const std::size_t header_size = static_cast<unsigned char>(prefix[magic.size()]) +
                                  256u * static_cast<unsigned char>(prefix[magic.size() + 1]);
  std::string header(header_size, '\0');
  if (!file_.read(header.data(), static_cast<std::streamsize>(header_size)))
    refuse("NPY header is cut off");
  head_ = prefix + header;

  const auto descr = value_of(header, "descr");
  const auto known = std::find_if(std::begin(types), std::end(types), [&](const TypeRow& row) {
    return descr && descr->size() == row.name.size() + 2 &&
           descr->substr(1, row.name.size()) == row.name;
  });
  if (known == std::end(types))
    refuse("NPY type " + std::string(descr.value_or("missing")) +
           ", must be '<f4', '<f8' or '<c16'");
  shape_.type = known->type;
  if (value_of(header, "fortran_order") != "False") refuse("NPY must be in C order");
  const auto extents = extents_of(value_of(header, "shape").value_or(""));
  if (!extents) refuse("NPY shape is not a tuple of whole numbers");
  shape_.extents = *extents;
  const auto bytes = product(*extents, known->numbers * known->number_bytes);
  if (!bytes || size - head_.size() != *bytes)
    refuse("NPY shape " + std::string(*value_of(header, "shape")) + " does not match its " +
           std::to_string(size) + " bytes");
  number_bytes_ = known->number_bytes;
  size_ = *bytes / number_bytes_;
}

template <class Real>
void NpyReader::read(std::size_t first, std::span<Real> numbers) const {
  if (number_bytes_ != sizeof(Real))
    refuse("holds numbers of " + std::to_string(number_bytes_) + " bytes, not " +
           std::to_string(sizeof(Real)));
  read_bytes(head_.size() + first * sizeof(Real), reinterpret_cast<char*>(numbers.data()),
             numbers.size_bytes());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!std::isfinite(numbers[i]))
      refuse("number " + std::to_string(first + i) + " is not finite");
}

template void NpyReader::read(std::size_t, std::span<float>) const;
template void NpyReader::read(std::size_t, std::span<double>) const;

std::string NpyReader::sha256() const {
  Sha256 hash;
  hash.update(head_);
  std::string piece(std::size_t{1} << 20, '\0');
  const std::size_t end = head_.size() + size_ * number_bytes_;
  for (std::size_t at = head_.size(); at < end; at += piece.size()) {
    piece.resize(std::min(piece.size(), end - at));
    read_bytes(at, piece.data(), piece.size());
    hash.update(piece);
  }
  return hash.hex();
}

void NpyReader::read_bytes(std::size_t at, char* bytes, std::size_t count) const {
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(at));
  if (!file_.read(bytes, static_cast<std::streamsize>(count))) refuse("cannot be read");
}

void NpyReader::refuse(const std::string& what) const {
  throw brdf::Error(Errc::bad_input, path_.string() + ": " + what);
}

NpyFile read_npy(const fs::path& path, std::size_t limit_bytes) {
  const NpyReader reader(path);
  if (reader.size() > limit_bytes / sizeof(double))
    throw brdf::Error(Errc::over_limit,
                      path.string() + ": " + std::to_string(reader.size() * sizeof(double)) +
                          " bytes, at most " + std::to_string(limit_bytes) + " are read");
  NpyFile result{reader.shape(), std::vector<double>(reader.size()), {}};
  reader.read(0, std::span(result.numbers));
  result.sha256 = reader.sha256();
  return result;
}

}  // namespace evaluation
