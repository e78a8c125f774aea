// The period of a scan as a picture: its lines, and what it is in parts of the patch.
#pragma once

#include <string>
#include <vector>

#include "apps/picture_format.h"
#include "evaluation/period/periods_around.h"
#include "evaluation/period/surface_periods.h"

namespace apps {

struct SurfacePeriodsPicture {
  const evaluation::SurfacePeriod* period;        ///< the strongest that is measured
  std::vector<evaluation::AzimuthPeriod> around;  ///< of all the surface
  std::string title;
};

/// The bytes of a file: places of the lines against an even lattice, the period by sub-patch and
/// window position and from light beside its interval, and period and depth against the azimuth.
std::string draw(const SurfacePeriodsPicture& picture, PictureFormat format);

}  // namespace apps
