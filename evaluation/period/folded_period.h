// The period of a surface that repeats itself exactly, from folding it onto one period.
#pragma once

#include <optional>

#include "evaluation/period/slope_posterior.h"
#include "evaluation/period/surface_wave.h"

namespace evaluation {

/// All periods near `start` at which the samples of a profile, sorted by their place within the
/// period, make one smooth curve: its total variation is least, to 2 % of its range. Edges that are
/// sampled with pixels of p over N periods agree with any period within about p / N^2; no method
/// can tell these apart, and the interval holds the truth for certain.
///
/// For waves that are real, even along y and periodic along x without noise or disorder: where the
/// folded curve varies more than half as much again as a single period does, empty. `reach`: how
/// far to look, relative to the start.
std::optional<Interval> folded_period_um(const SurfaceWave& wave, double start_um, double reach);

}  // namespace evaluation
