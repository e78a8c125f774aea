// Heights given point by point on a regular grid.
#pragma once

#include <cstdint>
#include <string>

#include "brdf/height_field.h"

namespace evaluation::detail {

/// Points put into rows and columns.
struct PointGrid {
  brdf::HeightArray heights;  ///< row 0 has the least y, column 0 the least x; NaN without a point
  double dx = 0, dy = 0;      ///< pitch, in the unit of the points
  std::uint64_t nodes = 0;    ///< of the grid
  std::string problem;        ///< why they lie on no grid, naming the first point; else empty
};

/// Puts the points x, y, z, one a row, in any order on the grid that they lie on.
///
/// A coordinate may be off its node by a tenth of the pitch. No two points share a node, at least
/// two rows and two columns are there, and at least half of the nodes have a point, of which there
/// are at most `max_nodes`. Cost: two sorts.
PointGrid grid_of(const brdf::HeightArray& points, std::uint64_t max_nodes);

}  // namespace evaluation::detail
