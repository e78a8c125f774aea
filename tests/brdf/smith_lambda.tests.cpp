#include "brdf/smith_lambda.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/hemisphere.h"
#include "tests/support/rough_surfaces.h"
#include "tests/support/worst_error.h"

using brdf::Angle;
using brdf::back_facing_area;
using brdf::Direction;
using brdf::direction;
using brdf::Distribution;
using brdf::facet_density;
using brdf::pi;
using brdf::Roughness;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

Direction at(double theta_deg) {
  return direction(Angle::deg(theta_deg), {});
}

}  // namespace

TEST_CASE("the facets that face a direction less those that face away cover its view",
          "[microfacet][oracle]") {
  // Int D omega.h d omega_h = cos theta, so that those facing it have cos theta (1 + Lambda): the
  // property that Smith's masking rests on. By midpoints over the facets.
  for (const double alpha : {0.1, 0.5, 1.0})
    for (const Roughness& roughness : roughnesses(alpha))
      for (const double theta_deg : {10.0, 45.0, 75.0, 89.0}) {
        CAPTURE(static_cast<int>(roughness.distribution), roughness.gamma, alpha, theta_deg);
        const Direction omega = at(theta_deg);
        const auto facing = [&](double sign) {
          return integral_over_facets(quadrature_width(roughness), 600, [&](const Direction& h) {
            const brdf::SquaredAngle half{h.z() * h.z(), h.x() * h.x() + h.y() * h.y()};
            return facet_density(roughness, half) * std::max(0.0, sign * omega.dot(h)) / h.z();
          });
        };
        // Midpoints: second order in 1 / 600, less at the kink.
        CHECK(std::abs(facing(-1) - back_facing_area(roughness, omega)) <= 1e-5);
        CHECK(std::abs(facing(1) - facing(-1) - omega.z()) <= 1e-5);
      }
}

TEST_CASE("the quadrature is the closed forms of Gaussian slopes and of ggx",
          "[microfacet][oracle]") {
  WorstError beckmann, ggx;
  for (const double alpha : {1e-6, 1e-3, 0.05, 0.1, 0.5, 1.0, 3.0, 10.0})
    for (double theta_deg = 0.5; theta_deg < 90; theta_deg += 0.5) {
      const Direction omega = at(theta_deg);
      const auto error = [&](Distribution family) {
        const Roughness roughness{family, alpha};
        const double quadrature =
            brdf::detail::back_facing_quadrature(roughness, omega.z(), omega.x());
        return std::abs(quadrature - back_facing_area(roughness, omega)) / (alpha * omega.x());
      };
      beckmann.see(error(Distribution::beckmann));
      ggx.see(error(Distribution::ggx));
    }
  INFO("beckmann " << beckmann.value() << ", ggx " << ggx.value());
  // The step of 1/8 leaves 6e-8 of a Gaussian; algebraic tails converge faster.
  CHECK(beckmann.value() <= 1e-7);
  CHECK(ggx.value() <= 1e-8);
}

TEST_CASE("gtr at gamma 2 hides as ggx, and a cosine power tends to Gaussian slopes",
          "[microfacet][invariant]") {
  for (const double theta_deg : {20.0, 70.0, 89.0}) {
    CAPTURE(theta_deg);
    const Direction omega = at(theta_deg);
    for (const double alpha : {0.05, 0.5, 2.0})
      CHECK(std::abs(back_facing_area({Distribution::gtr, alpha, 2}, omega) -
                     back_facing_area({Distribution::ggx, alpha}, omega)) <= 1e-8 * alpha);
    // cos^n = exp(-n tan^2 / 2) up to the square of the slope: 1e-6 at alpha = 1e-3.
    CHECK(std::abs(back_facing_area({Distribution::blinn_phong, 1e-3}, omega) -
                   back_facing_area({Distribution::beckmann, 1e-3}, omega)) <= 2e-6 * 1e-3);
  }
}

TEST_CASE("at the horizon half of the facets' spread faces away", "[microfacet][crossover]") {
  // Closed forms at 90 deg: alpha / (2 sqrt pi) and alpha / 2.
  for (const double alpha : {1e-3, 0.3, 1.0}) {
    const Direction horizon = direction(Angle::rad(pi / 2 * (1 - eps / 2)), {});
    CHECK(std::abs(back_facing_area({Distribution::beckmann, alpha}, horizon) * 2 * std::sqrt(pi) /
                       alpha -
                   1) <= 4 * eps + 8e-16 / alpha);  // the cosine there is 1e-16, not 0
    CHECK(std::abs(back_facing_area({Distribution::ggx, alpha}, horizon) * 2 / alpha - 1) <=
          4 * eps + 8e-16 / alpha);
  }
}

TEST_CASE("no facet faces away from the normal, and no angle gives NaN",
          "[microfacet][crossover]") {
  for (const double alpha : {1e-6, 1e-3, 0.5, 1.0, 10.0})
    for (const Roughness& roughness : roughnesses(alpha)) {
      CAPTURE(static_cast<int>(roughness.distribution), roughness.gamma, alpha);
      CHECK(back_facing_area(roughness, {0, 0, 1}) == 0);
      for (const double theta_rad :
           {1e-300, 1e-9, 1e-3, 1.0, pi / 2 - 1e-9, pi / 2 * (1 - eps / 2)}) {
        const double area = back_facing_area(roughness, direction(Angle::rad(theta_rad), {}));
        CHECK(std::isfinite(area));
        CHECK(area >= 0);
        CHECK(area <= std::max(alpha, 1.0));
      }
    }
}
