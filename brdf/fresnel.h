// How much of the light a smooth facet reflects: Fresnel's equations and Schlick's approximation.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>

#include "brdf/directions.h"

namespace brdf {

/// What stands for the reflectance R of a facet; the light comes through air or vacuum.
enum class FresnelModel {
  none,               ///< a perfect mirror, R = 1
  schlick,            ///< Schlick's approximation of R
  schlick_amplitude,  ///< Schlick's R taken for an amplitude and squared, as the sources print
  dielectric,         ///< exact, unpolarised, real refractive index
  conductor,          ///< exact, unpolarised, complex refractive index
};

/// Cosine of the angle at which a facet mirrors one direction into the other, in [0, 1]:
/// sqrt((1 + omega_i . omega_r) / 2) as |omega_i + omega_r| / 2, which does not cancel.
inline double cos_half(const Direction& omega_i, const Direction& omega_r) {
  return std::min((omega_i + omega_r).norm() / 2, 1.0);
}

/// Reflectances of light whose electric field is perpendicular (s) or parallel (p) to the plane of
/// incidence.
struct PolarisedReflectance {
  double s, p;

  double unpolarised() const { return (s + p) / 2; }
};

/// Reflectance at normal incidence, R_0 = ((n1 - n2) / (n1 + n2))^2 (Thesis B.1).
///
/// n1, n2: real refractive indices of the two sides, > 0.
inline double normal_reflectance(double n1, double n2) {
  const double amplitude = (n1 - n2) / (n1 + n2);
  return amplitude * amplitude;
}

/// Reflectance at normal incidence for the complex index n + i k relative to the side of the light,
/// R_0 = ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2).
inline double normal_reflectance(std::complex<double> index) {
  return std::norm(index - 1.0) / std::norm(index + 1.0);
}

/// Schlick's R = R_0 + (1 - R_0) (1 - cosine)^5 (Thesis B.1; Hoffman).
///
/// Within 0.036 of the exact value for n = 1.5, 0.045 for n = 2, the most near 85 deg; knows no
/// total reflection and no dip of a metal before grazing.
inline double schlick_reflectance(double cosine, double at_normal) {
  const double t = 1 - cosine;
  return at_normal + (1 - at_normal) * (t * t * t * t * t);
}

/// Fresnel's reflectances of a smooth boundary with the real relative index n = n2 / n1 > 0.
///
/// cosine: of the angle of incidence, 0 to 1. With g = sqrt(n^2 - 1 + cosine^2):
/// r_s = (cosine - g) / (cosine + g), r_p = (n^2 cosine - g) / (n^2 cosine + g), both multiplied
/// out so that nothing cancels but at Brewster's angle, where r_p is 0. 1 beyond the critical angle
/// (n < 1). Relative error of the sum of both at most 12 eps for n from 1.0001 to 10
/// (fresnel.tests.cpp).
inline PolarisedReflectance dielectric_reflectance(double cosine, double n) {
  const double n2_minus_1 = (n - 1) * (n + 1), cos2 = cosine * cosine;
  const double g2 = n2_minus_1 + cos2;
  if (g2 <= 0) return {1, 1};
  const double g = std::sqrt(g2), s = cosine + g, p = n * n * cosine + g;
  const double r_s = n2_minus_1 / (s * s);
  const double r_p = n2_minus_1 * (cos2 * (n * n + 1) - 1) / (p * p);
  return {r_s * r_s, r_p * r_p};
}

/// Fresnel's reflectances for the complex relative index n + i k, k >= 0: the equations of
/// `dielectric_reflectance` in complex numbers, and the same where k = 0.
///
/// Relative error of the sum of both at most 40 eps for n from 0.05 to 5, k from 0.1 to 10
/// (fresnel.tests.cpp); near a critical angle (n < 1, small k) it grows as the function's slope.
inline PolarisedReflectance conductor_reflectance(double cosine, std::complex<double> index) {
  const std::complex<double> m2 = index * index, m2_minus_1 = (index - 1.0) * (index + 1.0);
  const double cos2 = cosine * cosine;
  const std::complex<double> g = std::sqrt(m2_minus_1 + cos2);
  const double s2 = std::norm(cosine + g), p2 = std::norm(m2 * cosine + g);
  const double contrast = std::norm(m2_minus_1);
  return {contrast / (s2 * s2), contrast * std::norm(cos2 * (m2 + 1.0) - 1.0) / (p2 * p2)};
}

/// The reflectance of a surface's facets: a model and the index it is for.
struct Fresnel {
  FresnelModel model = FresnelModel::none;
  std::complex<double> index = 1.5;  ///< n + i k relative to the side of the light

  /// R(cosine), 0 to 1; for schlick_amplitude the square of Schlick's R.
  ///
  /// cosine: between a direction and the facet's normal, which for facets that mirror one direction
  /// into another is `cos_half`. The parameters have passed `require_valid`.
  double reflectance(double cosine) const {
    switch (model) {
      case FresnelModel::none:
        return 1;
      case FresnelModel::schlick:
        return schlick_reflectance(cosine, normal_reflectance(index));
      case FresnelModel::schlick_amplitude: {
        const double amplitude = schlick_reflectance(cosine, normal_reflectance(index));
        return amplitude * amplitude;
      }
      case FresnelModel::dielectric:
        return dielectric_reflectance(cosine, index.real()).unpolarised();
      case FresnelModel::conductor:
        return conductor_reflectance(cosine, index).unpolarised();
    }
    return 1;
  }

  /// R(cosine) / R(1): the F^2 / F_0^2 of the relative reflectance (Thesis 1.13 to 1.16); 1 at
  /// normal incidence, up to 1 / R_0 at grazing.
  double relative_reflectance(double cosine) const { return reflectance(cosine) / reflectance(1); }
};

/// Throws Errc::invalid_argument for an index that is not finite, has n <= 0, k < 0 or a part above
/// 1e6 (whose fourth powers still fit), or is 1, which is no boundary; and for a dielectric with
/// k other than 0. The model `none` has no index.
inline void require_valid(const Fresnel& fresnel) {
  if (fresnel.model == FresnelModel::none) return;
  const double n = fresnel.index.real(), k = fresnel.index.imag();
  const auto refuse = [n, k](const char* limit) {
    throw Error(Errc::invalid_argument,
                "refractive index " + text(n) + " + " + text(k) + " i " + limit);
  };
  constexpr double largest = 1e6;
  if (!(n > 0 && n <= largest)) refuse("must have a real part > 0 and at most 1e6");
  if (!(k >= 0 && k <= largest)) refuse("must have an imaginary part from 0 to 1e6");
  if (n == 1 && k == 0) refuse("must differ from 1: there is no boundary to reflect");
  if (fresnel.model == FresnelModel::dielectric && k != 0)
    refuse("must be real for a dielectric; a complex one is a conductor's");
}

}  // namespace brdf
