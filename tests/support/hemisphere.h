// Integrals over the directions of the facets of a rough surface.
#pragma once

#include <cmath>

#include "brdf/directions.h"

/// Int f(h) (n.h) d omega_h over the upper hemisphere, for an f symmetric in y that is about as
/// wide as the facets of ggx at the roughness `width`.
///
/// Midpoints in the azimuth and in sqrt(1 - u), tan theta_h = width sqrt(u / (1 - u)): u alone
/// would spread the points as the facets of ggx, whose density is divided out; the root puts more
/// of them at the horizon, where an f may grow as 1 / n.h.
template <class Function>
double integral_over_facets(double width, int points, Function f) {
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double left = (i + 0.5) / points, u = 1 - left * left;
    const double tangent = width * std::sqrt(u) / left;
    const double cosine = 1 / std::hypot(1, tangent), sine = tangent * cosine;
    const double spread = width / (width * width * cosine * cosine + sine * sine);
    const double ggx = spread * spread / brdf::pi;
    for (int j = 0; j < points / 2; ++j) {
      const double phi = (j + 0.5) * brdf::pi / (points / 2);
      sum +=
          2 * left * f(brdf::Direction{sine * std::cos(phi), sine * std::sin(phi), cosine}) / ggx;
    }
  }
  return sum / points / (points / 2);
}

/// Int f(omega_r) cos theta_r d omega_r over the upper hemisphere for light in the plane y = 0: the
/// part of the light that a surface of facets reflects. d omega_r = 4 (omega_i.h) d omega_h.
template <class Brdf>
double albedo_of_facets(const brdf::Direction& light, double width, int points, Brdf f) {
  return integral_over_facets(width, points, [&](const brdf::Direction& h) {
    const double facing = light.dot(h);
    const brdf::Direction viewer = 2 * facing * h - light;
    if (facing <= 0 || viewer.z() <= 0) return 0.0;
    return f(viewer) * viewer.z() * 4 * facing / h.z();
  });
}
