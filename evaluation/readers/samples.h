// Numbers as files store them.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "brdf/height_field.h"

namespace evaluation::detail {

/// The number at `bytes` in the order of this machine.
template <class T>
T native(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// The number at `bytes`, its least significant byte first.
template <class T>
T little_endian(const char* bytes) {
  char ordered[sizeof(T)];
  std::memcpy(ordered, bytes, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(ordered, ordered + sizeof(T));
  return native<T>(ordered);
}

/// Distance of neighbouring floating-point numbers at the largest finite value of an array;
/// `epsilon` is that distance at 1.
inline double step_at_largest(const brdf::HeightArray& values, double epsilon) {
  double largest = 0;
  for (const double value : values.reshaped())
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest * epsilon;
}

inline double step_of_doubles(const brdf::HeightArray& values) {
  return step_at_largest(values, std::numeric_limits<double>::epsilon());
}

}  // namespace evaluation::detail
