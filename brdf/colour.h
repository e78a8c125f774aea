// From spectra to colours: weights of wavelengths, tristimulus values, RGB, the transfer curve.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "brdf/colour_matching.h"
#include "brdf/error.h"

namespace brdf {

/// Weights of the trapezoid rule on ascending points: half the distance between the neighbours of
/// a point, half that to the only neighbour at an end. Exact for linear functions.
///
/// points: at least 2, in the unit of the result.
inline std::vector<double> trapezoid_weights(std::span<const double> points) {
  std::vector<double> weights(points.size());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double half = (points[i + 1] - points[i]) / 2;
    weights[i] += half;
    weights[i + 1] += half;
  }
  return weights;
}

/// The weight of each wavelength in the colour of a spectrum under D65:
/// X = sum_i weight_i.x rho_i is the trapezoid of Int rho S xbar d lambda, and so for Y and Z
/// (Thesis 1.19, 1.20 with S_x = S xbar).
///
/// Normalised by one number, the same trapezoid of S ybar, so that rho = 1 is the white of D65 with
/// Y = 1; X and Z of that white follow from the wavelengths: x and y are 0.3127, 0.3290 to 1e-4 for
/// 380 to 780 nm in steps of up to 5 nm, to 7e-4 for 400 to 700 nm in steps of 10 nm
/// (colour.tests.cpp).
///
/// wavelengths: at least 2, ascending, > 0, finite, in any steps; those outside 360 to 830 nm weigh
/// nothing. Throws Errc::invalid_argument otherwise, and where none of them weighs.
inline std::vector<Xyz> colour_weights(std::span<const Length> wavelengths) {
  const auto refuse = [](const std::string& what) { throw Error(Errc::invalid_argument, what); };
  if (wavelengths.size() < 2)
    refuse("a colour needs at least 2 wavelengths, not " + std::to_string(wavelengths.size()));
  if (!(wavelengths.front().nm() > 0))
    refuse("wavelength " + text(wavelengths.front().nm()) + " nm must be > 0");
  if (!std::isfinite(wavelengths.back().nm()))
    refuse("wavelength " + text(wavelengths.back().nm()) + " nm must be finite");
  std::vector<double> lambda_nm;
  for (const Length wavelength : wavelengths) {
    if (!lambda_nm.empty() && !(wavelength.nm() > lambda_nm.back()))
      refuse("wavelength " + text(wavelength.nm()) + " nm must be above the one before it, " +
             text(lambda_nm.back()) + " nm");
    lambda_nm.push_back(wavelength.nm());
  }

  const std::vector<double> widths = trapezoid_weights(lambda_nm);
  std::vector<Xyz> weights;
  double luminance = 0;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    weights.push_back(widths[i] * illuminant_d65(wavelengths[i]) * colour_matching(wavelengths[i]));
    luminance += weights.back().y;
  }
  if (!(luminance > 0))
    refuse("a colour needs a wavelength between " + text(table_first_nm) + " and " +
           text(table_last_nm) + " nm; there are " + text(lambda_nm.front()) + " to " +
           text(lambda_nm.back()) + " nm");
  for (Xyz& weight : weights) weight = 1 / luminance * weight;
  return weights;
}

/// The colour of rho = 1: the sum of the weights; Y = 1 to rounding.
inline Xyz white_of(std::span<const Xyz> weights) {
  Xyz white;
  for (const Xyz& weight : weights) white = white + weight;
  return white;
}

/// Chromaticity x = X / (X + Y + Z), y likewise.
struct Chromaticity {
  double x, y;
};

/// NaN where X + Y + Z is 0: black has no chromaticity.
constexpr Chromaticity chromaticity(const Xyz& colour) {
  const double sum = colour.x + colour.y + colour.z;
  return {colour.x / sum, colour.y / sum};
}

/// The colour of a chromaticity, y > 0, at Y = 1.
constexpr Xyz at_unit_luminance(const Chromaticity& c) {
  return {c.x / c.y, 1, (1 - c.x - c.y) / c.y};
}

/// Components of a colour with respect to three primaries; linear light unless said otherwise.
struct Rgb {
  double r = 0, g = 0, b = 0;

  constexpr bool operator==(const Rgb&) const = default;
};

/// Rows of a matrix that takes Xyz to Rgb.
using RgbMatrix = std::array<Xyz, 3>;

constexpr Rgb operator*(const RgbMatrix& m, const Xyz& c) {
  const auto row = [&c](const Xyz& r) { return r.x * c.x + r.y * c.y + r.z * c.z; };
  return {row(m[0]), row(m[1]), row(m[2])};
}

