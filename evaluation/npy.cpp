#include "evaluation/npy.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "brdf/error.h"
#include "evaluation/npy_header.h"
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

/// Up to `most` bytes; fewer where the file is shorter or cannot be read.
std::string beginning_of(const fs::path& path, std::size_t most) {
  std::string bytes(most, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

}  // namespace

bool is_npy(const fs::path& path) {
  return begins_as_npy(beginning_of(path, prefix_size));
}

bool is_baked(const fs::path& path) {
  const std::string head = beginning_of(path, 2 * max_npy_header);
  if (!begins_as_npy(head)) return false;
  try {
    return read_npy_header(head, path.string()).extents.size() != 2;
  } catch (const brdf::Error&) {
    return true;  // to be refused as what it begins like
  }
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
  head_ = beginning_of(path, 2 * max_npy_header);
  const NpyHeader header = read_npy_header(head_, path.string());
  head_.resize(header.size);
  const auto known = std::find_if(std::begin(types), std::end(types),
                                  [&](const TypeRow& row) { return header.type == row.name; });
  if (known == std::end(types))
    refuse("NPY type '" + header.type.substr(0, 40) + "', must be '<f4', '<f8' or '<c16'");
  shape_.type = known->type;
  if (header.is_fortran_order) refuse("NPY must be in C order");
  shape_.extents = header.extents;
  const auto bytes = header.number_bytes(known->numbers * known->number_bytes);
  if (!bytes || size - head_.size() != *bytes)
    refuse("NPY shape " + header.shape + " does not match its " + std::to_string(size) + " bytes");
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
