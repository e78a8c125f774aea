#include "evaluation/hemisphere.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace evaluation {

Hemisphere::Hemisphere(int size) : size_(size) {
  if (size < 2)
    throw brdf::Error(brdf::Errc::invalid_argument,
                      "a map of " + std::to_string(size) + " pixels a side: must be >= 2");
  constexpr int block = 16;
  for (int row0 = 0; row0 < size; row0 += block)
    for (int column0 = 0; column0 < size; column0 += block)
      for (int row = row0; row < std::min(row0 + block, size); ++row)
        for (int column = column0; column < std::min(column0 + block, size); ++column)
          if (direction(column, row)) pixels_.push_back({column, row});
}

std::optional<brdf::Direction> Hemisphere::direction(int column, int row) const {
  const double x = (2.0 * column + 1) / size_ - 1, y = (2.0 * row + 1) / size_ - 1;
  const double cosine_squared = 1 - x * x - y * y;
  if (!(cosine_squared > 0)) return std::nullopt;
  return brdf::Direction(x, y, std::sqrt(cosine_squared));
}

}  // namespace evaluation
