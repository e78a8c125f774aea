// A height field under a coherence window, and how it goes on beyond its edges.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "brdf/gaussian_window.h"
#include "brdf/height_field.h"

namespace brdf {

/// How the surface goes on beyond the measured patch.
enum class SurfaceModel {
  isolated,    ///< the patch alone; the window is cut at its edge
  periodic,    ///< the patch repeated without end under the whole window
  replicated,  ///< a finite number of copies side by side, evenly lit: no window
};

/// Copies of the patch along each axis in the replicated model, >= 1; they lie symmetrically about
/// the origin.
struct Replicas {
  int x = 1, y = 1;
  bool operator==(const Replicas&) const = default;
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
  Replicas replicas = {};  ///< of the replicated model; the others ignore it
};

/// Weight of the illumination along one axis: the coherence window, or 1 for the replicated model.
inline double illumination(const Surface& surface, double x_um) {
  return surface.model == SurfaceModel::replicated ? 1.0 : surface.window.spatial(x_um);
}

/// One axis of a surface: the positions of its pixels and, per pixel, of its repetitions.
struct SurfaceAxis {
  Eigen::Index count;  ///< pixels
  double pixel_um;
  double origin;              ///< pixel index where x = 0
  int first_copy, last_copy;  ///< repetitions: 0 to 0 for an isolated patch

  double length_um() const { return pixel_um * static_cast<double>(count); }
  int copies() const { return 1 + last_copy - first_copy; }
  /// Pixels of all repetitions.
  double points() const { return static_cast<double>(count) * copies(); }
  /// The tile around the centre of all copies, which lies at centre_um.
  SurfaceAxis middle_tile(double centre_um) const {
    return {count, pixel_um, static_cast<double>(count - 1) / 2 - centre_um / pixel_um, 0, 0};
  }
  /// Cycles that exp(i q x) makes along the patch: the place of q among its Fourier bins.
  double cycles(double q_per_um) const { return q_per_um / (2 * pi) * length_um(); }

  /// x [um] of a pixel in the repetition `copy`.
  double position_um(Eigen::Index index, int copy = 0) const {
    return pixel_um * (static_cast<double>(index) - origin +
                       static_cast<double>(copy) * static_cast<double>(count));
  }
};

namespace detail {

/// Beyond 9 sigma the window is below 3e-18 of its peak, under the rounding of any sum over it.
inline constexpr double window_reach_sigma = 9;

/// Along an axis of the periodic model: as many as an int counts, in round numbers.
inline constexpr double most_copies = 1e9;

/// The last of the copies under the window. Throws Errc::over_limit for too many.
inline int last_copy_under(const GaussianWindow& window, double length_um) {
  const double copies = window_reach_sigma * window.sigma_um() / length_um;  // to either side
  if (!(2 * copies <= most_copies))
    throw Error(Errc::over_limit, "a window of sigma " + text(window.sigma_um()) +
                                      " um over a periodic patch " + text(length_um) +
                                      " um long holds " + text(std::round(2 * copies)) +
                                      " copies of it, above 1e9; a narrower one holds fewer");
  return 1 + static_cast<int>(copies);
}

inline SurfaceAxis surface_axis(const Surface& surface, Eigen::Index count, double pixel_um,
                                int replicas) {
  if (surface.model == SurfaceModel::replicated && replicas < 1)
    throw Error(Errc::invalid_argument, "replicas " + std::to_string(replicas) + " must be >= 1");
  int first_copy = 0, last_copy = 0;
  if (surface.model == SurfaceModel::replicated) last_copy = replicas - 1;
  if (surface.model == SurfaceModel::periodic) {
    last_copy = last_copy_under(surface.window, pixel_um * static_cast<double>(count));
    first_copy = -last_copy;
  }
  const double middle = (static_cast<double>(count) * (1 + first_copy + last_copy) - 1) / 2;
  return {count, pixel_um, surface.origin == Origin::patch_centre ? middle : 0.0, first_copy,
          last_copy};
}

}  // namespace detail

inline SurfaceAxis x_axis(const Surface& surface) {
  return detail::surface_axis(surface, surface.heights->cols(), surface.heights->dx_um(),
                              surface.replicas.x);
}

inline SurfaceAxis y_axis(const Surface& surface) {
  return detail::surface_axis(surface, surface.heights->rows(), surface.heights->dy_um(),
                              surface.replicas.y);
}

/// Sums of the window and of its square along one axis, over the support of the surface model.
struct WindowSums {
  double g, g_squared;
};

inline WindowSums window_sums(const Surface& surface, const SurfaceAxis& axis) {
  if (surface.model == SurfaceModel::replicated) return {axis.points(), axis.points()};
  WindowSums sums{0, 0};
  for (int copy = axis.first_copy; copy <= axis.last_copy; ++copy)
    for (Eigen::Index index = 0; index < axis.count; ++index) {
      const double g = illumination(surface, axis.position_um(index, copy));
      sums.g += g;
      sums.g_squared += g * g;
    }
  return sums;
}

/// Coherently illuminated area (Int Int g)^2 / Int Int g^2 [um^2]; 4 pi sigma_s^2 for the periodic
/// model. With it abs(P)^2 / A of the BRDF is abs(a)^2 times this area.
inline double coherence_area_um2(const Surface& surface) {
  const auto along = [&](const SurfaceAxis& axis) {
    const WindowSums sums = window_sums(surface, axis);
    return axis.pixel_um * sums.g * sums.g / sums.g_squared;
  };
  return along(x_axis(surface)) * along(y_axis(surface));
}

}  // namespace brdf
