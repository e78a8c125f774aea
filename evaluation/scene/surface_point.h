// What a picture sees of a shape, pixel by pixel, and the frame of the patch there.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "brdf/units.h"
#include "evaluation/direction_colours.h"

namespace evaluation {

/// A point of a shape in the frame of the camera: x to the right, y up, z towards the viewer.
struct SurfacePoint {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;   ///< outwards, of unit length; zero where the shape has none
  Eigen::Vector3d tangent;  ///< along the patch's x, of any length and not yet orthogonal to the
                            ///< normal; zero where there is none
  Eigen::Vector2d texture;  ///< u to the right, v up; a picture covers 0 to 1 and repeats
};

/// The points behind the pixels of a picture, row by row from the top; none is background.
struct SurfaceGrid {
  int cols = 0, rows = 0;
  std::vector<std::optional<SurfacePoint>> points;

  SurfaceGrid(int columns, int lines)
      : cols(columns),
        rows(lines),
        points(static_cast<std::size_t>(columns) * static_cast<std::size_t>(lines)) {}

  std::size_t index(int col, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cols) +
           static_cast<std::size_t>(col);
  }
  const std::optional<SurfacePoint>& at(int col, int row) const { return points[index(col, row)]; }
};

/// The right-handed orthonormal frame of a patch in the tangent plane.
struct PatchFrame {
  Eigen::Vector3d x, y, z;

  brdf::Direction local(const Eigen::Vector3d& direction) const {
    return {x.dot(direction), y.dot(direction), z.dot(direction)};
  }
};

/// z = normal, x = the tangent's part orthogonal to it, y = z cross x; then x and y turned by the
/// orientation about the normal, x towards y.
///
/// orientation: any finite angle. None where the normal or that part of the tangent is zero, the
/// latter up to 1e-9 of the tangent, below which its direction is rounding.
std::optional<PatchFrame> patch_frame(const SurfacePoint& point, brdf::Angle orientation);

/// Whether light and viewer are both above the horizon of the patch; NaN is not.
inline bool is_lit(const DirectionPair& pair) {
  return pair.omega_i.z() > 0 && pair.omega_r.z() > 0;
}

/// The cells (column, row) of a grid, block by block of 16 x 16: neighbours stay together.
std::vector<std::size_t> block_order(const SurfaceGrid& grid);

}  // namespace evaluation
