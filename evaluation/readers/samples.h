// How far apart neighbouring stored heights are.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "brdf/height_field.h"

namespace evaluation::detail {

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

/// Of the numbers of a file, by their type (`is_integer`, `bytes`); nothing for single precision,
/// which is what a reader is taken for.
template <class NumberType>
std::optional<double> step_of(const NumberType& type, const brdf::HeightArray& values) {
  if (type.is_integer) return 1;
  if (type.bytes == sizeof(double)) return step_of_doubles(values);
  return std::nullopt;
}

}  // namespace evaluation::detail
