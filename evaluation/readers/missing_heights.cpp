#include "evaluation/readers/missing_heights.h"

#include <cmath>
#include <vector>

#include "brdf/error.h"

namespace evaluation {
namespace {

using Index = Eigen::Index;

struct Pixel {
  Index row, col;
};

std::vector<Pixel> missing_in(const brdf::HeightArray& heights) {
  std::vector<Pixel> missing;
  for (Index row = 0; row < heights.rows(); ++row)
    for (Index col = 0; col < heights.cols(); ++col)
      if (std::isnan(heights(row, col))) missing.push_back({row, col});
  return missing;
}

/// NaN where no neighbour has a height.
double mean_of_neighbours(const brdf::HeightArray& heights, Pixel pixel) {
  double sum = 0;
  int count = 0;
  for (Index row = pixel.row - 1; row <= pixel.row + 1; ++row)
    for (Index col = pixel.col - 1; col <= pixel.col + 1; ++col) {
      if (row < 0 || col < 0 || row >= heights.rows() || col >= heights.cols()) continue;
      if (std::isnan(heights(row, col))) continue;
      sum += heights(row, col);
      ++count;
    }
  return sum / count;
}

}  // namespace

std::size_t fill_missing(brdf::HeightArray& heights, MissingHeights policy,
                         const std::string& name) {
  std::vector<Pixel> missing = missing_in(heights);
  const std::size_t count = missing.size();
  if (count == 0) return 0;
  const auto refuse = [&](const std::string& what) {
    throw brdf::Error(brdf::Errc::bad_input, name + ": " + what);
  };
  if (policy == MissingHeights::refuse)
    refuse(std::to_string(count) + " of " + std::to_string(heights.size()) +
           " pixels have no finite height (masked or not a number), the first at row " +
           std::to_string(missing.front().row) + ", column " + std::to_string(missing.front().col) +
           "; --missing neighbours fills them");
  if (count == static_cast<std::size_t>(heights.size())) refuse("no pixel has a height");
  while (!missing.empty()) {
    std::vector<Pixel> left;
    std::vector<std::pair<Pixel, double>> ring;
    for (const Pixel pixel : missing) {
      const double mean = mean_of_neighbours(heights, pixel);
      if (std::isnan(mean))
        left.push_back(pixel);
      else
        ring.emplace_back(pixel, mean);
    }
    for (const auto& [pixel, height] : ring) heights(pixel.row, pixel.col) = height;
    // Infinite neighbours of both signs have no mean; the height field refuses them by place.
    if (ring.empty()) break;
    missing = std::move(left);
  }
  return count;
}

}  // namespace evaluation
