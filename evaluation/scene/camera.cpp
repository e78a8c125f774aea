#include "evaluation/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "brdf/error.h"

namespace evaluation {
namespace {

/// A tenth of the unit sphere stays free around it.
constexpr double seen_radius = 1.1;

[[noreturn]] void refuse(const std::string& what) {
  throw brdf::Error(brdf::Errc::invalid_argument, what);
}

}  // namespace

Camera::Camera(Projection projection, int cols, int rows, brdf::Angle field_of_view)
    : projection_(projection), cols_(cols), rows_(rows) {
  for (const int side : {cols, rows})
    if (side < 1 || side > max_side)
      refuse("picture side of " + std::to_string(side) + " pixels must be 1 to " +
             std::to_string(max_side));
  if (cols > max_pixels / rows)
    refuse("picture of " + std::to_string(cols) + " x " + std::to_string(rows) +
           " pixels: at most " + std::to_string(max_pixels));
  const double half_side = std::min(cols, rows) / 2.0;
  if (projection == Projection::orthographic) {
    distance_ = 2 * seen_radius;
    scale_ = half_side / seen_radius;
    return;
  }
  if (!(field_of_view.deg() >= 1 && field_of_view.deg() <= 150))
    refuse("field of view " + brdf::text(field_of_view.deg()) + " deg must be 1 to 150 deg");
  const double half_angle = field_of_view.rad() / 2;
  distance_ = seen_radius / std::sin(half_angle);
  scale_ = half_side / std::tan(half_angle);
}

Ray Camera::ray(int col, int row) const {
  const double x = (col + 0.5 - cols_ / 2.0) / scale_, y = (rows_ / 2.0 - row - 0.5) / scale_;
  if (projection_ == Projection::orthographic) return {{x, y, distance_}, {0, 0, -1}};
  return {eye(), Eigen::Vector3d(x, y, -1).normalized()};
}

Eigen::Vector3d Camera::viewer(const Eigen::Vector3d& position) const {
  if (projection_ == Projection::orthographic) return {0, 0, 1};
  return (eye() - position).normalized();
}

Projected Camera::project(const Eigen::Vector3d& position) const {
  const double w = projection_ == Projection::orthographic ? 1.0 : distance_ - position.z();
  return {{cols_ / 2.0 + scale_ * position.x() / w, rows_ / 2.0 - scale_ * position.y() / w}, w};
}

}  // namespace evaluation
