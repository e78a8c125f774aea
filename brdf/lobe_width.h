// How wide the lobe is that an illuminated patch makes of one direction.
#pragma once

#include <cmath>
#include <limits>

#include "brdf/amplitude.h"
#include "brdf/pq_factors.h"

namespace brdf {

namespace detail {

/// Transform of the illumination along one axis, 1 at q = 0.
inline double axis_lobe(const Surface& surface, const SurfaceAxis& axis, double q_per_um) {
  switch (surface.model) {
    case SurfaceModel::periodic:  // the Gaussian, to exp(-2 pi^2 sigma^2 / pixel^2)
      return surface.window.spectral(q_per_um / (2 * pi));
    case SurfaceModel::replicated:  // all pixels alike
      return pq_factor(q_per_um * axis.pixel_um / (2 * pi),
                       static_cast<int>(axis.count) * (axis.last_copy + 1));
    case SurfaceModel::isolated:
      break;
  }
  const double middle = static_cast<double>(axis.count - 1) / 2;
  double sum = 0, weights = 0;
  for (Eigen::Index index = 0; index < axis.count; ++index) {
    const double x_um = axis.pixel_um * (static_cast<double>(index) - middle);
    const double weight = surface.window.spatial(x_um);
    sum += weight * std::cos(q_per_um * x_um);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace detail

/// The frequency q [rad/um] along a line through q = 0 at which the power of a flat patch's lobe
/// is one half of its peak; infinite where one pixel is all there is along the line.
///
/// Of a Gaussian window sqrt(ln 2) / sigma, of an evenly lit length L 2.7831 / L; the isolated
/// window, cut at the patch's edge, lies between. In the sine of the viewing angle the full width
/// at half maximum is 2 q / k = q lambda / pi, at any order. Cost: some 60 passes over an axis.
inline double lobe_half_width_per_um(const Surface& surface, const LineDirection& line) {
  const SurfaceAxis x = x_axis(surface), y = y_axis(surface);
  const auto power = [&](double q_per_um) {
    const double amplitude = detail::axis_lobe(surface, x, q_per_um * line.cos_azimuth) *
                             detail::axis_lobe(surface, y, q_per_um * line.sin_azimuth);
    return amplitude * amplitude;
  };
  // No lobe is narrower than that of the whole extent, evenly lit, nor of a Gaussian of the window.
  const auto extent_um = [](const SurfaceAxis& axis) {
    return axis.length_um() * (axis.last_copy - axis.first_copy + 1);
  };
  double lo = 0, hi = 1 / std::hypot(extent_um(x), extent_um(y));
  const double finest_um = std::min(x.pixel_um, y.pixel_um);
  while (power(hi) > 0.5) {
    if (!(hi * finest_um <= pi)) return std::numeric_limits<double>::infinity();
    lo = hi;
    hi *= 1.25;  // finer than the sidelobes, the first of which is 1.4 times as far out as its zero
  }
  // 50 halvings reach the rounding of a double.
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = std::midpoint(lo, hi);
    (power(middle) > 0.5 ? lo : hi) = middle;
  }
  return hi;
}

}  // namespace brdf
