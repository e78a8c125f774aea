// How steep a height field is: the roughness that a microfacet model takes.
#pragma once

#include <cmath>

#include "brdf/height_field.h"

namespace brdf {

/// Root mean square of the slope |grad h|, sqrt(<(dh/dx)^2> + <(dh/dy)^2>), >= 0.
///
/// Each derivative is the difference of two neighbours over the pixel, so that the finest detail
/// counts in full: of a sinusoid of period d it finds the part sinc(dx / d), at d = 10 pixels
/// 0.984. An axis of one pixel has slope 0. A tilt counts (see `levelled`), and so do steps: a
/// vertical wall adds height^2 / dx, without limit as the pixel shrinks. It is the alpha of
/// Beckmann's distribution, whose slopes p, q have the density exp(-(p^2 + q^2) / alpha^2) / (pi
/// alpha^2) (Hoffman; Walter et al. 2007).
inline double rms_slope(const HeightField& field) {
  const HeightArray& h = field.heights_um();
  const auto mean_square = [](const auto& differences_um, double pixel_um) {
    return differences_um.size() > 0 ? (differences_um / pixel_um).square().mean() : 0.0;
  };
  const Eigen::Index rows = field.rows(), cols = field.cols();
  return std::sqrt(mean_square(h.rightCols(cols - 1) - h.leftCols(cols - 1), field.dx_um()) +
                   mean_square(h.bottomRows(rows - 1) - h.topRows(rows - 1), field.dy_um()));
}

}  // namespace brdf
