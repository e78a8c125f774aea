// How wrong a Taylor series is, part by part.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

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

/// Bound on what an error of each value kept (see PowerSpectra::value_error) makes of the series,
/// where a query reads `bins` values with weights whose squares sum to at most 1: the root of the
/// number by Cauchy-Schwarz, e^x for all powers together.
inline double kept_values_bound(double value_error, double x, double bins) {
  return value_error > 0 ? value_error * std::exp(std::abs(x)) * std::sqrt(bins) : 0.0;
}

/// Bound on the rounding of the frequency and of the gathered weights; reach: largest
/// abs(da/dq) along each axis [um], the mean distance from the origin of what is lit.
inline double gather_rounding_bound(const QueryBounds& bounds, double x_reach_um,
                                    double y_reach_um) {
  const auto largest = [](double lo, double hi) { return std::max(std::abs(lo), std::abs(hi)); };
  const double phase = largest(bounds.lo.qx_per_um, bounds.hi.qx_per_um) * x_reach_um +
                       largest(bounds.lo.qy_per_um, bounds.hi.qy_per_um) * y_reach_um;
  return 4 * std::numeric_limits<double>::epsilon() * (1 + phase);
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

/// Most terms that a Taylor series may take: with x = 700 the terms overflow; 2000 of them reach
/// past that.
inline constexpr int max_taylor_terms = 2000;

/// Throws Errc::invalid_argument where a number of terms is given that makes no series.
inline void require_taylor_terms(const std::optional<int>& terms) {
  if (terms && !(*terms >= 1 && *terms <= max_taylor_terms))
    throw Error(Errc::invalid_argument, "terms " + std::to_string(*terms) +
                                            " must lie between 1 and " +
                                            std::to_string(max_taylor_terms));
}

/// The terms that are given, or the fewest whose remainder is at most half of the tolerance. Throws
/// Errc::invalid_argument for a tolerance not above 0, Errc::not_attainable where more than
/// max_taylor_terms would be needed, and where the rounding e^x / 2^53 of the series alone is above
/// the tolerance: for 1e-6 from a phase depth 2 x of 45.8 rad on. With the terms given a plan
/// states its bound and goes on.
inline int taylor_terms(const Surface& surface, const QueryBounds& bounds,
                        const std::optional<int>& given) {
  if (given) return *given;
  if (!(bounds.tolerance > 0))
    throw Error(Errc::invalid_argument, "tolerance " + text(bounds.tolerance) + " must be > 0");
  const double x = bounds.max_abs_c_per_um() * surface.heights->half_range_um();
  if (!(taylor_rounding_bound(x) <= bounds.tolerance))
    throw Error(Errc::not_attainable, "a Taylor series at phase depth " + text(2 * x) +
                                          " rad rounds by up to " + text(taylor_rounding_bound(x)) +
                                          ", above the tolerance " + text(bounds.tolerance) +
                                          "; the Chebyshev series does not");
  if (const auto terms = taylor_terms(x, bounds.tolerance / 2, max_taylor_terms)) return *terms;
  throw Error(Errc::not_attainable, "a Taylor series reaches tolerance " + text(bounds.tolerance) +
                                        " at phase depth " + text(2 * x) +
                                        " rad with no number of terms up to " +
                                        std::to_string(max_taylor_terms));
}

}  // namespace brdf
