// The maxima of S(f) that may be ridges.
#pragma once

#include <cstddef>
#include <vector>

#include "evaluation/period/ridge_axis.h"

namespace evaluation {

/// A maximum of S.
struct RidgeCandidate {
  std::size_t point;
  double contrast;  ///< S over the background; infinite where that is 0
};

/// Candidates by increasing f, by the criteria of `find_ridges` on S alone: contrast, fall on both
/// sides, the highest within sigma_f, no sidelobe.
std::vector<RidgeCandidate> ridge_candidates(const FrequencyResponse& over, double least_contrast);

}  // namespace evaluation
