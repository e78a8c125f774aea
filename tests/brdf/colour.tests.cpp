#include "brdf/colour.h"

#include <array>
#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/is_error.h"
#include "tests/support/oracle_table.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::Errc;
using brdf::Length;
using brdf::Rgb;
using brdf::Xyz;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

std::vector<Length> wavelengths(const std::vector<double>& lambda_nm) {
  std::vector<Length> result;
  for (const double nm : lambda_nm) result.push_back(Length::nm(nm));
  return result;
}

std::vector<double> even_nm(double first, double last, double step) {
  std::vector<double> lambda_nm;
  for (int i = 0; first + i * step <= last; ++i) lambda_nm.push_back(first + i * step);
  return lambda_nm;
}

/// Ascending, with steps from 0.3 to 12 nm.
std::vector<double> uneven_nm(std::uint64_t seed) {
  Uniform uniform(seed);
  std::vector<double> lambda_nm{uniform(380, 390)};
  while (lambda_nm.back() < 780) lambda_nm.push_back(lambda_nm.back() + uniform(0.3, 12));
  return lambda_nm;
}

brdf::Chromaticity white_xy(const std::vector<double>& lambda_nm) {
  return chromaticity(white_of(brdf::colour_weights(wavelengths(lambda_nm))));
}

}  // namespace

TEST_CASE("the trapezoid is exact for linear functions on uneven grids", "[colour][oracle]") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const std::vector<double> x = uneven_nm(seed), weights = brdf::trapezoid_weights(x);
    REQUIRE(weights.size() == x.size());
    double constant = 0, slope = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      constant += weights[i];
      slope += weights[i] * x[i];
    }
    const double a = x.front(), b = x.back();
    // Some 60 additions of eps / 2 each.
    CHECK(std::abs(constant / (b - a) - 1) <= 30 * eps);
    CHECK(std::abs(slope / ((b * b - a * a) / 2) - 1) <= 30 * eps);
  }
  CHECK(brdf::trapezoid_weights(std::array{1.0, 4.0}) == std::vector{1.5, 1.5});
  CHECK(brdf::trapezoid_weights(std::array{1.0, 2.0, 5.0}) == std::vector{0.5, 2.0, 1.5});
}

TEST_CASE("a weight is the trapezoid of S xbar: exact where rho S ybar is linear",
          "[colour][oracle]") {
  const std::vector<double> x = uneven_nm(4);
  const std::vector<Xyz> weights = brdf::colour_weights(wavelengths(x));
  REQUIRE(weights.size() == x.size());
  double constant = 0, slope = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Length lambda = Length::nm(x[i]);
    const double rho = 1 / (brdf::illuminant_d65(lambda) * brdf::colour_matching(lambda).y);
    constant += weights[i].y * rho;
    slope += weights[i].y * rho * x[i];
  }
  // The common factor drops out of the ratio of Int lambda and Int 1.
  const double mean_nm = (x.front() + x.back()) / 2;
  CHECK(std::abs(slope / constant / mean_nm - 1) <= 60 * eps);
}

TEST_CASE("rho = 1 is the white of D65 with Y = 1", "[colour][oracle]") {
  int compared = 0;
  for (const OracleRow& row : oracle_table("cie_whites.csv")) {
    std::vector<double> v;
    for (const std::string& cell : row) v.push_back(number(cell));
    const std::vector<Xyz> weights = brdf::colour_weights(wavelengths(even_nm(v[0], v[1], v[2])));
    const Xyz white = white_of(weights);
    CAPTURE(v[0], v[1], v[2]);
    CHECK(std::abs(white.y - 1) <= 20 * eps);
    // The trapezoid takes half of each end where the oracle takes all: put the halves back.
    Xyz sum = white + weights.front() + weights.back();
    sum = 1 / sum.y * sum;
    const brdf::Chromaticity xy = chromaticity(sum);
    // Exact but for the six digits printed; between the 5 nm our tables are linear where the
    // CIE's bend, worth 2.8e-5.
    const bool own_steps = v[2] >= 5;
    CHECK(std::abs(xy.x - v[5]) <= (own_steps ? 6e-7 : 3e-5));
    CHECK(std::abs(xy.y - v[6]) <= (own_steps ? 6e-7 : 3e-5));
    if (own_steps) CHECK(std::abs(100 * sum.x - v[3]) <= 6e-7);
    if (own_steps) CHECK(std::abs(100 * sum.z - v[4]) <= 6e-7);
    // As it stands, where the ends weigh next to nothing.
    if (v[0] > 380) continue;
    ++compared;
    CHECK(std::abs(chromaticity(white).x - v[5]) <= 3e-5);
    CHECK(std::abs(chromaticity(white).y - v[6]) <= 3e-5);
  }
  CHECK(compared == 4);
}

