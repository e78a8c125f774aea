#include "evaluation/hemisphere.h"

#include <cmath>
#include <string>

#include "evaluation/pixel_blocks.h"

namespace evaluation {

Hemisphere::Hemisphere(int size) : size_(size) {
  if (size < 2)
    throw brdf::Error(brdf::Errc::invalid_argument,
                      "a map of " + std::to_string(size) + " pixels a side: must be >= 2");
  in_blocks(size, size, [&](int column, int row) {
    if (direction(column, row)) pixels_.push_back({column, row});
  });
}

std::optional<brdf::Direction> Hemisphere::direction(int column, int row) const {
  const double x = (2.0 * column + 1) / size_ - 1, y = (2.0 * row + 1) / size_ - 1;
  const double cosine_squared = 1 - x * x - y * y;
  if (!(cosine_squared > 0)) return std::nullopt;
  return brdf::Direction(x, y, std::sqrt(cosine_squared));
}

}  // namespace evaluation
