// Numbers as they lie in a file.
#pragma once

#include <algorithm>
#include <array>
#include <bit>

namespace evaluation {

/// The number whose bytes begin at `bytes`, in the order of the file.
template <class Number>
Number stored_number(const char* bytes, std::endian order = std::endian::little) {
  std::array<char, sizeof(Number)> own;
  std::copy_n(bytes, own.size(), own.begin());
  if (order != std::endian::native) std::reverse(own.begin(), own.end());
  return std::bit_cast<Number>(own);
}

}  // namespace evaluation
