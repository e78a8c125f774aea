// How the normals of the facets of a rough surface are spread: the D of a microfacet model.
#pragma once

#include <cmath>

#include "brdf/directions.h"

namespace brdf {

/// The family of D (Hoffman). All have D = 1 / (pi alpha^2) at the mean normal, but for the factor
/// stated at `gtr`.
enum class Distribution {
  blinn_phong,  ///< cos^n with n = 2 / alpha^2 - 2: for alpha <= 1
  beckmann,     ///< Gaussian slopes; alpha is their root mean square, both axes together
  ggx,          ///< Trowbridge and Reitz 1975; long tails
  gtr,          ///< Burley's generalised Trowbridge-Reitz (2012), its tail set by gamma
};

/// A distribution and its roughness; `gamma` is for gtr alone: 2 is ggx, less a longer tail.
struct Roughness {
  Distribution distribution = Distribution::ggx;
  double alpha = 0.5;
  double gamma = 2;
};

/// Smallest roughness: at 1e-6 the rounding of a half vector, 1e-16, still moves D by less than
/// 1e-9 of its peak. Largest: at 10 a typical facet leans by 84 deg.
inline constexpr double min_alpha = 1e-6, max_alpha = 10;

/// Throws Errc::invalid_argument for alpha outside 1e-6 to 10 (1 for blinn_phong, whose exponent
/// would be negative), and for a gtr with gamma outside 0.5 to 20.
inline void require_valid(const Roughness& roughness) {
  const bool is_cosine_power = roughness.distribution == Distribution::blinn_phong;
  const double largest = is_cosine_power ? 1 : max_alpha;
  if (!(roughness.alpha >= min_alpha && roughness.alpha <= largest))
    throw Error(Errc::invalid_argument, "roughness " + text(roughness.alpha) +
                                            " must lie between 1e-06 and " + text(largest) +
                                            (is_cosine_power ? " for a cosine power" : ""));
  if (roughness.distribution == Distribution::gtr &&
      !(roughness.gamma >= 0.5 && roughness.gamma <= 20))
    throw Error(Errc::invalid_argument,
                "tail exponent gamma " + text(roughness.gamma) + " must lie between 0.5 and 20");
}

/// Squares of the cosine and the sine of an angle from the mean normal, each computed on its own so
/// that neither loses digits at the other's end.
struct SquaredAngle {
  double cos2, sin2;
};

/// The angle of the half vector, along omega_i + omega_r. Directions in the upper half-space.
inline SquaredAngle half_vector_angle(const Direction& omega_i, const Direction& omega_r) {
  const Direction sum = omega_i + omega_r;
  const double length = sum.stableNorm();  // a square of cosines below 1e-154 would vanish
  const double x = sum.x() / length, y = sum.y() / length, z = sum.z() / length;
  return {z * z, x * x + y * y};
}

namespace detail {

/// y / (1 - exp(-y)), 1 at y = 0.
inline double exponential_ratio(double y) {
  return y == 0 ? 1 : y / -std::expm1(-y);
}

}  // namespace detail

/// D(h) [1/sr], normalised so that Int D(h) (n.h) d omega_h = 1 over the upper hemisphere.
///
/// blinn_phong: (n + 2) / (2 pi) cos^n theta_h, n = 2 / alpha^2 - 2
/// beckmann:    exp(-tan^2 theta_h / alpha^2) / (pi alpha^2 cos^4 theta_h)
/// ggx:         alpha^2 / (pi (alpha^2 cos^2 theta_h + sin^2 theta_h)^2)
/// gtr:         N / (pi alpha^2) (alpha^2 / (alpha^2 cos^2 theta_h + sin^2 theta_h))^gamma with
///              N = e((gamma - 1) x) / e(x), x = -2 ln alpha, e(y) = y / (1 - exp(-y)), which holds
///              at gamma = 1 and alpha = 1 too
/// (Hoffman; Walter et al. 2007, eq. 25, 30, 33; Burley 2012, eq. 4 and appendix B.)
///
/// half: its cosine > 0. The roughness has passed `require_valid`. Measured normalisation: to 1e-14
/// (microfacet_distribution.tests.cpp).
inline double facet_density(const Roughness& roughness, const SquaredAngle& half) {
  const double alpha2 = roughness.alpha * roughness.alpha;
  const double peak = 1 / (pi * alpha2);
  const double spread = alpha2 / (alpha2 * half.cos2 + half.sin2);
  switch (roughness.distribution) {
    case Distribution::blinn_phong: {
      if (roughness.alpha == 1) return peak;  // the exponent 0, also at the horizon
      const double log_cos2 = half.sin2 < 0.5 ? std::log1p(-half.sin2) : std::log(half.cos2);
      return peak * std::exp((1 / alpha2 - 1) * log_cos2);
    }
    case Distribution::beckmann: {
      const double exponent = half.sin2 / (half.cos2 * alpha2);
      // exp underflows there, and 1 / cos^4 may overflow: no facet leans as far.
      if (exponent > 745) return 0;
      return peak * std::exp(-exponent) / (half.cos2 * half.cos2);
    }
    case Distribution::ggx:
      return peak * spread * spread;
    case Distribution::gtr: {
      const double x = -2 * std::log(roughness.alpha);
      const double factor =
          detail::exponential_ratio((roughness.gamma - 1) * x) / detail::exponential_ratio(x);
      return factor * peak * std::pow(spread, roughness.gamma);
    }
  }
  return 0;
}

}  // namespace brdf