TEST_CASE("white hardly depends on the wavelengths", "[colour][invariant]") {
  for (const double step : {1.0, 2.0, 4.0, 5.0}) {
    const brdf::Chromaticity xy = white_xy(even_nm(380, 780, step));
    CAPTURE(step, xy.x, xy.y);
    // The rounding of 0.3127 and 0.3290, that of the tables to 5 nm and the ends.
    CHECK(std::abs(xy.x - 0.3127) <= 1e-4);
    CHECK(std::abs(xy.y - 0.3290) <= 1e-4);
  }
  const brdf::Chromaticity coarse = white_xy(even_nm(400, 700, 10));
  CHECK(std::abs(coarse.x - 0.3127) <= 7e-4);  // what lies outside 400 to 700 nm
  CHECK(std::abs(coarse.y - 0.3290) <= 7e-4);
  // Uneven steps up to 12 nm.
  for (const std::uint64_t seed : {5u, 6u, 7u}) {
    const brdf::Chromaticity xy = white_xy(uneven_nm(seed));
    CHECK(std::abs(xy.x - 0.3127) <= 1e-3);
    CHECK(std::abs(xy.y - 0.3290) <= 1e-3);
  }
  const std::vector<Xyz> wide = brdf::colour_weights(wavelengths(even_nm(100, 1500, 5)));
  CHECK(wide.front() == Xyz{0, 0, 0});
  CHECK(wide.back() == Xyz{0, 0, 0});
  CHECK(white_of(wide).y == Approx(1).epsilon(1e-14));
}

TEST_CASE("wavelengths without a colour are refused", "[colour][refusal]") {
  const auto weights = [](const std::vector<double>& nm) {
    return brdf::colour_weights(wavelengths(nm));
  };
  CHECK_ERROR(weights({}), Errc::invalid_argument, "2 wavelengths, not 0");
  CHECK_ERROR(weights({550}), Errc::invalid_argument, "2 wavelengths, not 1");
  CHECK_ERROR(weights({0, 550}), Errc::invalid_argument, "0 nm must be > 0");
  CHECK_ERROR(weights({-1, 550}), Errc::invalid_argument, "-1 nm must be > 0");
  CHECK_ERROR(weights({nan_value, 550}), Errc::invalid_argument, "nan nm must be > 0");
  CHECK_ERROR(weights({550, inf}), Errc::invalid_argument, "inf nm must be finite");
  CHECK_ERROR(weights({550, nan_value}), Errc::invalid_argument, "nan nm must be finite");
  CHECK_ERROR(weights({500, nan_value, 600}), Errc::invalid_argument, "nan nm must be above");
  CHECK_ERROR(weights({500, 500}), Errc::invalid_argument, "500 nm must be above");
  CHECK_ERROR(weights({500, 600, 550}), Errc::invalid_argument, "550 nm must be above");
  CHECK_ERROR(weights({900, 950}), Errc::invalid_argument, "900 to 950 nm");
  CHECK_ERROR(weights({100, 200, 300}), Errc::invalid_argument, "100 to 300 nm");
  CHECK_ERROR(weights({300, 900}), Errc::invalid_argument, "between 360 and 830 nm");
}

