#include "evaluation/response_colour.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::Errc;
using brdf::Length;
using brdf::Rgb;
using brdf::Xyz;
using evaluation::response_colours;
using evaluation::ResponseMatrix;
using evaluation::RgbSpace;
using evaluation::shown_colours;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <class Function>
ResponseMatrix response(const std::vector<double>& lambda_nm, Function rho) {
  ResponseMatrix result{{lambda_nm, -1}, {{-10, 0, 20}, -1}, {}};
  result.values.resize(static_cast<Eigen::Index>(lambda_nm.size()), 3);
  for (Eigen::Index row = 0; row < result.values.rows(); ++row)
    for (Eigen::Index column = 0; column < 3; ++column)
      result.values(row, column) = rho(lambda_nm[static_cast<std::size_t>(row)],
                                       result.theta_r_deg[static_cast<std::size_t>(column)]);
  return result;
}

std::vector<double> every_5_nm() {
  std::vector<double> lambda_nm;
  for (double nm = 380; nm <= 780; nm += 5) lambda_nm.push_back(nm);
  return lambda_nm;
}

double white(double, double) {
  return 1;
}

}  // namespace

TEST_CASE("a response of 1 is white at every angle", "[colour][oracle]") {
  const auto colours = response_colours(response(every_5_nm(), white));
  REQUIRE(colours.xyz.size() == 3);
  for (const Xyz& xyz : colours.xyz) {
    CHECK(std::abs(xyz.y - 1) <= 20 * eps);
    CHECK(xyz.x == colours.white.x);
    CHECK(xyz.z == colours.white.z);
    // x, y of the CIE's plain sum over the same wavelengths.
    CHECK(std::abs(chromaticity(xyz).x - 0.312721) <= 3e-5);
    CHECK(std::abs(chromaticity(xyz).y - 0.329031) <= 3e-5);
  }
}

TEST_CASE("each angle has the sum over its own column", "[colour][oracle]") {
  Uniform uniform(31);
  std::vector<double> lambda_nm{390};
  while (lambda_nm.back() < 720) lambda_nm.push_back(lambda_nm.back() + uniform(1, 9));
  const ResponseMatrix r = response(lambda_nm, [&](double, double) { return uniform(0, 2); });
  const auto colours = response_colours(r);
  WorstError error;
  for (Eigen::Index column = 0; column < 3; ++column) {
    // The integrals again, interval by interval, in long double.
    long double x = 0, z = 0, y_of_white = 0;
    for (std::size_t i = 0; i + 1 < lambda_nm.size(); ++i)
      for (const std::size_t j : {i, i + 1}) {
        const Length lambda = Length::nm(lambda_nm[j]);
        const Xyz matching = brdf::colour_matching(lambda);
        const long double half = (static_cast<long double>(lambda_nm[i + 1]) - lambda_nm[i]) / 2;
        const long double power = half * brdf::illuminant_d65(lambda);
        const long double rho = r.values(static_cast<Eigen::Index>(j), column);
        x += power * rho * matching.x;
        z += power * rho * matching.z;
        y_of_white += power * matching.y;
      }
    const Xyz& colour = colours.xyz[static_cast<std::size_t>(column)];
    error.see(std::abs(colour.x - static_cast<double>(x / y_of_white)));
    error.see(std::abs(colour.z - static_cast<double>(z / y_of_white)));
  }
  CHECK(error.value() <= 70 * eps);  // one rounding of some 1 per wavelength
}

TEST_CASE("a response without a colour is refused", "[colour][refusal]") {
  const auto colours = [](const std::vector<double>& nm) {
    return response_colours(response(nm, white));
  };
  CHECK_ERROR(colours({550}), Errc::bad_input, "has 1 wavelength;");
  CHECK_ERROR(colours({200, 300, 379}), Errc::bad_input, "200 to 379 nm");
  CHECK_ERROR(colours({781, 800}), Errc::bad_input, "781 to 800 nm");
  CHECK_ERROR(colours({300, 900}), Errc::bad_input, "300 to 900 nm");
  CHECK_NOTHROW(colours({300, 380}));
  CHECK_NOTHROW(colours({780, 900}));
}

