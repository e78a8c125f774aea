// How far the sampling of sharp edges may move a period.
#pragma once

#include "evaluation/period/window_lobe.h"

namespace evaluation {

/// Relative standard deviation of a period d that was measured from edges sampled at a pixel.
///
/// An edge is put on the grid within half a pixel, e_j = the place of the edge x_j less the nearest
/// boundary of pixels. To first order the fit then is off by
///
///     sum_j g(x_j) e_j h(x_j) / (<z, z> sum_j g(x_j)),   h(x) = <z, W(t) sin(t x)>,
///
/// with g the illumination, W its transform and z(t) = W W' less what the fit takes for the
/// strength of the order or for sidelobes. The errors are no noise: they beat with d, and are the
/// same for all wavelengths and orders. The deviation is that of an error spread evenly up
/// to the largest over the places of the grating on the pixels. Since a beat also draws the period
/// that is found towards itself, the largest over all periods that could have led here is taken:
/// those no farther off than it moves them, with half as much again for what is not of first order.
///
/// Averaged over d the error is the pixel / (d N^1.5) of N edges placed at random. Profiles without
/// edges have less.
double pixel_deviation(const WindowLobe& lobe, double pixel_um, double period_um);

}  // namespace evaluation
