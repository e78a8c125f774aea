// What copies of a tile side by side do to its transform.
#pragma once

#include <cmath>
#include <string>

#include "brdf/error.h"
#include "brdf/units.h"

namespace brdf {

/// Mean of exp(2 pi i cycles j) over `replicas` copies placed symmetrically about the origin,
/// j = -(N - 1) / 2, ..., (N - 1) / 2: real, and 1 in modulus at whole cycles (the orders).
///
///     sin(N pi nu) / (N sin(pi nu)) = (-1)^{(N - 1) round(nu)} sin(N pi t) / (N sin(pi t)),
///     t = nu - round(nu)
///
/// The frequency is reduced while it still is in cycles, where nothing is lost; only then does it
/// meet pi. The printed closed form (Thesis 1.50) is 0/0 at the orders, and any form in radians has
/// lost the digits of t beforehand (Errata E1 to E4).
///
/// cycles: along one copy, q L / (2 pi) for a tile of length L; finite, of any size.
/// replicas: >= 1, else Errc::invalid_argument.
/// Error: two units in the last place of the peak, 4.4e-16, for any frequency and up to 1e9
/// replicas (measured against long double in pq_factors.tests.cpp: 4.2e-16). Source: Thesis
/// 1.38-1.50, where N is the last copy's index, divided by its peak.
inline double pq_factor(double cycles, int replicas) {
  if (replicas < 1)
    throw Error(Errc::invalid_argument, "replicas " + std::to_string(replicas) + " must be >= 1");
  const double n = replicas;
  const double order = std::round(cycles);
  const double t = cycles - order;
  const double peak = replicas % 2 == 0 && std::fmod(order, 2) != 0 ? -1 : 1;
  // Below, the factor is its peak times 1 - (N pi t)^2 / 6: within 2e-18. t may be 0 or denormal.
  if (std::abs(n * t) <= 1e-9) return peak;
  return peak * std::sin(pi * t * n) / (n * std::sin(pi * t));
}

}  // namespace brdf
