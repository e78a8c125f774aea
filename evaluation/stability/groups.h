// The groups of rows, one file each.
#pragma once

#include <vector>

#include "evaluation/checks.h"

namespace evaluation::stability {

std::vector<CheckRow> order_rows();        ///< PQ factors around orders
std::vector<CheckRow> series_rows();       ///< the methods over the phase depth
std::vector<CheckRow> bare_series_rows();  ///< exp(i x) by the series alone, float and double
std::vector<CheckRow> grazing_rows();      ///< gains near 90 degrees
std::vector<CheckRow> long_patch_rows();   ///< phases along patches up to 10 cm
std::vector<CheckRow> height_rows();       ///< peak to valley 1e-15 m to 1 mm
std::vector<CheckRow> wavelength_rows();   ///< 10 nm to 100 um
std::vector<CheckRow> small_patch_rows();  ///< flat, one pixel, one spike
std::vector<CheckRow> replica_rows();      ///< 1e9 copies along each axis

}  // namespace evaluation::stability
