// The lobe that a patch under its illumination makes along one axis.
#pragma once

#include <cmath>

#include "brdf/pq_factors.h"
#include "brdf/surface.h"

namespace brdf {

/// Transform of the illumination along one axis, real and 1 at q = 0.
///
/// periodic: the Gaussian exp(-sigma^2 q^2 / 2), to exp(-2 pi^2 sigma^2 / pixel^2). replicated: all
/// pixels of all copies alike. isolated: the window's samples at the pixels of the axis. Cost: a
/// cosine for each pixel where isolated.
///
/// q_per_um: [rad/um], any. axis: as of `x_axis`; its origin plays no part.
inline double axis_lobe(SurfaceModel model, const GaussianWindow& window, const SurfaceAxis& axis,
                        double q_per_um) {
  switch (model) {
    case SurfaceModel::periodic:
      return window.spectral(q_per_um / (2 * pi));
    case SurfaceModel::replicated:
      return pq_factor(q_per_um * axis.pixel_um / (2 * pi),
                       static_cast<int>(axis.count) * (axis.last_copy + 1));
    case SurfaceModel::isolated:
      break;
  }
  const double middle = static_cast<double>(axis.count - 1) / 2;
  double sum = 0, weights = 0;
  for (Eigen::Index index = 0; index < axis.count; ++index) {
    const double x_um = axis.pixel_um * (static_cast<double>(index) - middle);
    const double weight = window.spatial(x_um);
    sum += weight * std::cos(q_per_um * x_um);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace brdf
