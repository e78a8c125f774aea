#include "brdf/synthetic_surface.h"

#include <catch2/catch.hpp>
#include <limits>

#include "brdf/direct_sum.h"
#include "brdf/taylor_series.h"
#include "tests/support/amplitudes.h"
#include "tests/support/is_error.h"
#include "tests/support/oracle_table.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::DirectSum;
using brdf::Errc;
using brdf::Facing;
using brdf::HeightField;
using brdf::Length;
using brdf::pi;
using brdf::Profile;
using brdf::profile_height;
using brdf::ProfileParameters;
using brdf::TaylorSeries;

namespace {

const Length period = Length::um(2.5), height = Length::um(0.2);

ProfileParameters grating(Profile profile, double duty = 0.5, Facing facing = Facing::plus_x) {
  return {.profile = profile, .period = period, .height = height, .duty = duty, .facing = facing};
}

/// |a_m|^2 by both methods; they must agree before either is compared with anything.
double order_power(const ProfileParameters& profile, Eigen::Index samples, int order,
                   double depth_rad) {
  const HeightField field = one_period(profile, samples);
  const brdf::Query q = order_query(order, period.um(), depth_rad / height.um());
  const auto direct = amplitude(DirectSum{}, separate_lines(field), q);
  const auto taylor = amplitude(TaylorSeries({.terms = 40}), separate_lines(field), q);
  // Depths up to 2 pi: the series' terms grow to e^pi / sqrt(2 pi^2) = 5 before they cancel.
  CHECK(std::abs(direct - taylor) <= 1e-14);
  return std::norm(direct);
}

/// The table prints depths with 8 digits; those near a multiple of pi/2 beyond 2 were that number.
double depth_of(const std::string& cell) {
  const double printed = number(cell), quarter = std::round(printed / (pi / 2)) * (pi / 2);
  return std::abs(printed - quarter) < 1e-7 ? quarter : printed;
}

/// (x / sin x)^2 with x = pi a / n: what an edge loses by point sampling with n samples, a the
/// number of turns over the period.
double edge_sampling(double turns, Eigen::Index n) {
  const double x = pi * turns / static_cast<double>(n);
  return x == 0 ? 1 : std::pow(x / std::sin(x), 2);
}

// Powers carry the rounding of an amplitude, about 1e-15, and the table's 16 digits.
constexpr double rounding = 1e-14;

}  // namespace

TEST_CASE("heights of the profiles at chosen phases", "[synthetic_profile][oracle]") {
  const auto at = [](ProfileParameters p, double t) { return profile_height(p, t); };
  const ProfileParameters sinusoid = grating(Profile::sinusoid);
  CHECK(at(sinusoid, 0) == 1);
  CHECK(at(sinusoid, 0.5) == 0);
  CHECK(std::abs(at(sinusoid, 0.25) - 0.5) <= 1e-16);  // cos(pi/2) as doubles have it, 6e-17
  CHECK(at(grating(Profile::blazed), 0.25) == 0.75);
  CHECK(at(grating(Profile::blazed), -0.25) == 0.25);
  CHECK(at(grating(Profile::blazed, 0.5, Facing::minus_x), 0.25) == 0.25);
  CHECK(at(grating(Profile::blazed, 0.5, Facing::minus_x), 3.75) == 0.75);
  CHECK(at(grating(Profile::lamellar, 0.3), 0.29) == 1);
  CHECK(at(grating(Profile::lamellar, 0.3), 0.31) == 0);
  CHECK(at(grating(Profile::lamellar, 0.3), -0.01) == 0);
  CHECK(at(grating(Profile::triangle), 0.25) == 0.5);
  CHECK(at(grating(Profile::triangle), -0.25) == 0.5);
  CHECK(at(grating(Profile::flat), 0.4) == 0);
}

