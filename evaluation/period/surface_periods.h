// All periods of a scan, from its heights and from the light it would send back.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/dominant_periods.h"
#include "evaluation/period/period_estimate.h"

namespace evaluation {

/// Period from the lobes of diffracted light at constant c = k w, where the efficiency's slope does
/// not move them (physics: centred at u / lambda = -m / d).
struct LightPeriod {
  double period_nm;
  Interval interval_nm;            ///< 95 %
  std::vector<double> lambdas_nm;  ///< the brightest of nine, averaged
};

/// One period with all that is known of it.
struct SurfacePeriod {
  HeightPeriod found;                      ///< the maximum of the spectrum of heights
  std::optional<PeriodEstimate> heights;   ///< empty where it cannot be measured
  std::optional<LightPeriod> left, right;  ///< light from the side of +f, and of -f
  std::string reason;                      ///< why it cannot be measured
  bool in_group;                           ///< fitted together with others close by

  /// Whether heights and light agree: all intervals overlap.
  bool agree() const;
};

/// Periods closer than this many bins (cycles across the patch) are fitted together.
inline constexpr double group_bins = 5;

/// The periods of a height field, levelled first by a plane; harmonics of a period are not listed.
/// Strongest first, at most `most`.
///
/// Light: order 1 under a window as in `estimate_period`, at normal reading (incidence and order
/// symmetric about the normal, w = -2 (1 - (lambda / 2 d)^2)^(1/2)), the three brightest of nine
/// wavelengths from 380 to 780 nm. Throws Errc::not_attainable where no line stands above the
/// background: a rough surface, or a ring of directions.
std::vector<SurfacePeriod> surface_periods(const brdf::HeightField& field, std::size_t most = 5);

/// Azimuth of the grating vector of the strongest period, in (-90, 90] deg, between the bins of the
/// spectrum. Throws as above. Cost: one transform.
brdf::Angle grating_azimuth(const brdf::HeightField& field);

/// Two periods that span a lattice: the strongest, and the strongest of those at least 20 deg from
/// it and measured. Empty for a grating.
std::optional<std::pair<std::size_t, std::size_t>> lattice_of(
    const std::vector<SurfacePeriod>& periods);

}  // namespace evaluation
