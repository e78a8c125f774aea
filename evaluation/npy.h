// NumPy's NPY format: a header that says type and shape, then the numbers.
#pragma once

#include <complex>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace evaluation {

/// Element types that are written and read, little-endian, the last index running fastest.
enum class NpyType {
  real,           ///< "<f8"
  complex_value,  ///< "<c16"
};

struct NpyShape {
  NpyType type;
  std::vector<std::size_t> extents;
};

/// What stands before the numbers (format version 1.0), a multiple of 64 bytes.
std::string npy_header(const NpyShape& shape);

/// The bytes of numbers as they follow a header.
std::string_view npy_bytes(std::span<const double> numbers);
std::string_view npy_bytes(std::span<const std::complex<double>> numbers);

/// An NPY file: its shape, its numbers (two for a complex one), the SHA-256 of the file.
struct NpyFile {
  NpyShape shape;
  std::vector<double> numbers;
  std::string sha256;
};

/// Reads a whole file. The shape is held against the size of the file before memory is taken.
///
/// Throws Errc::bad_input naming the file: missing, not NPY 1.0, another type or order, a shape
/// that does not match the size, a number that is not finite; Errc::over_limit: more than
/// `limit_bytes`.
NpyFile read_npy(const std::filesystem::path& path, std::size_t limit_bytes);

}  // namespace evaluation
