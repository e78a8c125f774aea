#include "brdf/colour_difference.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/oracle_table.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::ciede2000;
using brdf::Lab;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("CIEDE2000 is that of the published pairs", "[colour][oracle]") {
  WorstError error, asymmetry;
  int pairs = 0;
  for (const OracleRow& row : oracle_table("ciede2000_pairs.csv")) {
    const Lab first{number(row[0]), number(row[1]), number(row[2])};
    const Lab second{number(row[3]), number(row[4]), number(row[5])};
    const double difference = ciede2000(first, second), published = number(row[6]);
    CAPTURE(++pairs, difference, published);
    CHECK(std::abs(difference - published) <= 1e-4);
    error.see(std::abs(difference - published));
    asymmetry.see(std::abs(difference - ciede2000(second, first)));
  }
  CHECK(pairs == 34);
  CHECK(error.value() <= 5.1e-5);  // half the last digit printed
  CHECK(asymmetry.value() <= 64 * eps * 32);
}

TEST_CASE("CIEDE2000 is symmetric, positive, and 0 for equal colours", "[colour][invariant]") {
  Uniform uniform(21);
  const auto random = [&] { return Lab{uniform(0, 100), uniform(-128, 128), uniform(-128, 128)}; };
  WorstError asymmetry;
  bool all_positive = true;
  for (int i = 0; i < 5000; ++i) {
    const Lab a = random(), b = random();
    const double difference = ciede2000(a, b);
    asymmetry.see(std::abs(difference - ciede2000(b, a)));
    all_positive = all_positive && difference > 0;
    CHECK(ciede2000(a, a) == 0);
  }
  CHECK(all_positive);
  // Some 100 roundings of differences up to 120.
  CHECK(asymmetry.value() <= 100 * eps * 120);
}

TEST_CASE("between greys CIEDE2000 is the difference in lightness, weighed", "[colour][oracle]") {
  // Equation 16 of the paper: S_L = 1 + 0.015 (L - 50)^2 / sqrt(20 + (L - 50)^2), at the mean L.
  CHECK(ciede2000({49, 0, 0}, {51, 0, 0}) == Approx(2).epsilon(1e-14));
  CHECK(ciede2000({0, 0, 0}, {100, 0, 0}) == Approx(100).epsilon(1e-14));
  CHECK(ciede2000({69, 0, 0}, {71, 0, 0}) ==
        Approx(2 / (1 + 0.015 * 400 / std::sqrt(420.0))).epsilon(1e-14));
}

TEST_CASE("CIELAB has its closed forms", "[colour][oracle]") {
  const auto grey = [](double y) { return brdf::lab(y * brdf::d65_white); };
  const auto at = [](const Lab& lab, double l, double a, double b) {
    CAPTURE(lab.l, lab.a, lab.b);
    // Differences of numbers up to 1, times 500: some eps of it.
    CHECK(std::abs(lab.l - l) <= 500 * 2 * eps);
    CHECK(std::abs(lab.a - a) <= 500 * 2 * eps);
    CHECK(std::abs(lab.b - b) <= 500 * 2 * eps);
  };
  at(grey(1), 100, 0, 0);
  at(grey(0), 0, 0, 0);
  at(grey(std::pow(66.0 / 116, 3)), 50, 0, 0);
  at(grey(std::pow(6.0 / 29, 3)), 8, 0, 0);  // the join
  // Below it L = (29/3)^3 Y.
  at(grey(0.004), 0.004 * std::pow(29.0 / 3, 3), 0, 0);
  // f(8/27) = 2/3, f(1/8) = 1/2.
  const brdf::Xyz white = brdf::d65_white;
  at(brdf::lab({8.0 / 27 * white.x, 1, white.z / 8}), 100, -500.0 / 3, 100);
  at(brdf::lab({1, 1, 1}, {1, 1, 1}), 100, 0, 0);
}

TEST_CASE("CIELAB is smooth where its pieces meet", "[colour][crossover]") {
  const double join = std::pow(6.0 / 29, 3);
  double below = join, above = join;
  for (int i = 0; i < 4; ++i) {
    below = std::nextafter(below, 0.0);
    above = std::nextafter(above, 1.0);
  }
  const double step = brdf::lab({0, above, 0}).l - brdf::lab({0, below, 0}).l;
  CHECK(std::abs(step) <= 116 * 4 * eps);
  // The tangent: slopes on both sides are (29/3)^3, but for the curvature over 1e-7.
  const double h = 1e-7;
  const auto l = [](double y) { return brdf::lab({0, y, 0}).l; };
  CHECK((l(join + h) - l(join)) / h == Approx((l(join) - l(join - h)) / h).epsilon(2e-5));
}

TEST_CASE("the primaries of sRGB have their published CIELAB", "[colour][oracle]") {
  // XYZ of the red primary at (1, 0, 0); L, a, b as colour tools print them.
  const Lab red = brdf::lab({0.41239080, 0.21263901, 0.01933082});
  CHECK(std::abs(red.l - 53.24) <= 0.01);
  CHECK(std::abs(red.a - 80.09) <= 0.01);
  CHECK(std::abs(red.b - 67.20) <= 0.01);
}

TEST_CASE("NaN stays NaN in a colour difference", "[colour]") {
  CHECK(std::isnan(ciede2000({nan_value, 1, 1}, {50, 1, 1})));
  CHECK(std::isnan(ciede2000({50, 1, 1}, {50, 1, nan_value})));
  CHECK(std::isnan(brdf::lab({nan_value, 1, 1}).a));
}
