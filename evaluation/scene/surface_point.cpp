#include "evaluation/scene/surface_point.h"

#include <Eigen/Geometry>
#include <cmath>

#include "evaluation/pixel_blocks.h"

namespace evaluation {
namespace {

/// A tangent this near the normal has no direction in the tangent plane but that of its rounding.
constexpr double smallest_sine = 1e-9;

}  // namespace

std::optional<PatchFrame> patch_frame(const SurfacePoint& point, brdf::Angle orientation) {
  const double tangent = point.tangent.norm();
  if (!(point.normal.squaredNorm() > 0 && tangent > 0)) return std::nullopt;
  const Eigen::Vector3d z = point.normal.normalized();
  const Eigen::Vector3d along = point.tangent / tangent;
  const Eigen::Vector3d part = along - z.dot(along) * z;
  if (!(part.norm() > smallest_sine)) return std::nullopt;
  const Eigen::Vector3d x = part.normalized(), y = z.cross(x);
  const double c = std::cos(orientation.rad()), s = std::sin(orientation.rad());
  return PatchFrame{c * x + s * y, c * y - s * x, z};
}

std::vector<std::size_t> block_order(const SurfaceGrid& grid) {
  std::vector<std::size_t> order;
  order.reserve(grid.points.size());
  in_blocks(grid.cols, grid.rows, [&](int col, int row) { order.push_back(grid.index(col, row)); });
  return order;
}

}  // namespace evaluation
