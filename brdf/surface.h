// A height field under a coherence window, and how it goes on beyond its edges.
#pragma once

#include <cmath>
#include <vector>

#include "brdf/gaussian_window.h"
#include "brdf/height_field.h"

namespace brdf {

/// How the surface goes on beyond the measured patch.
enum class SurfaceModel {
  isolated,  ///< the patch alone; the window is cut at its edge
  periodic,  ///< the patch repeated without end under the whole window
};

/// Where x = y = 0 and the window's centre lie.
enum class Origin {
  patch_centre,  ///< the middle of the pixel centres, (N - 1) / 2
  patch_corner,  ///< the first pixel, as in the sources' evaluator (only to reproduce it)
};

/// What is illuminated. Refers to heights that must outlive it.
struct Surface {
  const HeightField* heights;
  GaussianWindow window;
  SurfaceModel model;
  Origin origin = Origin::patch_centre;
};

/// One axis of a surface: the positions of its pixels and, per pixel, of its repetitions.
struct SurfaceAxis {
  Eigen::Index count;  ///< pixels
  double pixel_um;
  double origin;  ///< pixel index where x = 0
  int copies;     ///< repetitions on each side: 0 for an isolated patch

  /// x [um] of a pixel in the repetition `copy`.
  double position_um(Eigen::Index index, int copy = 0) const {
    return pixel_um * (static_cast<double>(index) - origin +
                       static_cast<double>(copy) * static_cast<double>(count));
  }
};

namespace detail {

/// Beyond 9 sigma the window is below 3e-18 of its peak, under the rounding of any sum over it.
inline constexpr double window_reach_sigma = 9;

inline SurfaceAxis surface_axis(const Surface& surface, Eigen::Index count, double pixel_um) {
  const double length_um = pixel_um * static_cast<double>(count);
  const double origin =
      surface.origin == Origin::patch_centre ? static_cast<double>(count - 1) / 2 : 0.0;
  const int copies =
      surface.model == SurfaceModel::isolated
          ? 0
          : 1 + static_cast<int>(window_reach_sigma * surface.window.sigma_um() / length_um);
  return {count, pixel_um, origin, copies};
}

}  // namespace detail

inline SurfaceAxis x_axis(const Surface& surface) {
  return detail::surface_axis(surface, surface.heights->cols(), surface.heights->dx_um());
}

inline SurfaceAxis y_axis(const Surface& surface) {
  return detail::surface_axis(surface, surface.heights->rows(), surface.heights->dy_um());
}

/// Sums of the window and of its square along one axis, over the support of the surface model.
struct WindowSums {
  double g, g_squared;
};

inline WindowSums window_sums(const GaussianWindow& window, const SurfaceAxis& axis) {
  WindowSums sums{0, 0};
  for (int copy = -axis.copies; copy <= axis.copies; ++copy)
    for (Eigen::Index index = 0; index < axis.count; ++index) {
      const double g = window.spatial(axis.position_um(index, copy));
      sums.g += g;
      sums.g_squared += g * g;
    }
  return sums;
}

/// Coherently illuminated area (Int Int g)^2 / Int Int g^2 [um^2]; 4 pi sigma_s^2 for the periodic
/// model. With it abs(P)^2 / A of the BRDF is abs(a)^2 times this area.
inline double coherence_area_um2(const Surface& surface) {
  const auto along = [&](const SurfaceAxis& axis) {
    const WindowSums sums = window_sums(surface.window, axis);
    return axis.pixel_um * sums.g * sums.g / sums.g_squared;
  };
  return along(x_axis(surface)) * along(y_axis(surface));
}

}  // namespace brdf
