// How wrong a Taylor series is, part by part.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "brdf/amplitude.h"

namespace brdf {

/// Bound on what the first `terms` terms of exp(i x) leave out: abs(x)^N / N!.
///
/// The right remainder for an imaginary exponent; the printed one (Thesis 1.31) carries a factor
/// e^x more.
inline double taylor_remainder_bound(double x, int terms) {
  double bound = 1;
  for (int n = 1; n <= terms; ++n) bound *= std::abs(x) / n;
  return bound;
}

/// Bound on the rounding of the series: its terms grow to e^x before they cancel.
inline double taylor_rounding_bound(double x) {
  return std::numeric_limits<double>::epsilon() / 2 * std::exp(std::abs(x));
}

/// Bound on the rounding of the frequency and of the gathered sum, for a spread sigma_um of the
/// window: abs(da/dq) is at most the mean distance sqrt(2 / pi) sigma on each axis.
inline double gather_rounding_bound(const QueryBounds& bounds, double sigma_um) {
  const auto largest = [](double lo, double hi) { return std::max(std::abs(lo), std::abs(hi)); };
  const double q_per_um = largest(bounds.lo.qx_per_um, bounds.hi.qx_per_um) +
                          largest(bounds.lo.qy_per_um, bounds.hi.qy_per_um);
  return 4 * std::numeric_limits<double>::epsilon() * (1 + q_per_um * sigma_um);
}

/// Fewest terms whose remainder is at most the tolerance, or nothing where more than `limit` are
/// needed.
inline std::optional<int> taylor_terms(double x, double tolerance, int limit) {
  double bound = 1;
  for (int n = 1; n <= limit; ++n) {
    bound *= std::abs(x) / n;
    if (bound <= tolerance && n >= std::abs(x)) return n;
  }
  return std::nullopt;
}

}  // namespace brdf
