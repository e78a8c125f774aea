#include "brdf/shadowing.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/figure.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::Angle;
using brdf::Direction;
using brdf::direction;
using brdf::pi;
using brdf::v_cavity_shadowing;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// min(1, 2 (n.h) (n.v) / (v.h), 2 (n.h) (n.l) / (v.h)) as it is printed, with 64 bits.
double printed(const Direction& l, const Direction& v) {
  using Wide = Eigen::Matrix<long double, 3, 1>;
  const Wide wide_l = l.cast<long double>(), wide_v = v.cast<long double>();
  const Wide h = (wide_l + wide_v).normalized();
  // v.h of exact unit vectors: half the length of the sum.
  const long double v_h = (wide_l + wide_v).norm() / 2;
  return static_cast<double>(
      std::min({1.0L, 2 * h.z() * wide_v.z() / v_h, 2 * h.z() * wide_l.z() / v_h}));
}

}  // namespace

TEST_CASE("V-shaped grooves shadow as the printed formula says", "[shadowing][identity][oracle]") {
  constexpr std::uint64_t seed = 91;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError relative;
  int shadowed = 0;
  for (int i = 0; i < 100000; ++i) {
    const Direction l = random_direction(uniform, 89.99), v = random_direction(uniform, 89.99);
    const double value = v_cavity_shadowing(l, v);
    shadowed += value < 1;
    relative.see(std::abs(value / printed(l, v) - 1));
    if (!(value >= 0 && value <= 1)) FAIL("shadowing " << value);
  }
  CHECK(shadowed > 10000);  // both branches are met
  // Six roundings.
  CHECK(figure("V-cavity", "shadowing, relative", relative.value()) <= 6 * eps);
}

TEST_CASE("a direction and its mirror are never shadowed; a grazing view of a steep light is",
          "[shadowing][oracle]") {
  for (const double theta_deg : {0.0, 30.0, 75.0, 89.99})
    CHECK(v_cavity_shadowing(direction(Angle::deg(theta_deg), {}),
                             direction(Angle::deg(-theta_deg), {})) == 1);
  // Light from the normal, view at theta: 2 (n.h) cos theta / (v.h) with n.h = v.h = cos(theta/2).
  for (const double theta_deg : {65.0, 75.0, 89.0}) {
    const Direction view = direction(Angle::deg(theta_deg), Angle::deg(33));
    CHECK(std::abs(v_cavity_shadowing({0, 0, 1}, view) / (2 * view.z()) - 1) <= 6 * eps);
  }
  CHECK(v_cavity_shadowing({0, 0, 1}, direction(Angle::deg(59), {})) == 1);  // 2 cos 59 deg > 1
}

TEST_CASE("shadowing is the same with light and viewer swapped", "[shadowing][invariant]") {
  constexpr std::uint64_t seed = 92;
  CAPTURE(seed);
  Uniform uniform(seed);
  int different = 0;
  for (int i = 0; i < 100000; ++i) {
    const Direction a = random_direction(uniform, 89.999), b = random_direction(uniform, 89.999);
    different += v_cavity_shadowing(a, b) != v_cavity_shadowing(b, a);
  }
  CHECK(different == 0);  // sums and minima commute
}

TEST_CASE("shadowing is a number for every two directions above the horizon",
          "[shadowing][crossover]") {
  for (const double a : {1e-3, 1e-9, 1e-16, 1e-100, 1e-300})
    for (const double b : {1.0, 1e-3, 1e-16, 1e-200, 1e-300})
      for (const double x : {-1.0, 1.0}) {
        CAPTURE(a, b, x);
        const double value = v_cavity_shadowing({1, 0, a}, {x * std::sqrt(1 - b * b), 0, b});
        CHECK(value >= 0);
        CHECK(value <= 1);
      }
  // Opposite directions, one far lower: 4 (n.l) / (n.v) where the squares of both are below 1e-308.
  CHECK(std::abs(v_cavity_shadowing({1, 0, 1e-300}, {-1, 0, 1e-200}) / 4e-100 - 1) <= 4 * eps);
}
