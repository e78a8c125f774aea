// From a spectrum to a colour: CIE XYZ, CIE RGB, and sums over wavelengths.
#include "brdf/colour.h"

#include <catch2/catch.hpp>
#include <vector>

#include "brdf/colour_difference.h"
#include "tests/support/figure.h"
#include "tests/support/worst_error.h"

using brdf::Length;
using brdf::Rgb;
using brdf::Xyz;

namespace {

/// Wavelengths from `first` to `last` in even steps.
std::vector<Length> even(int first_nm, int last_nm, int step_nm) {
  std::vector<Length> wavelengths;
  for (int nm = first_nm; nm <= last_nm; nm += step_nm) wavelengths.push_back(Length::nm(nm));
  return wavelengths;
}

/// 5 nm up to 550 nm, 10 nm beyond.
std::vector<Length> finer_in_the_blue() {
  std::vector<Length> wavelengths = even(400, 550, 5);
  const std::vector<Length> red = even(560, 700, 10);
  wavelengths.insert(wavelengths.end(), red.begin(), red.end());
  return wavelengths;
}

Xyz white(const std::vector<Length>& wavelengths) {
  return white_of(brdf::colour_weights(wavelengths));
}

/// The listing: S xbar added up, without a step, for rho = 1.
Xyz printed_plain_sum(const std::vector<Length>& wavelengths) {
  Xyz sum;
  for (const Length lambda : wavelengths)
    sum = sum + brdf::illuminant_d65(lambda) * brdf::colour_matching(lambda);
  return sum;
}

Xyz at_unit_luminance(const Xyz& colour) {
  return 1 / colour.y * colour;
}

/// M without its factor.
Rgb printed_m(const Xyz& c) {
  return {0.41847 * c.x - 0.15866 * c.y - 0.082835 * c.z,
          -0.091169 * c.x + 0.25243 * c.y + 0.015708 * c.z,
          0.00092090 * c.x - 0.0025498 * c.y + 0.17860 * c.z};
}

/// D65 M, of a colour that has D65 in it already.
Rgb printed_implementation_chapter(const Xyz& colour) {
  const Rgb rgb = printed_m(colour);
  return {0.95047 * rgb.r, rgb.g, 1.08883 * rgb.b};
}

/// CIE RGB back to XYZ, by the matrix that defines it.
Xyz xyz_of_cie_rgb(const Rgb& c) {
  return {0.49 * c.r + 0.31 * c.g + 0.20 * c.b, 0.17697 * c.r + 0.81240 * c.g + 0.01063 * c.b,
          0.01 * c.g + 0.99 * c.b};
}

}  // namespace

TEST_CASE("Thesis 1.19, 1.20: rho = 1 under S = D65 is the white of D65", "[identity][oracle]") {
  // The chromaticity that the CIE states for D65, 0.31272 and 0.32903.
  WorstError error;
  for (const int step_nm : {1, 5}) {
    const brdf::Chromaticity xy = chromaticity(white(even(380, 780, step_nm)));
    error.see(std::abs(xy.x - 0.31272));
    error.see(std::abs(xy.y - 0.32903));
  }
  // Linear tables (3e-5) and the cut at 380 and 780 nm (2e-5).
  CHECK(figure("Thesis 1.19, 1.20", "x, y of rho = 1, 380 to 780 nm", error.value()) <= 5e-5);
}

TEST_CASE("Erratum E20: M lacks its factor, so white is 0.177", "[identity][erratum][E20]") {
  // Equal energy is the white of CIE RGB.
  WorstError off;
  const Rgb right = brdf::cie_rgb({1, 1, 1}), printed = printed_m({1, 1, 1});
  for (const double component : {right.r, right.g, right.b}) off.see(std::abs(component - 1));
  CHECK(figure("E20", "equal energy in CIE RGB, from 1", off.value()) <= 1e-4);
  CHECK(figure("E20", "equal energy by M as printed; right: 1", printed.r) ==
        Approx(0.17697).epsilon(1e-3));
}

TEST_CASE("Erratum E20: with D65 twice, white is bluish", "[identity][erratum][E20]") {
  const Xyz d65 = white(even(380, 780, 5));
  const Xyz once = xyz_of_cie_rgb(brdf::cie_rgb(d65));
  CHECK(std::abs(chromaticity(once).x - 0.3127) <= 1e-4);  // the digits of M
  CHECK(std::abs(chromaticity(once).y - 0.3290) <= 1e-4);
  // The factor put back, so that only the second D65 is left.
  const Rgb printed = printed_implementation_chapter(1 / 0.17697 * d65);
  const brdf::Chromaticity twice = chromaticity(xyz_of_cie_rgb(printed));
  // Both figures from another program, which forms the hue's bisector in another way.
  CHECK(figure("E20", "x of white with D65 twice; right: 0.3127", twice.x) ==
        Approx(0.30355).epsilon(1e-4));
  const double difference = ciede2000(brdf::lab(d65), brdf::lab(xyz_of_cie_rgb(printed)));
  CHECK(figure("E20", "CIEDE2000 of white with D65 twice; right: 0", difference) ==
        Approx(5.4952).epsilon(1e-4));
}

TEST_CASE("Erratum E24: a plain sum grows with the number of wavelengths",
          "[identity][erratum][E24]") {
  const Xyz coarse = printed_plain_sum(even(380, 780, 5)),
            fine = printed_plain_sum(even(380, 780, 1));
  CHECK(figure("E24", "Y at 1 nm over Y at 5 nm by a plain sum; right: 1", fine.y / coarse.y) ==
        Approx(5).epsilon(1e-3));
  CHECK(white(even(380, 780, 1)).y / white(even(380, 780, 5)).y == Approx(1).epsilon(1e-14));
}

TEST_CASE("Erratum E24: a plain sum takes the ends whole", "[identity][erratum][E24]") {
  // Scaled to Y = 1; the trapezoid takes half of 400 and of 700 nm.
  const std::vector<Length> wavelengths = even(400, 700, 10);
  const Xyz plain = at_unit_luminance(printed_plain_sum(wavelengths));
  const Xyz trapezoid = white(wavelengths);
  // From another program; about half of S zbar of 400 nm, 0.056, over a sum of 11.5.
  CHECK(figure("E24", "Z of a plain sum over that of the trapezoid, less 1",
               plain.z / trapezoid.z - 1) == Approx(0.0022955).epsilon(1e-4));
}

TEST_CASE("Erratum E24: on uneven steps a plain sum has another colour",
          "[identity][erratum][E24]") {
  const Xyz d65 = white(even(400, 700, 5)), uneven = white(finer_in_the_blue());
  const Xyz plain = at_unit_luminance(printed_plain_sum(finer_in_the_blue()));
  // Both from another program. What is left by the trapezoid is its error at 10 nm.
  CHECK(figure("E24", "CIEDE2000 of white, uneven steps, by the trapezoid",
               ciede2000(brdf::lab(d65), brdf::lab(uneven))) == Approx(0.27188).epsilon(1e-4));
  CHECK(figure("E24", "CIEDE2000 of white, uneven steps, plain sum; right: 0",
               ciede2000(brdf::lab(d65), brdf::lab(plain))) == Approx(20.500).epsilon(1e-4));
}
