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

/// Grid points of a table along x and y.
struct TileGrid {
  double x, y;
};

/// Calls gather(queries, amplitudes) for all queries, batch by batch, sorted by tiles of the table;
/// the amplitudes come out in the order of the queries. Few queries are passed on as they are.
template <class Gather>
void in_tile_order(std::span<const Query> queries, std::span<std::complex<double>> amplitudes,
                   const QueryBounds& bounds, const TileGrid& grid, Gather gather) {
  // A tile and its margin fit the first-level cache; fewer queries than this touch each tile once.
  constexpr double tile = 8;
  constexpr std::size_t smallest = 4096, batch = 512;
  // Queries and amplitudes of one slice stay in the caches while they are moved about.
  constexpr std::size_t slice = 1 << 17;
  if (queries.size() < smallest) return gather(queries, amplitudes);
  const auto across = [](double points) { return static_cast<std::size_t>(points / tile) + 1; };
  const std::size_t tiles_x = across(grid.x), tiles_y = across(grid.y);
  const auto per_q = [](std::size_t tiles, double lo, double hi) {
    return hi > lo ? static_cast<double>(tiles) * (1 - 1e-9) / (hi - lo) : 0.0;
  };
  const double per_qx = per_q(tiles_x, bounds.lo.qx_per_um, bounds.hi.qx_per_um);
  const double per_qy = per_q(tiles_y, bounds.lo.qy_per_um, bounds.hi.qy_per_um);
  const auto tile_of = [&](const Query& q) {
    const auto x = static_cast<std::size_t>((q.qx_per_um - bounds.lo.qx_per_um) * per_qx);
    const auto y = static_cast<std::size_t>((q.qy_per_um - bounds.lo.qy_per_um) * per_qy);
    return static_cast<std::uint32_t>(x * tiles_y + y);
  };
  const std::size_t longest = std::min(slice, queries.size());
  std::vector<std::uint32_t> start(tiles_x * tiles_y + 1), tiles(longest), order(longest);
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