/// The matrix for which each primary is a multiple of one unit of its component, and the white is
/// (1, 1, 1). Row r is the cross product of the two other primaries, scaled so that row r times the
/// white is 1: no inverse is formed.
constexpr RgbMatrix rgb_matrix(const std::array<Chromaticity, 3>& primaries, const Xyz& white) {
  RgbMatrix matrix{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Xyz p = at_unit_luminance(primaries[(i + 1) % 3]);
    const Xyz q = at_unit_luminance(primaries[(i + 2) % 3]);
    const Xyz row{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
    matrix[i] = 1 / (row.x * white.x + row.y * white.y + row.z * white.z) * row;
  }
  return matrix;
}

/// Primaries of sRGB (ITU-R BT.709).
inline constexpr std::array<Chromaticity, 3> srgb_primaries{
    Chromaticity{0.64, 0.33}, Chromaticity{0.30, 0.60}, Chromaticity{0.15, 0.06}};

/// XYZ to linear sRGB, from the primaries and the white of IEC 61966-2-1 (ITU-R BT.709):
/// (0.64, 0.33), (0.30, 0.60), (0.15, 0.06), white (0.3127, 0.3290).
///
/// In full double precision: 3.24096994, -1.53738318, ... to 5e-9. The four digits that the
/// standard prints (3.2406, -1.5372, ...) differ by up to 4e-4.
inline constexpr RgbMatrix xyz_to_srgb =
    rgb_matrix(srgb_primaries, at_unit_luminance({0.3127, 0.3290}));

/// Linear sRGB; a component outside 0 to 1 is outside the gamut.
constexpr Rgb linear_srgb(const Xyz& colour) {
  return xyz_to_srgb * colour;
}

/// The inverse of `linear_srgb`, to 4 eps: the primaries, each times its component.
constexpr Xyz xyz_of_linear_srgb(const Rgb& linear) {
  Xyz colour;
  const double components[] = {linear.r, linear.g, linear.b};
  for (std::size_t i = 0; i < 3; ++i) {
    const Xyz primary = at_unit_luminance(srgb_primaries[i]);
    const Xyz& row = xyz_to_srgb[i];
    const double unit = row.x * primary.x + row.y * primary.y + row.z * primary.z;
    colour = colour + components[i] / unit * primary;
  }
  return colour;
}

/// CIE RGB (primaries 700, 546.1 and 435.8 nm, white E): the sources' matrix to its five digits,
/// with the factor 1 / 0.17697 that belongs to it, so that X = Y = Z = 1 is R = G = B = 1 to 1e-4
/// (Implementation chapter, erratum E20).
///
/// D65 has entered with the weights and does not enter again: rho = 1 is (0.841, 1.033, 1.089).
constexpr Rgb cie_rgb(const Xyz& colour) {
  constexpr RgbMatrix printed{Xyz{0.41847, -0.15866, -0.082835}, Xyz{-0.091169, 0.25243, 0.015708},
                              Xyz{0.00092090, -0.0025498, 0.17860}};
  return printed * (1 / 0.17697 * colour);
}

/// The transfer curve of sRGB (IEC 61966-2-1): 12.92 x up to 0.0031308, 1.055 x^(1/2.4) - 0.055
/// above, the latter as 1 + 1.055 (x^(1/2.4) - 1), which is 1 at 1 also in floating point.
///
/// x: linear light, any; below 0 the straight piece goes on. The standard's rounded constants leave
/// a step of -2.9e-8 where the pieces meet, 500 times below a code of 16 bits.
inline double srgb_encoded(double x) {
  return x <= 0.0031308 ? 12.92 * x : 1 + 1.055 * (std::pow(x, 1 / 2.4) - 1);
}

/// The inverse of `srgb_encoded` (IEC 61966-2-1, limit 0.04045): to 2.4e-9 within 1e-8 of the join,
/// to 40 eps elsewhere (colour.tests.cpp).
inline double srgb_decoded(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

inline Rgb srgb_encoded(const Rgb& linear) {
  return {srgb_encoded(linear.r), srgb_encoded(linear.g), srgb_encoded(linear.b)};
}

/// A colour inside the gamut, and whether it had to be moved there.
struct InGamut {
  Rgb rgb;
  bool clipped;
};

/// Clips each component to 0 to 1: the last step on linear light, before the transfer curve.
///
/// A colour counts as clipped where a picture of 8 bits would show it: a component whose code in
/// sRGB would round to less than 0 or more than 255, below -1.5e-4 or above 1.0045 of linear light.
/// White, up to 9e-4 outside (2e-4 for 5 nm), does not. NaN stays NaN and counts.
inline InGamut clipped_to_gamut(const Rgb& linear) {
  const double lowest = srgb_decoded(-0.5 / 255), highest = srgb_decoded(1 + 0.5 / 255);
  const auto inside = [&](double c) { return c >= lowest && c <= highest; };
  const auto clamp = [](double c) { return std::clamp(c, 0.0, 1.0); };
  return {{clamp(linear.r), clamp(linear.g), clamp(linear.b)},
          !(inside(linear.r) && inside(linear.g) && inside(linear.b))};
}

}  // namespace brdf
