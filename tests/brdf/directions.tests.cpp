#include "brdf/directions.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::Angle;
using brdf::Direction;
using brdf::direction;
using brdf::Errc;
using brdf::pi;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
}

TEST_CASE("a direction is a unit vector with the cosine of theta along the normal",
          "[directions][invariant]") {
  constexpr std::uint64_t seed = 11;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError length, along_normal, azimuth;
  for (int i = 0; i < 1000; ++i) {
    const double theta = uniform(0, 1.57), phi = uniform(-pi, pi);
    const Direction d = direction(Angle::rad(theta), Angle::rad(phi));
    length.see(std::abs(d.norm() - 1));
    along_normal.see(std::abs(d.z() - std::cos(theta)));
    azimuth.see(std::abs(d.y() * std::cos(phi) - d.x() * std::sin(phi)));
  }
  // A few roundings of numbers up to 1.
  CHECK(length.value() <= 4 * eps);
  CHECK(along_normal.value() <= eps);
  CHECK(azimuth.value() <= 2 * eps);
}

TEST_CASE("azimuth turns from +x to +y", "[directions][oracle]") {
  // sin 30 deg and cos 30 deg, one rounding each of the angle and the function.
  const Direction x = direction(Angle::deg(30), Angle::deg(0));
  CHECK(std::abs(x.x() - 0.5) <= eps);
  CHECK(std::abs(x.z() - std::sqrt(3.0) / 2) <= eps);
  const Direction y = direction(Angle::deg(30), Angle::deg(90));
  CHECK(std::abs(y.y() - 0.5) <= eps);
}

TEST_CASE("multiples of 90 deg of azimuth lie exactly in the coordinate planes",
          "[directions][invariant]") {
  for (const double phi_deg : {-180, 0, 180})
    CHECK(direction(Angle::deg(40), Angle::deg(phi_deg)).y() == 0);
  for (const double phi_deg : {-270, -90, 90, 270})
    CHECK(direction(Angle::deg(40), Angle::deg(phi_deg)).x() == 0);
  // A real, small azimuth is kept: only what the rounding of phi makes is dropped.
  CHECK(direction(Angle::deg(40), Angle::rad(1e-15)).y() > 0);
}

TEST_CASE("a full turn of azimuth lies exactly in the plane again", "[directions][regression]") {
  // The double nearest to 2 pi is 2.45e-16 away from it, more than 2^-52.
  for (const double phi_deg : {-360, 360})
    CHECK(direction(Angle::deg(40), Angle::deg(phi_deg)).y() == 0);
}

TEST_CASE("a negative theta lies at the opposite azimuth", "[directions][invariant]") {
  for (const double phi_deg : {0.0, 33.0, 90.0, 171.0}) {
    const Direction signed_angle = direction(Angle::deg(-25), Angle::deg(phi_deg));
    const Direction opposite = direction(Angle::deg(25), Angle::deg(phi_deg + 180));
    // The sum phi + 180 deg rounds by up to eps times 6 rad.
    CHECK((signed_angle - opposite).norm() <= 8 * eps);
  }
}

TEST_CASE("directions at or beyond the horizon are refused", "[directions][invariant]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_ERROR(direction(Angle::deg(90), {}), Errc::invalid_argument, "90 deg");
  CHECK_ERROR(direction(Angle::deg(-90), {}), Errc::invalid_argument, "-90 deg");
  CHECK_ERROR(direction(Angle::deg(135), {}), Errc::invalid_argument, "135");
  CHECK_ERROR(direction(Angle::deg(nan), {}), Errc::invalid_argument, "nan");
  CHECK_ERROR(direction({}, Angle::rad(nan)), Errc::invalid_argument, "azimuth");
  CHECK_ERROR(direction({}, Angle::rad(1 / 0.0)), Errc::invalid_argument, "azimuth");
}

TEST_CASE("the scattering vector points down and away from both directions",
          "[directions][oracle]") {
  // u = -(sin theta_i + sin theta_r), w = -(cos theta_i + cos theta_r).
  const Direction light = direction(Angle::deg(30), {});
  const Eigen::Vector3d retro = brdf::scattering_vector(light, light);
  CHECK(std::abs(retro.x() + 1) <= 2 * eps);
  CHECK(retro.y() == 0);
  CHECK(std::abs(retro.z() + std::sqrt(3.0)) <= 2 * eps);
  const Eigen::Vector3d mirror = brdf::scattering_vector(light, direction(Angle::deg(-30), {}));
  CHECK(mirror.x() == 0);
  CHECK(mirror.y() == 0);
}

TEST_CASE("one plus cosine does not cancel at grazing angles", "[directions][crossover]") {
  // In the mirror direction it is 2 cos^2 theta; the cosine itself is what the angle's rounding
  // leaves, so it is taken from the direction. Two roundings.
  for (const double from_horizon : {1.0, 1e-3, 1e-6, 1e-9}) {
    CAPTURE(from_horizon);
    const Direction light = direction(Angle::rad(pi / 2 - from_horizon), {});
    const Direction viewer = direction(Angle::rad(from_horizon - pi / 2), {});
    const double expected = 2 * light.z() * light.z();
    CHECK(std::abs(brdf::one_plus_cosine(light, viewer) / expected - 1) <= 2 * eps);
    if (from_horizon == 1e-9) CHECK(1 + light.dot(viewer) == 0);  // the plain form loses all of it
  }
}

TEST_CASE("one plus cosine is the plain formula where that is well conditioned",
          "[directions][invariant]") {
  constexpr std::uint64_t seed = 12;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError difference;
  for (int i = 0; i < 1000; ++i) {
    const Direction a = random_direction(uniform), b = random_direction(uniform);
    difference.see(std::abs(brdf::one_plus_cosine(a, b) - (1 + a.dot(b))));
  }
  CHECK(difference.value() <= 8 * eps);  // both round a sum of three products, of size up to 2
}
