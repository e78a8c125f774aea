// How many of a rough surface's facets are hidden: the G of a microfacet model.
#pragma once

#include <algorithm>

#include "brdf/smith_lambda.h"

namespace brdf {

/// The family of G (Hoffman).
enum class Masking {
  implicit,       ///< G = (n.l) (n.v): darkens rough surfaces too much
  cook_torrance,  ///< V-shaped grooves: `v_cavity_shadowing`
  kelemen,        ///< G = (n.l) (n.v) / (v.h)^2, a fast fit to V-shaped grooves
  smith,          ///< Smith's, height-correlated
};

/// G / ((n.l) (n.v)), what the model needs of G, finite where a cosine goes to 0.
///
/// implicit:      1
/// cook_torrance: min(1, 2 (n.h) (n.v) / (v.h), 2 (n.h) (n.l) / (v.h)) / ((n.l) (n.v))
/// kelemen:       1 / (v.h)^2 = 4 / |omega_i + omega_r|^2 (Kelemen and Szirmay-Kalos 2001)
/// smith:         G = 1 / (1 + Lambda(l) + Lambda(v)), height-correlated (Heitz 2014, eq. 99), with
///                the Lambda of the distribution itself (`back_facing_area`), so that no model
///                reflects more than it receives
///
/// Both directions in the upper half-space; symmetric in them to the last bit. The roughness, used
/// by smith alone, has passed `require_valid`.
inline double facet_visibility(Masking masking, const Roughness& roughness,
                               const Direction& omega_i, const Direction& omega_r) {
  switch (masking) {
    case Masking::implicit:
      return 1;
    case Masking::cook_torrance: {
      const double lower = std::min(omega_i.z(), omega_r.z());
      const double upper = std::max(omega_i.z(), omega_r.z());
      const Direction sum = omega_i + omega_r;
      const double length = sum.stableNorm();
      return std::min(1 / (lower * upper), 4 * (sum.z() / upper) / length / length);
    }
    case Masking::kelemen: {
      const double length = (omega_i + omega_r).stableNorm();
      return 4 / length / length;
    }
    case Masking::smith:
      break;
  }
  // The sum in brackets comes out the same with the directions swapped.
  return 1 / (omega_i.z() * omega_r.z() + (omega_r.z() * back_facing_area(roughness, omega_i) +
                                           omega_i.z() * back_facing_area(roughness, omega_r)));
}

}  // namespace brdf
