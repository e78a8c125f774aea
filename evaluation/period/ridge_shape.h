// How wide a ridge is, how steady, and where it is seen.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "evaluation/period/ridge_tracks.h"

namespace evaluation {

struct WavelengthSpan {
  double first_nm, last_nm;
};

/// Full width at half maximum [1/um] of S about one of its maxima; twice one half where a neighbour
/// hides the other, empty where both are hidden.
std::optional<double> width_per_um(const FrequencyResponse& over, std::size_t top);

/// Standard deviation of the members' f [1/um], weighted with their power. track: with a member.
double spread_per_um(const RidgeTrack& track);

/// The wavelengths with a member, without a gap each.
std::vector<WavelengthSpan> spans(const RidgeTrack& track, const Axis& lambda_nm);

}  // namespace evaluation
