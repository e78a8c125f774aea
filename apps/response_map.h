// The heat map of a response, on which others draw.
#pragma once

#include <string>

#include "apps/gnuplot.h"
#include "evaluation/peaks.h"

namespace apps {

/// Sets axes and colours for a response, and returns a "plot" command of its cells, logarithmic
/// over four decades below the maximum, to be followed by ", " and what is drawn on it.
std::string plot_response_map(Drawing& gp, const evaluation::ResponseMatrix& response,
                              const evaluation::PlaneOfIncidence& plane,
                              const std::string& value_label);

}  // namespace apps
