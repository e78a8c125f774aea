// Which maximum of which wavelength belongs to which ridge.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "evaluation/period/ridge_axis.h"

namespace evaluation {

/// A local maximum of one wavelength, refined by a parabola through the logarithms.
struct RowMaximum {
  double f_per_um;
  double value;  ///< of the nearest point
};

/// The maxima of every wavelength, by increasing f; none in the mirror lobe, nor where the response
/// is not above `floor`, which its own error could make.
std::vector<std::vector<RowMaximum>> row_maxima(const FrequencyResponse& over, double floor);

/// Where a ridge is thought to lie.
struct RidgeTrack {
  double f_per_um;
  double strength;                                 ///< S there
  std::vector<std::optional<RowMaximum>> members;  ///< per wavelength
};

/// Gives every wavelength's maxima to the ridges, each to at most one and at most one to each.
///
/// A maximum may belong to a ridge where it lies within `reach_per_um` of it and within half of the
/// distance to the next ridge, and has a tenth of the ridge's mean power. Of all ways that keep
/// maxima and ridges in order, each wavelength takes the one with the largest sum of 1 - (distance
/// / reach)^2, found by dynamic programming. Then each ridge moves to the median of its members,
/// weighted with their power, until no member changes. tracks: by increasing f. Cost per round:
/// wavelengths x maxima x ridges.
void assign_members(std::vector<RidgeTrack>& tracks,
                    const std::vector<std::vector<RowMaximum>>& maxima, double reach_per_um);

/// Below this part of its mean power a ridge counts as absent: 10 dB.
inline constexpr double least_of_mean = 0.1;

}  // namespace evaluation
