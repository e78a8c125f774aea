// How different two colours look: CIELAB and CIEDE2000.
#pragma once

#include <algorithm>
#include <cmath>

#include "brdf/colour_matching.h"

namespace brdf {

/// The white of D65 with Y = 1, to the five digits of its sum over 360 to 830 nm in steps of 1 nm.
inline constexpr Xyz d65_white{0.95047, 1, 1.08883};

/// CIELAB: lightness 0 to 100, a towards red, b towards yellow.
struct Lab {
  double l = 0, a = 0, b = 0;
};

/// CIELAB of a colour (CIE 015): L = 116 f(Y / Y_n) - 16, a = 500 (f(X / X_n) - f(Y / Y_n)),
/// b = 200 (f(Y / Y_n) - f(Z / Z_n)); f is the cube root, and below (6/29)^3 the straight line that
/// touches it.
///
/// colour: scaled as the white, components > 0 of it; the line serves those below 0 too.
inline Lab lab(const Xyz& colour, const Xyz& white = d65_white) {
  const auto f = [](double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  };
  const double x = f(colour.x / white.x), y = f(colour.y / white.y), z = f(colour.z / white.z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// The colour difference CIEDE2000 with k_L = k_C = k_H = 1; about 1 is just noticeable.
///
/// Symmetric; 0 for equal colours. Within 5e-5, half their last digit, of the 34 pairs of Sharma,
/// Wu and Dalal (colour_difference.tests.cpp). Hues exactly opposite have no mean hue: the mean is
/// then h_1 and h_2's plain one, as the pairs ask for, also where rounding puts them a bit further
/// apart; beyond, the function jumps (by up to 0.06 in those pairs).
///
/// Source: G. Sharma, W. Wu, E. N. Dalal, The CIEDE2000 color-difference formula, Color Research
/// and Application 30 (2005), 21-30, equations 2 to 22.
inline double ciede2000(const Lab& first, const Lab& second) {
  const auto radians = [](double degrees) { return degrees * (pi / 180); };
  const auto cosine = [&](double degrees) { return std::cos(radians(degrees)); };
  // C^7 / (C^7 + 25^7)
  const auto saturation = [](double chroma) {
    const double c7 = std::pow(chroma, 7);
    return c7 / (c7 + 6103515625.0);
  };

  const double mean_cab = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2;
  const double stretch = 1 + 0.5 * (1 - std::sqrt(saturation(mean_cab)));
  struct Polar {
    double chroma, hue_deg;
  };
  const auto polar = [&](const Lab& c) -> Polar {
    const double a = stretch * c.a;
    const double hue_deg = std::atan2(c.b, a) * (180 / pi);
    return {std::hypot(a, c.b), hue_deg < 0 ? hue_deg + 360 : hue_deg};
  };
  const Polar p = polar(first), q = polar(second);

  // One hue where a colour is grey; else the shorter way round.
  constexpr double opposite_deg = 180 + 1e-9;
  const bool grey = p.chroma * q.chroma == 0;
  double turn_deg = grey ? 0 : q.hue_deg - p.hue_deg;
  double hue_deg = p.hue_deg + q.hue_deg;
  if (std::abs(turn_deg) > opposite_deg) {
    turn_deg += turn_deg < 0 ? 360 : -360;
    hue_deg += hue_deg < 360 ? 360 : -360;
  }
  if (!grey) hue_deg /= 2;

  const double dl = second.l - first.l, dc = q.chroma - p.chroma;
  const double dh = 2 * std::sqrt(p.chroma * q.chroma) * std::sin(radians(turn_deg / 2));
  const double l = (first.l + second.l) / 2, c = (p.chroma + q.chroma) / 2;
  const double t = 1 - 0.17 * cosine(hue_deg - 30) + 0.24 * cosine(2 * hue_deg) +
                   0.32 * cosine(3 * hue_deg + 6) - 0.20 * cosine(4 * hue_deg - 63);
  const double from_middle = (l - 50) * (l - 50), from_blue = (hue_deg - 275) / 25;
  const double l_term = dl / (1 + 0.015 * from_middle / std::sqrt(20 + from_middle));
  const double c_term = dc / (1 + 0.045 * c);
  const double h_term = dh / (1 + 0.015 * c * t);
  const double rotation =
      -std::sin(radians(60 * std::exp(-from_blue * from_blue))) * 2 * std::sqrt(saturation(c));
  const double square =
      l_term * l_term + c_term * c_term + h_term * h_term + rotation * c_term * h_term;
  // Not below 0 but by rounding: abs(rotation) < 2. A NaN stays one.
  return std::sqrt(square < 0 ? 0 : square);
}

}  // namespace brdf
