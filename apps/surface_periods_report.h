// The periods of a scan, for people and as JSON.
#pragma once

#include <string>
#include <vector>

#include "evaluation/period/surface_periods.h"
#include "evaluation/writers/output_file.h"

namespace apps {

evaluation::Json to_json(const std::vector<evaluation::SurfacePeriod>& periods);

std::string for_people(const std::vector<evaluation::SurfacePeriod>& periods);

}  // namespace apps
