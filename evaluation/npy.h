// NumPy's NPY format: a header that says type and shape, then the numbers.
#pragma once

#include <complex>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace evaluation {

/// Element types that are written and read, little-endian, the last index running fastest.
enum class NpyType {
  single,         ///< "<f4"
  real,           ///< "<f8"
  complex_value,  ///< "<c16"
};

struct NpyShape {
  NpyType type;
  std::vector<std::size_t> extents;
};

/// Whether a file begins as NPY does; no for one that cannot be read.
bool is_npy(const std::filesystem::path& path);

/// Whether a file is NPY of any shape but two axes, which are heights: tables, maps, or a volume of
/// colours, of which only the sidecar tells what it is.
bool is_baked(const std::filesystem::path& path);

/// What stands before the numbers (format version 1.0), a multiple of 64 bytes.
std::string npy_header(const NpyShape& shape);

/// The bytes of numbers as they follow a header.
std::string_view npy_bytes(std::span<const float> numbers);
std::string_view npy_bytes(std::span<const double> numbers);
std::string_view npy_bytes(std::span<const std::complex<double>> numbers);

/// An NPY file of which the numbers are read piece by piece. It stays open: another file renamed
/// over it changes nothing. One object serves one thread.
class NpyReader {
 public:
  /// Reads the header and holds its shape against the size of the file. Throws Errc::bad_input
  /// naming the file: missing, not NPY 1.0 to 3.0, another type or order, a shape that does not
  /// match.
  explicit NpyReader(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  const NpyShape& shape() const { return shape_; }
  /// Numbers in the file, two for a complex one.
  std::size_t size() const { return size_; }
  /// The numbers from `first` on, float or double as they are in the file. Throws Errc::bad_input:
  /// of the other type, cut off, a number that is not finite.
  template <class Real>
  void read(std::size_t first, std::span<Real> numbers) const;
  /// Of the whole file. Throws Errc::bad_input where it is cut off.
  std::string sha256() const;

 private:
  void read_bytes(std::size_t at, char* bytes, std::size_t count) const;
  [[noreturn]] void refuse(const std::string& what) const;

  std::filesystem::path path_;
  mutable std::ifstream file_;
  std::string head_;
  NpyShape shape_;
  std::size_t size_ = 0, number_bytes_ = 0;
};

/// An NPY file: its shape, its numbers (two for a complex one), the SHA-256 of the file.
struct NpyFile {
  NpyShape shape;
  std::vector<double> numbers;
  std::string sha256;
};

/// Reads a whole file. The shape is held against the size of the file before memory is taken.
///
/// Throws as NpyReader, and Errc::over_limit for more than `limit_bytes`.
NpyFile read_npy(const std::filesystem::path& path, std::size_t limit_bytes);

}  // namespace evaluation
