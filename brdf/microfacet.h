// Reflection from a rough surface without diffraction: microfacet models and Lambert's.
#pragma once

#include <cmath>
#include <variant>

#include "brdf/fresnel.h"
#include "brdf/microfacet_masking.h"
#include "brdf/reflectance_materials.h"

namespace brdf {

/// What the facets reflect: a refractive index, the same at all wavelengths, or a material of the
/// table, with Schlick's approximation of its angles.
using FacetReflectance = std::variant<Fresnel, ReflectanceMaterial>;

/// A rough surface made of small mirrors, f = F(l, h) G(l, v, h) D(h) / (4 (n.l) (n.v)) (Hoffman;
/// Cook and Torrance 1982; Walter et al. 2007, eq. 20).
///
/// With R = 1 no combination reflects more than it receives: at most 1.0000 for alpha from 0.01 to
/// 1 and the light up to 85 deg (microfacet.tests.cpp). What is missing, up to 0.69 at alpha = 1
/// and nearly all of a smooth surface at 85 deg under the implicit masking, is light between facets
/// that the model does not follow.
struct Microfacet {
  Roughness roughness;
  Masking masking = Masking::smith;
  FacetReflectance reflectance = Fresnel{};

  /// R of a facet that mirrors the one direction into the other.
  double facet_reflectance(double cosine, Length wavelength) const {
    if (const auto* fresnel = std::get_if<Fresnel>(&reflectance))
      return fresnel->reflectance(cosine);
    return schlick_reflectance(
        cosine, normal_reflectance(std::get<ReflectanceMaterial>(reflectance), wavelength));
  }

  /// BRDF [1/sr], >= 0.
  ///
  /// Both directions in the upper half-space; symmetric in them to the last bit. Finite from the
  /// smallest roughness on and for every direction that `direction` makes. The parameters have
  /// passed `require_valid`.
  double brdf(const Direction& omega_i, const Direction& omega_r, Length wavelength) const {
    const SquaredAngle half = half_vector_angle(omega_i, omega_r);
    return facet_reflectance(cos_half(omega_i, omega_r), wavelength) *
           facet_visibility(masking, roughness, omega_i, omega_r) * facet_density(roughness, half) /
           4;
  }
};

/// Throws Errc::invalid_argument where a parameter of the roughness or of Fresnel's model is.
inline void require_valid(const Microfacet& surface) {
  require_valid(surface.roughness);
  if (const auto* fresnel = std::get_if<Fresnel>(&surface.reflectance)) require_valid(*fresnel);
}

/// A perfectly diffuse surface, f = albedo / pi [1/sr] (Hoffman).
struct Lambert {
  double albedo = 1;  ///< part of the light that is reflected, 0 to 1

  double brdf() const { return albedo / pi; }
};

/// Throws Errc::invalid_argument for an albedo outside 0 to 1.
inline void require_valid(const Lambert& surface) {
  if (!(surface.albedo >= 0 && surface.albedo <= 1))
    throw Error(Errc::invalid_argument,
                "albedo " + text(surface.albedo) + " must lie between 0 and 1");
}

}  // namespace brdf
