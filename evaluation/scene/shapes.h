// The shapes of a picture and what a camera sees of them.
#pragma once

#include <Eigen/Core>
#include <variant>

#include "evaluation/scene/camera.h"
#include "evaluation/scene/mesh.h"
#include "evaluation/scene/surface_point.h"

namespace evaluation {

/// Radius 1 about the origin, axis y. u = 1/2 + azimuth / 2 pi from +z towards +x, v = 1/2 +
/// latitude / pi; the tangent runs along the parallels, dP/du.
struct Sphere {};

/// The side of a cylinder of radius 0.6 and height 1.6 about the axis y, open at its ends, seen
/// from outside. u as for the sphere, v from the lower end to the upper; the tangent runs around.
struct Cylinder {
  static constexpr double radius = 0.6, half_height = 0.8;
};

using Shape = std::variant<Sphere, Cylinder, Mesh>;

/// What the camera sees at the centre of each pixel of a shape that is turned by a rotation.
///
/// rotation: an orthogonal matrix of determinant 1, from the shape's frame to the camera's.
///
/// Sphere and cylinder by intersection with the pixel's ray. A mesh by a z-buffer: with b the
/// barycentric coordinates on the picture, normal, tangent, texture and position are
/// sum (b_j / w_j) a_j / sum (b_j / w_j), exact for a plane triangle. Both sides of a triangle are
/// drawn; of points at equal depth that of the earlier triangle is kept. Exactly on an edge that
/// two triangles share a pixel belongs to at least one of them.
SurfaceGrid visible_points(const Shape& shape, const Camera& camera,
                           const Eigen::Matrix3d& rotation);

}  // namespace evaluation
