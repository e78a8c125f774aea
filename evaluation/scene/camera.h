// From the pixels of a picture to rays, and from points to pixels.
#pragma once

#include <Eigen/Core>

#include "brdf/units.h"

namespace evaluation {

enum class Projection { orthographic, perspective };

/// A ray: origin + t direction, |direction| = 1.
struct Ray {
  Eigen::Vector3d origin, direction;
};

/// A point on the picture.
struct Projected {
  Eigen::Vector2d pixel;  ///< column and row; the centre of the first pixel is at (0.5, 0.5)
  double w;               ///< > 0; attributes over w are linear on the picture
};

/// A camera on the z axis that looks at the origin, x to the right, y up. The sphere of radius 1.1
/// about the origin touches the edges of the picture's shorter side: shapes within the unit sphere
/// are seen whole, and lie in front of the camera.
class Camera {
 public:
  /// cols, rows: 1 to 16384 each, together at most 2^24.
  /// field_of_view: across the shorter side, 1 to 150 deg; an orthographic camera has none and
  /// ignores it.
  /// Throws Errc::invalid_argument otherwise.
  Camera(Projection projection, int cols, int rows, brdf::Angle field_of_view);

  static constexpr int max_side = 16384, max_pixels = 1 << 24;

  Projection projection() const { return projection_; }
  int cols() const { return cols_; }
  int rows() const { return rows_; }
  /// Of a perspective camera from the origin.
  double distance() const { return distance_; }

  /// Through the centre of a pixel.
  Ray ray(int col, int row) const;
  /// Unit vector from a point towards the viewer.
  Eigen::Vector3d viewer(const Eigen::Vector3d& position) const;
  /// Of a point within the unit sphere.
  Projected project(const Eigen::Vector3d& position) const;

 private:
  Eigen::Vector3d eye() const { return {0, 0, distance_}; }

  Projection projection_;
  int cols_, rows_;
  double distance_;  ///< orthographic: of the plane the rays start from
  double scale_;     ///< pixels per unit of x / w
};

}  // namespace evaluation
