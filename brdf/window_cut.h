// Where a coherence window may be cut.
#pragma once

#include <algorithm>
#include <cmath>

#include "brdf/surface.h"

namespace brdf {

/// How many samples on each side of the centre are kept of a window, and the share of it that is
/// left out.
struct WindowCut {
  double samples, share;
};

/// Cuts a window as near to its centre as leaves out at most `share` of the sum of its samples,
/// but not inside one sigma. Normalised anew, the sum is off by at most twice the share.
inline WindowCut cut_window(const Surface& surface, const SurfaceAxis& axis, double share) {
  const double sigma_samples = surface.window.sigma_um() / axis.pixel_um;
  const double nearest = axis.origin - std::floor(axis.origin);  // 0, or 1/2 between pixels
  const double all = window_sums(surface, axis).g;
  double left_out = 0, distance = std::ceil(detail::window_reach_sigma * sigma_samples) + nearest;
  for (; distance > std::max(sigma_samples, 0.5); --distance) {
    const double pair = 2 * surface.window.spatial(distance * axis.pixel_um);
    if (left_out + pair > share * all) break;
    left_out += pair;
  }
  return {distance, left_out / all};
}

}  // namespace brdf