TEST_CASE("a phase that rounding leaves just below a whole number is that number",
          "[synthetic_profile][regression]") {
  for (const double t : {1.0 - 1e-10, -1e-10, 7 - 1e-12, 49 * (1.0 / 49)}) {
    CAPTURE(t);
    CHECK(profile_height(grating(Profile::blazed), t) == 1);
    CHECK(profile_height(grating(Profile::blazed, 0.5, Facing::minus_x), t) == 0);
    CHECK(profile_height(grating(Profile::lamellar), t) == 1);
  }
  CHECK(profile_height(grating(Profile::lamellar), 1 - 1e-8) == 0);
}

TEST_CASE("integrals of the profiles have the profiles as slope",
          "[synthetic_profile][invariant]") {
  constexpr int steps = 1000;
  for (const Profile profile :
       {Profile::flat, Profile::sinusoid, Profile::blazed, Profile::lamellar, Profile::triangle})
    for (const Facing facing : {Facing::plus_x, Facing::minus_x}) {
      const ProfileParameters p = grating(profile, 0.3, facing);
      CHECK(brdf::profile_integral(p, 0) == 0);
      for (int i = 0; i < steps; ++i) {
        const double left = static_cast<double>(i) / steps, right = (i + 1.0) / steps;
        const double slope =
            (brdf::profile_integral(p, right) - brdf::profile_integral(p, left)) * steps;
        // Straight pieces are exact but for rounding; of a cosine the third derivative, 4 pi^3, is
        // left, times steps^-2 / 24.
        REQUIRE(std::abs(slope - profile_height(p, (left + right) / 2)) <=
                (profile == Profile::sinusoid ? 5.2e-6 : 1e-12));
      }
    }
}

TEST_CASE("a synthetic grating is its profile about the middle of the patch",
          "[synthetic_profile][invariant]") {
  for (const Profile profile : {Profile::sinusoid, Profile::blazed, Profile::triangle}) {
    const ProfileParameters p = grating(profile);
    const HeightField field = brdf::synthetic_grating(p, 3, 11, Length::um(0.17), Length::um(0.4));
    REQUIRE(field.rows() == 3);
    REQUIRE(field.cols() == 11);
    CHECK(field.dx_um() == 0.17);
    CHECK(field.dy_um() == 0.4);
    for (Eigen::Index row = 0; row < 3; ++row)
      for (Eigen::Index col = 0; col < 11; ++col) {
        const double t = (static_cast<double>(col) - 5) * 0.17 / 2.5;
        // The position is the same product, rounded in another order.
        REQUIRE(std::abs(field.heights_um()(row, col) - 0.2 * profile_height(p, t)) <= 1e-15);
      }
    CHECK(field.heights_um()(1, 5) == 0.2);  // phase 0 is the top of each of these
  }
  const HeightField flat =
      brdf::synthetic_grating(grating(Profile::flat), 2, 2, Length::um(1), Length::um(1));
  CHECK(flat.max_um() == 0);
  CHECK(flat.min_um() == 0);
}

TEST_CASE("an even patch has its phase 0 between two pixels", "[synthetic_profile][crossover]") {
  const HeightField field =
      brdf::synthetic_grating(grating(Profile::triangle), 1, 10, Length::um(0.25), Length::um(1));
  CHECK(std::abs(field.heights_um()(0, 4) - 0.18) <= 1e-15);  // 1 - 2 * 0.05, times 0.2, rounded
  CHECK(std::abs(field.heights_um()(0, 5) - 0.18) <= 1e-15);
}

TEST_CASE("sampled orders have exactly the powers of the sampled table",
          "[synthetic_profile][oracle]") {
  for (const OracleRow& row : oracle_table("sampled_profiles.csv")) {
    const auto n = static_cast<Eigen::Index>(number(row[0]));
    const int order = static_cast<int>(number(row[1]));
    CAPTURE(n, order);
    const double rising = order_power(grating(Profile::blazed, 0.5, Facing::minus_x), n, order, 4);
    const double sinusoid = order_power(grating(Profile::sinusoid), n, order, 4);
    CHECK(std::abs(rising - number(row[3])) <= rounding);
    CHECK(std::abs(sinusoid - number(row[5])) <= rounding);
    // Sampling an edge costs exactly this factor against the continuous sawtooth.
    CHECK(std::abs(rising - number(row[2]) * edge_sampling(order + 4 / (2 * pi), n)) <= rounding);
    if (n >= 25) CHECK(std::abs(sinusoid - number(row[4])) <= rounding);
  }
}

