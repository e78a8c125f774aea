#include "brdf/scalar_validity.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/is_error.h"
#include "tests/support/oracle_table.h"

using brdf::Angle;
using brdf::LimitKind;
using brdf::scalar_limit;
using brdf::scalar_verdict;
using brdf::ScalarVerdict;
using brdf::TablePlace;

TEST_CASE("the limits of scalar strengths are those computed rigorously", "[oracle][scalar]") {
  const auto rows = oracle_table("scalar_validity.csv");
  REQUIRE(rows.size() == 24);
  for (const OracleRow& row : rows) {
    const auto limit = scalar_limit(number(row[0]), Angle::deg(number(row[1])));
    INFO(row[0] << " wavelengths, " << row[1] << " deg");
    CHECK(limit.depth_over_lambda == number(row[4]));
    CHECK(limit.place == TablePlace::inside);
    CHECK((limit.kind == LimitKind::untested) == (number(row[4]) == number(row[2])));
  }
}

TEST_CASE("between tabulated places the smallest limit around holds", "[scalar]") {
  // At 60 deg the limit falls from 0.346 to 0.193 as the period grows from 3.57 to 4.55.
  CHECK(scalar_limit(3.58, Angle::deg(60)).depth_over_lambda == 0.193);
  CHECK(scalar_limit(4.54, Angle::deg(60)).depth_over_lambda == 0.193);
  CHECK(scalar_limit(2.9, Angle::deg(75)).depth_over_lambda == 0.071);
  // At 2.86 wavelengths 30 deg is better than normal incidence.
  CHECK(scalar_limit(2.86, Angle::deg(15)).depth_over_lambda == 0.374);
  CHECK(scalar_limit(2.86, Angle::deg(30.1)).depth_over_lambda == 0.212);
  CHECK(scalar_limit(2.86, Angle::deg(30.1)).theta_i.deg() == 60);
}

TEST_CASE("the sign of the angle of incidence does not matter, and 75 deg is the last",
          "[scalar]") {
  CHECK(scalar_limit(3.0, Angle::deg(-60)).depth_over_lambda == 0.212);
  CHECK(scalar_limit(3.57, Angle::deg(89)).depth_over_lambda == 0.087);
  CHECK(scalar_limit(3.57, Angle::deg(89)).theta_i.deg() == 75);
}

TEST_CASE("outside the table the last row is the guide above, nothing below", "[scalar]") {
  const auto above = scalar_limit(6.14, Angle::deg(60));
  CHECK(above.place == TablePlace::beyond);
  CHECK(above.depth_over_lambda == 0.134);
  CHECK(scalar_verdict(above, 0.13, 0.133) == ScalarVerdict::valid);
  CHECK(scalar_verdict(above, 0.2, 0.2) == ScalarVerdict::doubtful);
  const auto below = scalar_limit(1.629, Angle::deg(0));
  CHECK(below.place == TablePlace::below);
  CHECK(below.depth_over_lambda == 0);
  CHECK(scalar_verdict(below, 1e-6, 1e-6) == ScalarVerdict::invalid);
}

TEST_CASE("the verdict turns at the limit", "[scalar][crossover]") {
  const auto measured = scalar_limit(2.86, Angle::deg(75));  // 0.071, failed above
  CHECK(scalar_verdict(measured, 0.0709, 0.0709) == ScalarVerdict::valid);
  CHECK(scalar_verdict(measured, 0.0711, 0.0711) == ScalarVerdict::invalid);
  CHECK(scalar_verdict(measured, 0.0709, 0.0711) == ScalarVerdict::doubtful);
  const auto untested = scalar_limit(3.57, Angle::deg(0));  // 0.5, the deepest computed
  CHECK(scalar_verdict(untested, 0.49, 0.5) == ScalarVerdict::valid);
  CHECK(scalar_verdict(untested, 0.51, 0.52) == ScalarVerdict::doubtful);
}

TEST_CASE("a period that is not positive has no scalar limit", "[scalar]") {
  for (const double period : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK_ERROR(scalar_limit(period, Angle::deg(0)), brdf::Errc::invalid_argument, "must be > 0");
}
