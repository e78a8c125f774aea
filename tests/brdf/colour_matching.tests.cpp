#include "brdf/colour_matching.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/support/oracle_table.h"
#include "tests/support/worst_error.h"

using brdf::colour_matching;
using brdf::illuminant_d65;
using brdf::Length;
using brdf::Xyz;

TEST_CASE("the colour-matching functions are the CIE's at every tabulated wavelength",
          "[colour][oracle]") {
  WorstError error;
  for (const OracleRow& row : oracle_table("cie_monochromatic.csv")) {
    const Xyz colour = colour_matching(Length::nm(number(row[0])));
    error.see(std::abs(colour.x - number(row[1])));
    error.see(std::abs(colour.y - number(row[2])));
    error.see(std::abs(colour.z - number(row[3])));
  }
  CHECK(error.value() <= 1e-10);  // half the digits of the table's 1e-10, and rounding
}

TEST_CASE("the tables sum to the CIE's sums", "[colour][oracle]") {
  // Sums times 5 nm of the tables read in another language, printed with 8 decimals: a slip in
  // any digit that is worth 2e-9 shows.
  const auto integral = [](const brdf::SpectralTable& table) {
    return 5 * std::accumulate(table.begin(), table.end(), 0.0);
  };
  CHECK(std::abs(integral(brdf::cie_1931_x) - 106.86569994) <= 1e-8);
  CHECK(std::abs(integral(brdf::cie_1931_y) - 106.85703925) <= 1e-8);
  CHECK(std::abs(integral(brdf::cie_1931_z) - 106.89332154) <= 1e-8);
  // D65 is 1 at 560 nm by definition, and ybar is 1 at 555 nm.
  CHECK(illuminant_d65(Length::nm(560)) == Approx(1).epsilon(1e-15));
  CHECK(colour_matching(Length::nm(555)).y == Approx(1).epsilon(1e-15));
}

TEST_CASE("between entries the tables are linear", "[colour][invariant]") {
  const Xyz a = colour_matching(Length::nm(555)), b = colour_matching(Length::nm(560));
  for (const double t : {0.2, 0.5, 0.9}) {
    const Xyz between = colour_matching(Length::nm(555 + 5 * t));
    // Rounding of the wavelength, 2 eps of 560 nm, over 5 nm.
    CHECK(std::abs(between.x - ((1 - t) * a.x + t * b.x)) <= 1e-14);
    CHECK(std::abs(between.z - ((1 - t) * a.z + t * b.z)) <= 1e-14);
  }
  CHECK(std::abs(illuminant_d65(Length::nm(362.5)) - (0.466383 + 0.493637) / 2) <= 1e-14);
}

TEST_CASE("outside 360 to 830 nm there is nothing to see", "[colour]") {
  CHECK(colour_matching(Length::nm(360)).x == 0.0001299);
  CHECK(colour_matching(Length::nm(830)).x == 1.251141e-6);
  CHECK(illuminant_d65(Length::nm(830)) == 0.603125);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double lambda_nm : {0.0, -550.0, 359.999, 830.001, 1e300, nan}) {
    CAPTURE(lambda_nm);
    CHECK(colour_matching(Length::nm(lambda_nm)) == Xyz{0, 0, 0});
    CHECK(illuminant_d65(Length::nm(lambda_nm)) == 0);
  }
}
