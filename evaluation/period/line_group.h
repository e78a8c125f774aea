// Periods so close together that their lines overlap: sub-populations, fitted at once.
#pragma once

#include <optional>
#include <vector>

#include "evaluation/period/period_estimate.h"

namespace evaluation {

/// Fits all lines of a group at once, so that none pulls another: the windowed spectrum around them
/// is sum_k A_k W(f - f_k), W(f) = exp(-2 pi^2 s^2 f^2) the Gaussian window's transform, f_k two
/// frequencies and A_k a complex amplitude each (Ceres).
///
/// The interval of each holds the standard error of the fit, from what it leaves of the bins, and
/// the spread over window positions, by Student's t over these: populations live in regions, and
/// where the window stands decides which are seen. A line that the fit does not find again, within
/// twice its own width, at three of four places half a standard deviation of the window aside, is
/// told by its own maximum there. Empty where that is lost, too.
std::vector<std::optional<PeriodEstimate>> estimate_periods_together(
    const SurfaceWave& wave, const std::vector<Frequency>& starts);

}  // namespace evaluation