TEST_CASE("what covers the visible badly is said", "[colour]") {
  const auto coverage = [](const std::vector<double>& nm) {
    return response_colours(response(nm, white)).coverage;
  };
  CHECK(coverage(every_5_nm()).spans_visible());
  CHECK(coverage(every_5_nm()).is_fine());
  std::vector<double> tens;
  for (int i = 0; i <= 30; ++i) tens.push_back(400 + i * 10.0);
  CHECK(coverage(tens).spans_visible());
  CHECK(coverage(tens).is_fine());

  CHECK_FALSE(coverage({401, 405, 410, 700}).spans_visible());
  CHECK_FALSE(coverage({400, 405, 410, 699}).spans_visible());
  CHECK(coverage({400, 700}).spans_visible());
  CHECK_FALSE(coverage({400, 700}).is_fine());
  CHECK(coverage({400, 700}).largest_step_nm == 300);
  // Steps in the ultraviolet and the infrared do not matter; those that reach in from there do.
  std::vector<double> wide{200, 380};
  for (int i = 1; i <= 40; ++i) wide.push_back(380 + i * 10.0);
  wide.push_back(1000);
  CHECK(coverage(wide).is_fine());
  CHECK(coverage(wide).largest_step_nm == 10);
  wide.erase(wide.begin() + 1);
  CHECK_FALSE(coverage(wide).is_fine());
  CHECK(coverage(wide).first_nm == 200);
  CHECK(coverage(wide).last_nm == 1000);
}

TEST_CASE("colours are shown in each space, clipped and counted", "[colour]") {
  const Xyz grey{0.95047 * 0.18, 0.18, 1.08883 * 0.18}, green{0.1, 0.8, 0.1};
  const auto srgb = shown_colours({grey, green}, RgbSpace::srgb, 1);
  REQUIRE(srgb.rgb.size() == 2);
  CHECK(srgb.clipped == 1);
  // 0.18 of the white: encoded 0.46136, but for the digits of the white (2e-4, times the slope).
  for (const double component : {srgb.rgb[0].r, srgb.rgb[0].g, srgb.rgb[0].b})
    CHECK(std::abs(component - 0.461356) <= 1e-4);
  CHECK(srgb.rgb[1].r == 0);

  // Linear: twice the exposure, twice the value.
  const auto once = shown_colours({grey}, RgbSpace::cie, 1);
  const auto twice = shown_colours({grey}, RgbSpace::cie, 2);
  CHECK(once.clipped == 0);
  CHECK(once.rgb[0] == brdf::cie_rgb(grey));
  CHECK(twice.rgb[0].g == Approx(2 * once.rgb[0].g).epsilon(1e-14));
  // In sRGB the exposure comes before the curve: 2 x 0.18 is 0.6343, not 2 x 0.4614.
  CHECK(std::abs(shown_colours({grey}, RgbSpace::srgb, 2).rgb[0].g - 0.634253) <= 1e-4);
  const auto bright = shown_colours({grey, green}, RgbSpace::srgb, 100);
  CHECK(bright.clipped == 2);
  CHECK(bright.rgb[0] == Rgb{1, 1, 1});
}

TEST_CASE("an exposure that is no factor is refused", "[colour][refusal]") {
  for (const double exposure : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity()})
    CHECK_ERROR(shown_colours({}, RgbSpace::srgb, exposure), Errc::invalid_argument, "exposure");
}

TEST_CASE("the CSV of colours has a row per angle", "[colour]") {
  CHECK(evaluation::to_csv({{-10, 20}, 1}, {{0.25, 0.5, 1}, {0, 0, 0}},
                           {{0.125, 0.75, 1}, {0, 0, 0}}) ==
        "theta_r_deg,X,Y,Z,R,G,B\n-10.0,0.25,0.5,1,0.125,0.75,1\n20.0,0,0,0,0,0,0\n");
}
