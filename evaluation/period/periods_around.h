// The period that a plane of incidence meets, azimuth by azimuth.
#pragma once

#include <string>
#include <vector>

#include "brdf/height_spectrum.h"
#include "brdf/units.h"

namespace evaluation {

/// The strongest component of the heights along one azimuth.
struct AzimuthPeriod {
  double azimuth_deg;
  double period_nm;
  double depth_nm;  ///< peak to valley of the sinusoid that has its power
};

/// Periods looked for.
struct PeriodRange {
  brdf::Length shortest, longest;
};

/// For azimuths from -90 deg (excluded) to 90 deg in steps: the maximum of the spectrum's power
/// along the ray of frequencies at that azimuth, within the range, of at least 2.5 cycles across
/// the patch and with a depth of a hundredth of the deepest; azimuths without one are left out.
///
/// A grating shows at azimuths beside its own through the width of its line, with a depth that
/// falls; its period there is that of the ray's point nearest to the line, d / cos of the angle
/// between them.
std::vector<AzimuthPeriod> periods_around(const brdf::HeightSpectrum& spectrum, double step_deg,
                                          const PeriodRange& range);

/// azimuth_deg,period_nm,depth_nm
std::string to_csv(const std::vector<AzimuthPeriod>& periods);

}  // namespace evaluation
