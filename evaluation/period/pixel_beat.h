// How far the sampling of sharp edges may move a period.
#pragma once

#include "evaluation/period/window_lobe.h"

namespace evaluation {

/// Relative standard deviation of a period d that was measured from edges sampled at a pixel.
///
/// An edge is put on the grid within half a pixel: its place is off by a sawtooth, whose harmonics
/// are copies of the orders shifted by the beat of d with the pixel, delta_m = m d / pixel - its
/// whole number, in spacings K of the orders, each of amplitude pixel / (m d) of the order's own
/// (for a pair of copies at random phase, root 2 times that). A copy at s moves the fit by rho(s) =
/// <z, W(t) W(t - s)> / <z, z>, z = W W' less what the fit takes for the order's strength or for
/// sidelobes: s itself for a copy inside the lobe, nearly nothing far off. In all
///
///     sum over m of 2 (pixel rho(delta_m K) / (m d K))^2,
///
/// the copies of the nearest two orders counted. A copy inside the lobe also draws the period that
/// is found towards the beat, so the largest value over all periods that could have led here is
/// taken: those no farther off than twice their own deviation. Averaged over d this is the
/// pixel / (d N^1.5) of N edges placed at random. Profiles without edges have less.
double pixel_deviation(const WindowLobe& lobe, double pixel_um, double period_um);

}  // namespace evaluation
