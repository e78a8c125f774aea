// The period of one line of a surface's spectrum, with what it is uncertain by.
#pragma once

#include <vector>

#include "evaluation/period/slope_posterior.h"
#include "evaluation/period/spectral_line.h"

namespace evaluation {

/// The period in a part of the patch, or under a window there.
struct LocalPeriod {
  double x_um, y_um;  ///< its middle
  double period_nm;
};

/// Standard deviations [nm] of what makes a period uncertain; they overlap and do not add up.
struct PeriodParts {
  double fit_nm = 0;      ///< standard error were each line's place, or each bin, independent
  double drift_nm = 0;    ///< were the distances independent: places that drift
  double patches_nm = 0;  ///< spread over strips side by side along the lines
  double window_nm = 0;   ///< spread over window positions along the grating vector
};

struct PeriodEstimate {
  Frequency frequency;
  double period_nm;
  Interval interval_nm;  ///< 95 %
  PeriodParts parts;
  double drift_share;  ///< probability that the lines drift rather than scatter
  double bow_share;    ///< and that they lie on a scanner's bow
  std::size_t lines;   ///< periods seen; 0 where the phases of lines were not used
  std::vector<LocalPeriod> by_patch, by_window;
  LinePhases phases;  ///< empty where they were not used
};

/// Period of the line nearest to `start`, one that stands alone: from the phases of its lines
/// (slope_posterior), in an interval widened by what strips of the patch differ beyond their own
/// uncertainty. A surface that repeats itself exactly, with sharp edges, is folded (folded_period).
///
/// Accuracy for noise-free gratings of at least 10 periods: 1e-9 for band-limited profiles; what
/// the sampling of sharp edges allows otherwise (scan_period.tests.cpp). Throws
/// Errc::not_attainable where there are fewer than 5 lines.
PeriodEstimate estimate_period(const SurfaceWave& wave, const Frequency& start);

/// Where the window stands for `by_window`: five places along the grating vector, up to a quarter
/// of the patch from its middle.
std::vector<PatchWindow> window_positions(const SurfaceWave& wave, const Frequency& along,
                                          double share);

}  // namespace evaluation
