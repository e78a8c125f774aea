// The place of a line in the windowed spectrum of a surface, between the bins.
#pragma once

#include <complex>
#include <optional>

#include "evaluation/period/frequency.h"
#include "evaluation/period/surface_wave.h"

namespace evaluation {

/// Gaussian weights over a patch, exp(-(x - x0)^2 / (2 s^2)) along each axis, s this share of it.
/// An axis of fewer than 8 pixels goes without.
struct PatchWindow {
  /// At 1/10 the edges weigh exp(-12.5) = 4e-6 of the middle: lines more than 10 cycles apart, such
  /// as a sinusoid's own mirror image, pull each other by less than 1e-6 of their frequency
  /// (physics of the smooth window; measured in spectral_line.tests.cpp).
  double share = 0.1;
  double centre_x_um = 0, centre_y_um = 0;
};

/// The maximum near `start` of |sum w (s - <s>) exp(-2 pi i f.x)|, s the wave, <s> its mean under
/// the window w; by Newton's method on the exact sum at any f. Empty where the way there leaves the
/// line, more than 2 / (2 pi s) along either axis from the start, or where it is no maximum.
///
/// Error for a sinusoid of at least 10 periods: 1e-7 of its period. Cost: some 5 passes over the
/// pixels.
std::optional<Frequency> refined_line(const SurfaceWave& wave, const Frequency& start,
                                      const PatchWindow& window = {});

/// sum w s exp(-2 pi i f.x) / sum w, with the mean taken off as above.
std::complex<double> line_amplitude(const SurfaceWave& wave, const Frequency& frequency,
                                    const PatchWindow& window = {});

}  // namespace evaluation
