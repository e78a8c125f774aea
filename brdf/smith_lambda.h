// The facets of a rough surface that face away from a direction: what Smith's masking is made of.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "brdf/microfacet_distribution.h"

namespace brdf {
namespace detail {

/// Exp-sinh quadrature of Int_0^inf f(t) dt: t = exp(pi/2 sinh x) with x in steps of 1/8 to +-3.75,
/// where t is 1e-14 and 1e+14. Takes ends like t^(3/2) and 1 / t^2 without loss.
struct ExpSinhRule {
  static constexpr int half_count = 30;
  std::array<double, 2 * half_count + 1> node, weight;

  ExpSinhRule() {
    constexpr double step = 0.125;
    for (int i = -half_count; i <= half_count; ++i) {
      const double x = i * step;
      const auto at = static_cast<std::size_t>(i + half_count);
      node[at] = std::exp(pi / 2 * std::sinh(x));
      weight[at] = step * pi / 2 * std::cosh(x) * node[at];
    }
  }
};

/// The integral that `back_facing_area` is, over the tangent t of the facets' angle.
///
/// At the angle theta_h the facets that face away lie within psi of the azimuth opposite to the
/// direction, cos psi = cot theta cot theta_h; over these azimuths -omega.h integrates to
/// 2 sin theta sin theta_h (sin psi - psi cos psi).
inline double back_facing_quadrature(const Roughness& roughness, double cosine, double sine) {
  static const ExpSinhRule rule;
  const double first = cosine / sine;  // the least tangent of a facet that faces away
  double area = 0;
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    const double beyond = roughness.alpha * rule.node[i], t = first + beyond;
    const SquaredAngle half{1 / (1 + t * t), 1 / (1 + 1 / (t * t))};
    const double cos_psi = first / t, sin_psi = std::sqrt(beyond * (first + t)) / t;
    const double facing_away = 2 * sine * (sin_psi - std::atan2(sin_psi, cos_psi) * cos_psi);
    // sin^2 theta_h of the measure and of the integral over the azimuth; d theta_h = cos^2 dt.
    area += roughness.alpha * rule.weight[i] * facet_density(roughness, half) * half.sin2 *
            half.cos2 * facing_away;
  }
  return area;
}

}  // namespace detail

/// Projected area of the facets that face away from a direction, per area of the mean surface:
/// Int D(h) max(0, -omega.h) d omega_h = cos theta Lambda(theta), >= 0 and finite to the horizon,
/// where Lambda is not (Smith 1967; Heitz 2014, eq. 64 to 72).
///
/// beckmann: alpha sin theta (exp(-a^2) / (2 sqrt pi) - a erfc(a) / 2), a = cot theta / alpha
/// ggx:      (sqrt(cos^2 theta + alpha^2 sin^2 theta) - cos theta) / 2
/// others:   the integral, by 61 points, about 5 us: to 1e-7 of alpha sin theta
///           (smith_lambda.tests.cpp, which holds it against the closed forms)
///
/// omega in the upper half-space. The roughness has passed `require_valid`.
inline double back_facing_area(const Roughness& roughness, const Direction& omega) {
  const double cosine = omega.z(), sine = std::hypot(omega.x(), omega.y());
  const double steepest = roughness.alpha * sine;
  if (steepest == 0) return 0;
  switch (roughness.distribution) {
    case Distribution::beckmann: {
      const double a = cosine / steepest;
      if (a > 27) return 0;  // exp(-a^2) underflows
      return steepest * (std::exp(-a * a) * std::numbers::inv_sqrtpi / 2 - a * std::erfc(a) / 2);
    }
    case Distribution::ggx:
      return steepest * steepest / (2 * (std::hypot(cosine, steepest) + cosine));
    case Distribution::blinn_phong:
    case Distribution::gtr:
      break;
  }
  // Only facets within theta of the horizon face away, of the order of sin^3 theta.
  if (sine < 1e-30) return 0;
  return detail::back_facing_quadrature(roughness, cosine, sine);
}

}  // namespace brdf
