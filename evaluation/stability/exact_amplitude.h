// The amplitude by its definition in 50 decimal digits.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "brdf/amplitude.h"

namespace evaluation::stability {

/// The normalised amplitudes of a surface, origin in the patch's centre, computed in 50 digits
/// from the same doubles and rounded to long double. Any phase, any number of replicas (their
/// factor in closed form). Cost: about 0.1 ms per pixel, and per repetition of an axis, a query.
std::vector<std::complex<long double>> exact_amplitudes(const brdf::Surface& surface,
                                                        std::span<const brdf::Query> queries);

}  // namespace evaluation::stability
