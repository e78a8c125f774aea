// An order of queries in which neighbours read the same part of a table.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "brdf/amplitude.h"

namespace brdf {

/// Where queries read a table along x and y, in grid points.
struct TileGrid {
  struct Axis {
    double grid_per_q_um, first, period, count;
  };
  Axis x, y;
};

/// Tiles along one axis.
class TileAxis {
 public:
  TileAxis(const TileGrid::Axis& axis, double points_per_tile)
      : scale_um_(axis.grid_per_q_um / points_per_tile),
        first_(axis.first / points_per_tile),
        period_(axis.period / points_per_tile),
        per_period_(points_per_tile / axis.period),
        count_(static_cast<long>(axis.count / points_per_tile) + 1) {}

  std::size_t count() const { return static_cast<std::size_t>(count_); }

  /// Rounding may pick a neighbour at an edge; only the order depends on it.
  std::size_t tile(double q_per_um) const {
    const double local = q_per_um * scale_um_ - first_;
    const double turns = static_cast<double>(static_cast<long>(local * per_period_));
    return static_cast<std::size_t>(
        std::clamp(static_cast<long>(local - turns * period_), 0L, count_ - 1));
  }

 private:
  double scale_um_, first_, period_, per_period_;
  long count_;
};

/// Calls gather(queries, amplitudes) for all queries, batch by batch, sorted by tiles of the table;
/// the amplitudes come out in the order of the queries. Few queries are passed on as they are.
template <class Gather>
void in_tile_order(std::span<const Query> queries, std::span<std::complex<double>> amplitudes,
                   const TileGrid& grid, Gather gather) {
  // A tile and its margin fit the first-level cache; fewer queries than this touch each tile once.
  constexpr double tile = 8;
  constexpr std::size_t smallest = 4096, batch = 512;
  // Each slice reads the whole table once more: long ones save memory traffic, at 8 bytes a query.
  constexpr std::size_t slice = std::size_t{1} << 20;
  if (queries.size() < smallest) return gather(queries, amplitudes);
  const TileAxis x(grid.x, tile), y(grid.y, tile);
  const auto tile_of = [&](const Query& q) {
    return static_cast<std::uint32_t>(x.tile(q.qx_per_um) * y.count() + y.tile(q.qy_per_um));
  };
  const std::size_t longest = std::min(slice, queries.size());
  std::vector<std::uint32_t> start(x.count() * y.count() + 1), tiles(longest), order(longest);
  std::vector<Query> sorted(batch);
  std::vector<std::complex<double>> results(batch);
  for (std::size_t origin = 0; origin < queries.size(); origin += slice) {
    const std::size_t size = std::min(slice, queries.size() - origin);
    const std::span<const Query> from = queries.subspan(origin, size);
    std::fill(start.begin(), start.end(), 0u);
    for (std::size_t i = 0; i < size; ++i) ++start[(tiles[i] = tile_of(from[i])) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (std::size_t i = 0; i < size; ++i) order[start[tiles[i]]++] = static_cast<std::uint32_t>(i);
    for (std::size_t first = 0; first < size; first += batch) {
      const std::size_t count = std::min(batch, size - first);
      for (std::size_t i = 0; i < count; ++i) sorted[i] = from[order[first + i]];
      gather(std::span<const Query>(sorted.data(), count),
             std::span<std::complex<double>>(results.data(), count));
      for (std::size_t i = 0; i < count; ++i) amplitudes[origin + order[first + i]] = results[i];
    }
  }
}

}  // namespace brdf
