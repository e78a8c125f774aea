// The integral of f_r cos theta_r over the hemisphere, for an amplitude a_x(u) a_y(v).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "brdf/directions.h"

/// The part of (u, v) that matters; all of it unless told.
struct Lobe {
  double half_width_u = 2, half_width_v = 1;
};

/// Light in the plane y = 0. f_r = gain(viewer) (a_x(u) a_y(v))^2.
///
/// With omega_r = (s_x, s_y, .) the measure cos theta_r d omega is ds_x ds_y. s_y by midpoints:
/// under a window the integrand is close to band-limited, and a step below lambda / (2 L) is exact
/// but for the rim. s_x = sqrt(1 - s_y^2) sin t takes 1 / cos theta_r out of the rim; t by four
/// points of Gauss and Legendre on each of many pieces, since a lobe may be cut at the horizon.
template <class AlongX, class AlongY, class Gain>
double albedo_of_separable(const brdf::Direction& light, AlongX a_x, AlongY a_y, Gain gain,
                           Lobe lobe = {}) {
  constexpr std::array node = {0.3399810435848563, 0.8611363115940526};
  constexpr std::array weight = {0.6521451548625461, 0.3478548451374538};
  const bool wide = lobe.half_width_v > 0.1;
  const int lines = wide ? 600 : 40, pieces = wide ? 400 : 60;
  const double dv = 2 * lobe.half_width_v / lines;
  double albedo = 0;
  for (int line = 0; line < lines; ++line) {
    const double sy = (line + 0.5) * dv - lobe.half_width_v;
    const double radius = std::sqrt(1 - sy * sy);
    const auto rim = [&](double sx) { return std::asin(std::clamp(sx / radius, -1.0, 1.0)); };
    const double t_lo = rim(-light.x() - lobe.half_width_u);
    const double half = (rim(-light.x() + lobe.half_width_u) - t_lo) / pieces / 2;
    double along_line = 0;
    for (int piece = 0; piece < pieces; ++piece)
      for (const double side : {-1.0, 1.0})
        for (std::size_t i = 0; i < node.size(); ++i) {
          const double t = t_lo + half * (2 * piece + 1 + side * node[i]);
          const brdf::Direction viewer{radius * std::sin(t), sy, radius * std::cos(t)};
          const double a = a_x(light.x() + viewer.x());
          along_line += half * weight[i] * gain(viewer) * a * a * viewer.z();
        }
    const double a = a_y(sy);
    albedo += dv * a * a * along_line;
  }
  return albedo;
}

/// The cubic through four samples at -1, 0, 1, 2 (their real parts), at 0 <= t <= 1.
inline double cubic(double t, const std::complex<double>* samples) {
  return -samples[0].real() * t * (t - 1) * (t - 2) / 6 +
         samples[1].real() * (t + 1) * (t - 1) * (t - 2) / 2 -
         samples[2].real() * (t + 1) * t * (t - 2) / 2 +
         samples[3].real() * (t + 1) * t * (t - 1) / 6;
}
