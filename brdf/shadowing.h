// How much of a rough surface's facets is seen from both directions: V-shaped grooves.
#pragma once

#include <algorithm>

#include "brdf/directions.h"

namespace brdf {

/// Shadowing and masking in V-shaped grooves, 0 to 1 (Cook and Torrance 1982; Hoffman;
/// Implementation chapter): min(1, 2 (n.h) (n.v) / (v.h), 2 (n.h) (n.l) / (v.h)).
///
/// Both directions in the upper half-space; 1 in the mirror direction, and symmetric in the
/// directions to the last bit. With s = omega_i + omega_r it is min(1, 4 s_z min(n.l, n.v) /
/// |s|^2), which needs no half vector and does not cancel. Relative error 5 eps
/// (shadowing.tests.cpp).
inline double v_cavity_shadowing(const Direction& omega_i, const Direction& omega_r) {
  const Direction sum = omega_i + omega_r;
  // Scaled: a square of cosines below 1e-154 would vanish.
  const double length = sum.stableNorm();
  const double lower = std::min(omega_i.z(), omega_r.z());
  return std::min(4 * (sum.z() / length) * (lower / length), 1.0);
}

}  // namespace brdf
