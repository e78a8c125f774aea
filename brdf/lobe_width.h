// How wide the lobe is that an illuminated patch makes of one direction.
#pragma once

#include <cmath>
#include <limits>

#include "brdf/amplitude.h"
#include "brdf/axis_lobe.h"

namespace brdf {

/// The frequency q [rad/um] along a line through q = 0 at which the power of a flat patch's lobe
/// is one half of its peak; infinite where one pixel is all there is along the line.
///
/// Of a Gaussian window sqrt(ln 2) / sigma, of an evenly lit length L 2.7831 / L; the isolated
/// window, cut at the patch's edge, lies between. In the sine of the viewing angle the full width
/// at half maximum is 2 q / k = q lambda / pi, at any order. Cost: some 60 passes over an axis.
inline double lobe_half_width_per_um(SurfaceModel model, const GaussianWindow& window,
                                     const SurfaceAxis& x, const SurfaceAxis& y,
                                     const LineDirection& line) {
  const auto power = [&](double q_per_um) {
    const double amplitude = axis_lobe(model, window, x, q_per_um * line.cos_azimuth) *
                             axis_lobe(model, window, y, q_per_um * line.sin_azimuth);
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

/// The same of a surface.
inline double lobe_half_width_per_um(const Surface& surface, const LineDirection& line) {
  return lobe_half_width_per_um(surface.model, surface.window, x_axis(surface), y_axis(surface),
                                line);
}

}  // namespace brdf