TEST_CASE("orders have the powers of the table at every phase depth",
          "[synthetic_profile][oracle]") {
  constexpr Eigen::Index n = 100;
  for (const OracleRow& row : oracle_table("order_power_vs_phase_depth.csv")) {
    const double depth = depth_of(row[0]), turns = depth / (2 * pi);
    const int order = static_cast<int>(number(row[1]));
    CAPTURE(depth, order);
    CHECK(std::abs(order_power(grating(Profile::sinusoid), n, order, depth) - number(row[2])) <=
          rounding);
    const double edge = edge_sampling(order + turns, n);
    CHECK(std::abs(order_power(grating(Profile::blazed, 0.5, Facing::minus_x), n, order, depth) -
                   number(row[3]) * edge) <= rounding);
    // Falling in +x is the mirror image: order -m.
    CHECK(std::abs(order_power(grating(Profile::blazed), n, -order, depth) -
                   number(row[3]) * edge) <= rounding);
    CHECK(std::abs(order_power(grating(Profile::lamellar, 0.5), n, order, depth) -
                   number(row[4]) * edge_sampling(order, n)) <= rounding);
    CHECK(std::abs(order_power(grating(Profile::lamellar, 0.3), n, order, depth) -
                   number(row[5]) * edge_sampling(order, n)) <= rounding);
  }
}

TEST_CASE("orders of a triangle reach the table with the square of the pixel",
          "[synthetic_profile][oracle]") {
  // Its corners alias as 1 / n^2: four times less for half the pixel.
  for (const OracleRow& row : oracle_table("order_power_vs_phase_depth.csv")) {
    const double depth = depth_of(row[0]);
    const int order = static_cast<int>(number(row[1]));
    CAPTURE(depth, order);
    const auto error = [&](Eigen::Index n) {
      return std::abs(order_power(grating(Profile::triangle), n, order, depth) - number(row[6]));
    };
    const double coarse = error(100), fine = error(200);
    CHECK(coarse <= 5e-4);  // about depth / n^2 = 6e-4 times an amplitude; measured 3.6e-4
    // Where the power itself is zero its error is of fourth order, and rounding may be all of it.
    CHECK(fine <= coarse / 3.8 + rounding);
  }
}

TEST_CASE("the powers of all sampled orders add up to 1", "[synthetic_profile][invariant]") {
  for (const Profile profile :
       {Profile::sinusoid, Profile::blazed, Profile::lamellar, Profile::triangle}) {
    double sum = 0;
    for (int order = -12; order <= 12; ++order)
      sum += order_power(grating(profile), 25, order, 3.3);
    CHECK(std::abs(sum - 1) <= 25 * rounding);
  }
}

TEST_CASE("parameters that make no grating are refused", "[synthetic_profile][invariant]") {
  const auto make = [](ProfileParameters p) {
    return brdf::synthetic_grating(p, 2, 2, Length::um(0.1), Length::um(0.1));
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [bad_um, shown] :
       {std::pair<double, std::string>{0, "0"}, {-3, "-3"}, {nan, "nan"}, {1 / 0.0, "inf"}}) {
    ProfileParameters p = grating(Profile::blazed);
    p.period = Length::um(bad_um);
    CHECK_ERROR(make(p), Errc::invalid_argument, "period " + shown + " um");
    p = grating(Profile::blazed);
    p.height = Length::um(bad_um);
    CHECK_ERROR(make(p), Errc::invalid_argument, "height " + shown + " um");
  }
  CHECK_ERROR(make(grating(Profile::lamellar, 0)), Errc::invalid_argument, "duty 0 ");
  CHECK_ERROR(make(grating(Profile::lamellar, 1)), Errc::invalid_argument, "duty 1 ");
  CHECK_ERROR(make(grating(Profile::lamellar, nan)), Errc::invalid_argument, "duty nan ");
}