TEST_CASE("a wavelength has its colour in sRGB", "[colour][oracle]") {
  WorstError linear, encoded;
  for (const OracleRow& row : oracle_table("cie_monochromatic.csv")) {
    const Rgb rgb = linear_srgb(brdf::colour_matching(Length::nm(number(row[0]))));
    linear.see(std::abs(rgb.r - number(row[4])));
    linear.see(std::abs(rgb.g - number(row[5])));
    linear.see(std::abs(rgb.b - number(row[6])));
    CHECK(clipped_to_gamut(rgb).clipped);
    const double largest = std::max({rgb.r, rgb.g, rgb.b});
    const Rgb shown = brdf::srgb_encoded(
        brdf::clipped_to_gamut({rgb.r / largest, rgb.g / largest, rgb.b / largest}).rgb);
    encoded.see(std::abs(shown.r - number(row[7])));
    encoded.see(std::abs(shown.g - number(row[8])));
    encoded.see(std::abs(shown.b - number(row[9])));
  }
  CHECK(linear.value() <= 5.1e-7);   // six decimals printed
  CHECK(encoded.value() <= 5.1e-5);  // four
}

TEST_CASE("the matrix of sRGB has its primaries and its white", "[colour][oracle]") {
  // The inverse as printed with 8 decimals by another program.
  const std::array<Xyz, 3> printed{Xyz{3.24096994, -1.53738318, -0.49861076},
                                   Xyz{-0.96924364, 1.8759675, 0.04155506},
                                   Xyz{0.05563008, -0.20397696, 1.05697151}};
  WorstError error;
  for (std::size_t i = 0; i < 3; ++i) {
    error.see(std::abs(brdf::xyz_to_srgb[i].x - printed[i].x));
    error.see(std::abs(brdf::xyz_to_srgb[i].y - printed[i].y));
    error.see(std::abs(brdf::xyz_to_srgb[i].z - printed[i].z));
  }
  CHECK(error.value() <= 5.1e-9);
  // D65 with Y = 1 over 360 to 830 nm in steps of 1 nm.
  const Rgb white = brdf::linear_srgb({0.95047070, 1, 1.08882846});
  CHECK(std::abs(white.r - 1.00016221) <= 1e-7);  // the white's last digits
  CHECK(std::abs(white.g - 0.99997615) <= 1e-7);
  CHECK(std::abs(white.b - 0.99975847) <= 1e-7);
  // A primary excites one component only.
  const Rgb red = linear_srgb(brdf::at_unit_luminance({0.64, 0.33}));
  CHECK(red.r > 1);
  CHECK(std::abs(red.g) <= 4 * eps * red.r);
  CHECK(std::abs(red.b) <= 4 * eps * red.r);
}

TEST_CASE("CIE RGB undoes the CIE's matrix from RGB to XYZ", "[colour][oracle]") {
  // Columns of the matrix that defines XYZ, whose rows add up to 1 or 0.99999: the primaries.
  const std::array<Xyz, 3> primaries{Xyz{0.49, 0.17697, 0}, Xyz{0.31, 0.81240, 0.01},
                                     Xyz{0.20, 0.01063, 0.99}};
  WorstError error;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rgb rgb = cie_rgb(primaries[i]);
    error.see(std::abs(rgb.r - (i == 0 ? 1 : 0)));
    error.see(std::abs(rgb.g - (i == 1 ? 1 : 0)));
    error.see(std::abs(rgb.b - (i == 2 ? 1 : 0)));
  }
  const Rgb white = brdf::cie_rgb({1, 1, 1});
  for (const double component : {white.r, white.g, white.b}) error.see(std::abs(component - 1));
  CHECK(error.value() <= 1e-4);  // five digits of the printed inverse, divided by 0.17697
}

