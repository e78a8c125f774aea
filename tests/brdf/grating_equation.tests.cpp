#include "brdf/grating_equation.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/is_error.h"
#include "tests/support/oracle_table.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::Angle;
using brdf::Errc;
using brdf::Length;

namespace {
// Angles of the tables carry 16 digits; sines carry 2e-16, an angle up to 1/cos(84 deg) = 10 times
// that, 1e-13 deg.
constexpr double table_tolerance_deg = 2e-13;
}  // namespace

TEST_CASE("orders at 75 deg lie where the table says", "[grating_equation][oracle]") {
  WorstError error;
  int evanescent = 0;
  for (const OracleRow& row : oracle_table("grating_equation_75deg.csv"))
    for (int order = 1; order <= 3; ++order) {
      const std::string& cell = row[static_cast<std::size_t>(order) + 1];
      CAPTURE(row[0], row[1], order);
      const auto theta_r = brdf::viewing_angle(order, Length::um(number(row[0])),
                                               Length::um(number(row[1])), Angle::deg(75));
      if (cell == "evan.") {
        ++evanescent;
        CHECK(!theta_r);
        continue;
      }
      REQUIRE(theta_r);
      error.see(std::abs(-theta_r->deg() - number(cell)));  // the table counts the mirror's side
    }
  CHECK(error.value() <= table_tolerance_deg);
  CHECK(evanescent == 2);
}

TEST_CASE("the period comes back from the angles of the table", "[grating_equation][oracle]") {
  WorstError relative;
  for (const OracleRow& row : oracle_table("grating_equation_75deg.csv"))
    for (int order = 1; order <= 3; ++order) {
      const std::string& cell = row[static_cast<std::size_t>(order) + 1];
      if (cell == "evan.") continue;
      const auto period = brdf::period_from_angle(order, Length::um(number(row[1])), Angle::deg(75),
                                                  Angle::deg(-number(cell)));
      REQUIRE(period);
      relative.see(std::abs(period->um() / number(row[0]) - 1));
    }
  CHECK(relative.value() <= 5e-15);  // sines that differ by 0.15 or more, each right to 2e-16
}

TEST_CASE("orders of a sinusoid lie where the table says", "[grating_equation][oracle]") {
  WorstError error;
  for (const OracleRow& row : oracle_table("sinusoid_orders.csv")) {
    const auto theta_r =
        brdf::viewing_angle(static_cast<int>(number(row[6])), Length::um(number(row[3])),
                            Length::um(number(row[4])), Angle::deg(number(row[5])));
    REQUIRE(theta_r);
    error.see(std::abs(theta_r->deg() - number(row[7])));
  }
  CHECK(error.value() <= table_tolerance_deg);
}

TEST_CASE("angle and period are each other's inverse", "[grating_equation][invariant]") {
  constexpr std::uint64_t seed = 41;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError relative;
  int propagating = 0;
  for (int i = 0; i < 10000; ++i) {
    const int order = static_cast<int>(uniform(-6, 6));
    const Length period = Length::um(uniform(0.3, 10)), lambda = Length::nm(uniform(380, 780));
    const Angle theta_i = Angle::deg(uniform(-89, 89));
    const auto theta_r = brdf::viewing_angle(order, period, lambda, theta_i);
    if (!theta_r || order == 0) continue;
    ++propagating;
    const auto back = brdf::period_from_angle(order, lambda, theta_i, *theta_r);
    REQUIRE(back);
    relative.see(std::abs(back->um() / period.um() - 1));
  }
  CHECK(propagating >= 3000);
  CHECK(relative.value() <= 2e-14);  // sines of up to 1 whose sum is 0.038 or more
}

TEST_CASE("order zero is the mirror direction at every wavelength and period",
          "[grating_equation][oracle]") {
  for (const double theta_deg : {-60.0, 0.0, 12.5, 75.0})
    for (const double lambda_nm : {380.0, 780.0}) {
      const auto theta_r =
          brdf::viewing_angle(0, Length::um(1.1), Length::nm(lambda_nm), Angle::deg(theta_deg));
      REQUIRE(theta_r);
      CHECK(std::abs(theta_r->deg() + theta_deg) <= 1e-13);  // arcsine of a sine, up to 75 deg
    }
}

