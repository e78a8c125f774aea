#include "evaluation/readers/point_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace evaluation::detail {
namespace {

using Index = Eigen::Index;

/// Gwyddion's xyzexport keeps five digits: half a unit of the last of 99999 on 10^4 columns is
/// 0.05.
constexpr double largest_offset = 0.1;

/// Nodes along a line.
struct Nodes {
  double first = 0, pitch = 0;
  std::uint64_t count = 1;

  double place(double coordinate) const { return (coordinate - first) / pitch; }
};

/// The widest gap between neighbouring coordinates is the pitch, half of it parts two nodes.
Nodes nodes_of(const brdf::HeightArray& points, Index column) {
  std::vector<double> sorted(static_cast<std::size_t>(points.rows()));
  for (Index i = 0; i < points.rows(); ++i) sorted[static_cast<std::size_t>(i)] = points(i, column);
  std::sort(sorted.begin(), sorted.end());
  double widest = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    widest = std::max(widest, sorted[i] - sorted[i - 1]);
  Nodes nodes{sorted.front()};
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i] - sorted[i - 1] > widest / 2) ++nodes.count;
  if (nodes.count > 1)
    nodes.pitch = (sorted.back() - sorted.front()) / static_cast<double>(nodes.count - 1);
  return nodes;
}

std::string point_name(const brdf::HeightArray& points, Index i) {
  return "point " + std::to_string(i + 1) + " at x = " + brdf::text(points(i, 0)) +
         ", y = " + brdf::text(points(i, 1));
}

}  // namespace

PointGrid grid_of(const brdf::HeightArray& points, std::uint64_t max_nodes) {
  PointGrid grid;
  for (Index i = 0; i < points.rows(); ++i)
    if (!std::isfinite(points(i, 0)) || !std::isfinite(points(i, 1))) {
      grid.problem = point_name(points, i) + " has no place";
      return grid;
    }
  const Nodes x = nodes_of(points, 0), y = nodes_of(points, 1);
  for (Index i = 0; i < points.rows(); ++i)
    for (const auto& [nodes, column] : {std::pair(x, 0), std::pair(y, 1)}) {
      const double place = nodes.place(points(i, column));
      if (nodes.count > 1 && std::abs(place - std::round(place)) > largest_offset) {
        grid.problem = point_name(points, i) + " lies on no regular grid";
        return grid;
      }
    }
  const auto size = std::to_string(x.count) + " x " + std::to_string(y.count) + " nodes";
  if (x.count < 2 || y.count < 2) {
    grid.problem = "the points span " + size + ", at least 2 x 2 are needed";
    return grid;
  }
  grid.nodes = x.count * y.count;  // at most 2^56: there are no more of either than points
  if (grid.nodes > max_nodes || grid.nodes / 2 > static_cast<std::uint64_t>(points.rows())) {
    grid.problem = std::to_string(points.rows()) + " points on a grid of " + size +
                   ", at least half of which and at most " + std::to_string(max_nodes) +
                   " are read";
    return grid;
  }
  grid.dx = x.pitch;
  grid.dy = y.pitch;
  grid.heights.setConstant(static_cast<Index>(y.count), static_cast<Index>(x.count),
                           std::numeric_limits<double>::quiet_NaN());
  std::vector<bool> taken(grid.nodes);
  for (Index i = 0; i < points.rows(); ++i) {
    const auto row = static_cast<Index>(std::round(y.place(points(i, 1))));
    const auto col = static_cast<Index>(std::round(x.place(points(i, 0))));
    const auto node = static_cast<std::size_t>(row * grid.heights.cols() + col);
    if (taken[node]) {
      grid.problem = point_name(points, i) + " is there twice";
      return grid;
    }
    taken[node] = true;
    grid.heights(row, col) = points(i, 2);
  }
  return grid;
}

}  // namespace evaluation::detail