TEST_CASE("the transfer curve has its published values", "[colour][oracle]") {
  CHECK(std::abs(brdf::srgb_encoded(0.5) - 0.7353569830524495) <= 2 * eps);
  CHECK(std::abs(brdf::srgb_encoded(0.18) - 0.46135612950044164) <= 2 * eps);
  CHECK(std::abs(brdf::srgb_encoded(0.0031308) - 0.040449936) <= 2 * eps);
  CHECK(brdf::srgb_encoded(0.0) == 0);
  CHECK(brdf::srgb_encoded(1.0) == 1);
  CHECK(std::abs(brdf::srgb_encoded(-0.01) + 0.1292) <= 2 * eps);
  CHECK(std::isnan(brdf::srgb_encoded(nan_value)));
  CHECK(std::isnan(brdf::srgb_decoded(nan_value)));
}

TEST_CASE("the transfer curve comes back, also at its join", "[colour][crossover]") {
  Uniform uniform(8);
  WorstError relative, at_join;
  constexpr double join = 0.0031308, near = 1e-8;
  for (int i = 0; i < 20000; ++i) {
    const double x = i % 2 == 0 ? uniform(0, 1) : uniform(0.003, 0.0033);
    if (std::abs(x - join) > near)
      relative.see(std::abs(brdf::srgb_decoded(brdf::srgb_encoded(x)) / x - 1));
  }
  // v has rounded like numbers near 1; at 0.04, 2.4 / (v + 0.055) = 25 takes it to x.
  CHECK(relative.value() <= 40 * eps);
  for (double x = join - 2 * near; x <= join + 2 * near; x += near / 100)
    at_join.see(std::abs(brdf::srgb_decoded(brdf::srgb_encoded(x)) - x));
  // 2.9e-8 of the step, over the slope of 12.92, and 1.2e-10 by which the limits differ.
  CHECK(at_join.value() <= 2.4e-9);
  const double step = brdf::srgb_encoded(std::nextafter(join, 1.0)) - brdf::srgb_encoded(join);
  CHECK(std::abs(step + 2.85e-8) <= 1e-10);
}

TEST_CASE("clipping keeps colours of the gamut and says when it does not", "[colour]") {
  const auto clip = [](Rgb rgb) { return brdf::clipped_to_gamut(rgb); };
  for (const Rgb inside : {Rgb{0, 0, 0}, Rgb{1, 1, 1}, Rgb{0.2, 0, 1}}) {
    CHECK(clip(inside).rgb == inside);
    CHECK_FALSE(clip(inside).clipped);
  }
  CHECK(clip({-0.1, 0.5, 1.5}).rgb == Rgb{0, 0.5, 1});
  for (const Rgb outside :
       {Rgb{-0.1, 0.5, 0.5}, Rgb{0.5, -0.1, 0.5}, Rgb{0.5, 0.5, -0.1}, Rgb{1.1, 0.5, 0.5},
        Rgb{0.5, 1.1, 0.5}, Rgb{0.5, 0.5, 1.1}, Rgb{nan_value, 0.5, 0.5}, Rgb{0.5, 0.5, inf}})
    CHECK(clip(outside).clipped);
  CHECK(std::isnan(clip({nan_value, 0, 0}).rgb.r));
  // The white of any usual wavelengths is white, and half a code of 8 bits is the limit.
  for (const double step : {1.0, 5.0, 10.0}) {
    const std::vector<Xyz> weights = brdf::colour_weights(wavelengths(even_nm(400, 700, step)));
    CHECK_FALSE(clip(linear_srgb(white_of(weights))).clipped);
  }
  for (const double code : {-0.49, 255.49})
    CHECK_FALSE(clip({brdf::srgb_decoded(code / 255), 0, 0}).clipped);
  for (const double code : {-0.51, 255.51})
    CHECK(clip({brdf::srgb_decoded(code / 255), 0, 0}).clipped);
}

TEST_CASE("black has no chromaticity", "[colour]") {
  CHECK(std::isnan(brdf::chromaticity({0, 0, 0}).x));
  const brdf::Chromaticity xy = brdf::chromaticity({1, 2, 5});
  CHECK(xy.x == 0.125);
  CHECK(xy.y == 0.25);
}
