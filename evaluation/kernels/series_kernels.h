// The vectorised inner loops of the Chebyshev series.
#pragma once

#include <string_view>

#include "brdf/term_table.h"

namespace evaluation {

/// Loops for the best instruction set of the machine that the program runs on (SSE2 to AVX-512,
/// NEON): for ChebyshevSeries(vectorised_kernels()).
///
/// Amplitudes equal those of brdf::portable_kernels to 1e-13, measured in series_kernels.tests.cpp;
/// on one machine they are the same bits whatever the batch.
const brdf::SeriesKernels& vectorised_kernels();

/// Highway's name of that instruction set, e.g. "AVX3".
std::string_view instruction_set();

}  // namespace evaluation