TEST_CASE("positive orders lie towards the light, negative ones beyond the mirror",
          "[grating_equation][oracle]") {
  const auto at = [](int order) {
    return brdf::viewing_angle(order, Length::um(2), Length::nm(500), Angle::deg(30));
  };
  // sin theta_r = m / 4 - 1 / 2.
  REQUIRE(at(1));
  REQUIRE(at(-1));
  CHECK(std::abs(std::sin(at(1)->rad()) + 0.25) <= 2e-16);
  CHECK(std::abs(std::sin(at(-1)->rad()) + 0.75) <= 2e-16);
  REQUIRE(at(4));  // back to the light
  CHECK(std::abs(at(4)->deg() - 30) <= 1e-13);
  CHECK(!at(-3));  // sine -1.25
  CHECK(!at(7));   // sine 1.25
}

TEST_CASE("an order at the horizon exists and one beyond is empty",
          "[grating_equation][crossover]") {
  const auto horizon = brdf::viewing_angle(2, Length::um(1), Length::um(0.5), Angle{});
  REQUIRE(horizon);
  CHECK(horizon->deg() == 90);
  const double beyond_um = std::nextafter(0.5, 1.0);
  CHECK(!brdf::viewing_angle(2, Length::um(1), Length::um(beyond_um), Angle{}));
  CHECK(!brdf::viewing_angle(-2, Length::um(1), Length::um(beyond_um), Angle{}));
}

TEST_CASE("no period puts an order on the wrong side of the mirror direction",
          "[grating_equation][invariant]") {
  const Length lambda = Length::nm(550);
  const Angle theta_i = Angle::deg(30);
  for (const double theta_r_deg : {-29.0, 0.0, 60.0}) {
    CHECK(brdf::period_from_angle(1, lambda, theta_i, Angle::deg(theta_r_deg)));
    CHECK(!brdf::period_from_angle(-1, lambda, theta_i, Angle::deg(theta_r_deg)));
  }
  for (const double theta_r_deg : {-31.0, -80.0}) {
    CHECK(!brdf::period_from_angle(1, lambda, theta_i, Angle::deg(theta_r_deg)));
    CHECK(brdf::period_from_angle(-1, lambda, theta_i, Angle::deg(theta_r_deg)));
  }
  for (const int order : {-1, 0, 1})  // on the mirror direction itself
    CHECK(!brdf::period_from_angle(order, lambda, theta_i, Angle::deg(-30)));
  CHECK(!brdf::period_from_angle(0, lambda, theta_i, Angle::deg(10)));
}

TEST_CASE("a period or wavelength that is not positive is refused",
          "[grating_equation][invariant]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Length um = Length::um(1);
  CHECK_ERROR(brdf::viewing_angle(1, Length{}, um, {}), Errc::invalid_argument, "period 0 um");
  CHECK_ERROR(brdf::viewing_angle(1, Length::um(-2), um, {}), Errc::invalid_argument, "period -2");
  CHECK_ERROR(brdf::viewing_angle(1, Length::um(nan), um, {}), Errc::invalid_argument,
              "period nan");
  CHECK_ERROR(brdf::viewing_angle(1, um, Length{}, {}), Errc::invalid_argument, "wavelength 0 um");
  CHECK_ERROR(brdf::viewing_angle(1, um, Length::um(nan), {}), Errc::invalid_argument,
              "wavelength nan");
}

TEST_CASE("what is no angle or no wavelength is refused, not called evanescent",
          "[grating_equation][invariant]") {
  const Angle none = Angle::rad(std::numeric_limits<double>::quiet_NaN());
  CHECK_ERROR(brdf::viewing_angle(1, Length::um(2.5), Length::nm(500), none),
              brdf::Errc::invalid_argument, "finite");
  CHECK_ERROR(brdf::period_from_angle(1, Length::nm(-500), Angle::deg(75), Angle::deg(-60)),
              brdf::Errc::invalid_argument, "wavelength");
}
