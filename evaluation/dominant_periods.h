// The periods of a height field: maxima of its spectrum that stand clear of everything around.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "brdf/height_spectrum.h"

namespace evaluation {

/// Its integer multiple of another period's frequency.
struct Harmonic {
  std::size_t of;  ///< index of that period
  int order;       ///< 2, 3, ...
};

/// One periodic component of a surface.
struct HeightPeriod {
  brdf::Length period;
  brdf::Angle azimuth;  ///< of the grating vector, in (-90, 90] deg
  double depth_um;      ///< peak to valley of the sinusoid
  double share;         ///< of the variance of the heights
  double contrast;      ///< power over the background's; infinite where nothing is around
  std::optional<Harmonic> harmonic;
};

/// Across the patch; below, a period is not told from the bow and the tilt of a scan.
inline constexpr double least_cycles = 2.5;

/// The strongest periods, at most `most` and as many harmonics, strongest first; none for a flat or
/// a rough surface.
///
/// A maximum of the power counts as a period where it makes at least 2.5 cycles across the patch,
/// holds at least 0.2 % of the variance and 5 % of the strongest period's, and
/// - holds half of the variance, or
/// - has 30 times the background within an octave below and above in frequency: in all directions
/// (a
///   ring), and in its own (a strip, else the streaks that a scanning tip draws would count; where
///   the strip has too few bins it holds a fifth of the variance instead).
/// The background is the median, which lines nearby do not move, over ln 2: for a rough surface the
/// mean power, which a bin exceeds 30 times with the probability exp(-30). A multiple of a stronger
/// period's frequency is its harmonic, also where it is folded at the Nyquist limit.
/// The place is refined by parabolas through the logarithms of the power, exact for a Gaussian
/// window. Accuracy, measured in dominant_periods.tests.cpp. Cost: a pass over the spectrum for
/// each maximum looked at.
std::vector<HeightPeriod> dominant_periods(const brdf::HeightSpectrum& spectrum,
                                           std::size_t most = 5);

}  // namespace evaluation
