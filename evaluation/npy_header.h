// What stands before the numbers of an NPY file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace evaluation {

/// The header of an NPY file, of any type and order.
struct NpyHeader {
  std::string type;               ///< NumPy's name, e.g. "<f8"; of structured types the beginning
  bool is_fortran_order = false;  ///< the first index runs fastest
  std::string shape;              ///< as it is written, e.g. "(2, 3)"
  std::vector<std::size_t> extents;
  std::size_t size = 0;  ///< bytes up to the numbers

  /// Bytes of the numbers, each of that many; empty where they overflow.
  std::optional<std::size_t> number_bytes(std::size_t each) const;
};

/// Longer headers are refused; NumPy writes 118 bytes for two axes.
inline constexpr std::size_t max_npy_header = 1 << 15;

/// Whether bytes begin as NPY does.
bool begins_as_npy(std::string_view head);

/// The header at the beginning of `head`, which holds the file or at least
/// twice `max_npy_header` bytes of it.
/// Format versions 1 to 3. Throws Errc::bad_input: "NAME: " and what is wrong.
NpyHeader read_npy_header(std::string_view head, const std::string& name);

}  // namespace evaluation
