
#include "brdf/units.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <limits>

#include "brdf/error.h"

using brdf::Angle;
using brdf::Length;

TEST_CASE("a length is the same in every unit it was given in", "[units][invariant]") {
  // Powers of ten are exact in doubles up to 1e22, so each conversion rounds once.
  constexpr double one_rounding = std::numeric_limits<double>::epsilon();
  for (const Length length :
       {Length::m(550e-9), Length::mm(550e-6), Length::um(0.55), Length::nm(550)}) {
    CHECK(std::abs(length.um() / 0.55 - 1) <= 2 * one_rounding);
    CHECK(std::abs(length.nm() / 550 - 1) <= 2 * one_rounding);
    CHECK(std::abs(length.m() / 550e-9 - 1) <= 2 * one_rounding);
  }
  CHECK(Length{}.um() == 0);
}

TEST_CASE("degrees and radians measure the same angle", "[units][invariant]") {
  CHECK(Angle::deg(90).rad() == brdf::pi / 2);
  CHECK(Angle::deg(-180).rad() == -brdf::pi);
  CHECK(Angle::rad(brdf::pi).deg() == 180);
  CHECK(Angle{}.deg() == 0);
}

TEST_CASE("lengths and angles compare by their size", "[units][invariant]") {
  CHECK(Length::nm(549) < Length::um(0.55));
  CHECK(Length::mm(1) == Length::um(1000));
  CHECK(Angle::deg(-1) < Angle::deg(1));
  CHECK(Angle::deg(1) != Angle::deg(2));
}

TEST_CASE("the wavenumber is 2 pi over the wavelength in micrometres", "[units][oracle]") {
  CHECK(brdf::wavenumber_per_um(Length::nm(500)) == 4 * brdf::pi);
}

TEST_CASE("an error carries its code and its message", "[error][invariant]") {
  const brdf::Error error(brdf::Errc::over_limit, "too large");
  CHECK(error.code() == brdf::Errc::over_limit);
  CHECK(std::string(error.what()) == "too large");
}

TEST_CASE("numbers in messages read back as the same double", "[error][invariant]") {
  CHECK(brdf::text(0.1) == "0.1");
  CHECK(brdf::text(-5) == "-5");
  CHECK(brdf::text(0) == "0");
  // The longest doubles: 17 digits, a sign and a three-digit exponent.
  for (const double value : {-1.7976931348623157e308, 2.2250738585072014e-308,
                             -4.9406564584124654e-324, 1.0 / 3, 2e22 / 3})
    CHECK(std::strtod(brdf::text(value).c_str(), nullptr) == value);
  CHECK(brdf::text(std::numeric_limits<double>::infinity()) == "inf");
  CHECK(brdf::text(std::numeric_limits<double>::quiet_NaN()) == "nan");
}

TEST_CASE("degrees given are the degrees said again, and radians likewise", "[units][invariant]") {
  for (int hundredths = -18000; hundredths <= 18000; ++hundredths) {
    const double value = hundredths / 100.0;
    REQUIRE(Angle::deg(value).deg() == value);
    REQUIRE(Angle::rad(value).rad() == value);
  }
}
