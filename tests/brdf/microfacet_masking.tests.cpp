#include "brdf/microfacet_masking.h"

#include <catch2/catch.hpp>
#include <limits>

#include "brdf/shadowing.h"
#include "tests/support/hemisphere.h"
#include "tests/support/random_inputs.h"
#include "tests/support/rough_surfaces.h"
#include "tests/support/worst_error.h"

using brdf::Angle;
using brdf::Direction;
using brdf::direction;
using brdf::Distribution;
using brdf::facet_visibility;
using brdf::Masking;
using brdf::pi;
using brdf::Roughness;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double masking(Masking model, const Roughness& roughness, const Direction& l, const Direction& v) {
  return facet_visibility(model, roughness, l, v) * l.z() * v.z();
}

}  // namespace

TEST_CASE("Cook and Torrance's masking is that of V-shaped grooves, the implicit one the cosines",
          "[microfacet][oracle]") {
  constexpr std::uint64_t seed = 101;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError grooves, cosines, kelemen;
  for (int i = 0; i < 10000; ++i) {
    const Direction l = random_direction(uniform, 89.99), v = random_direction(uniform, 89.99);
    grooves.see(
        std::abs(masking(Masking::cook_torrance, {}, l, v) / brdf::v_cavity_shadowing(l, v) - 1));
    cosines.see(std::abs(masking(Masking::implicit, {}, l, v) / (l.z() * v.z()) - 1));
    const Direction h = (l + v).normalized();
    kelemen.see(std::abs(facet_visibility(Masking::kelemen, {}, l, v) * std::pow(l.dot(h), 2) - 1));
  }
  CHECK(grooves.value() <= 8 * eps);  // the same quotient in another order
  CHECK(cosines.value() <= 2 * eps);
  // l.h cancels between nearly opposite directions, which are 0.02 deg apart at most.
  CHECK(kelemen.value() <= 1e-8);
}

TEST_CASE("Smith's masking is the closed form of its Lambda", "[microfacet][oracle]") {
  constexpr std::uint64_t seed = 102;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError ggx, beckmann;
  for (int i = 0; i < 10000; ++i) {
    const Direction l = random_direction(uniform), v = random_direction(uniform);
    const double alpha = std::pow(10, uniform(-2, 0.5));
    const auto expected = [&](auto lambda) {
      const auto a = [&](const Direction& w) { return w.z() / (alpha * std::hypot(w.x(), w.y())); };
      return 1 / (1 + lambda(a(l)) + lambda(a(v)));
    };
    const double of_ggx = expected([](double a) { return (std::sqrt(1 + 1 / (a * a)) - 1) / 2; });
    const double of_beckmann = expected([](double a) {
      return (std::erf(a) - 1) / 2 + std::exp(-a * a) / (2 * a * std::sqrt(pi));
    });
    ggx.see(std::abs(masking(Masking::smith, {Distribution::ggx, alpha}, l, v) / of_ggx - 1));
    beckmann.see(
        std::abs(masking(Masking::smith, {Distribution::beckmann, alpha}, l, v) / of_beckmann - 1));
  }
  CHECK(ggx.value() <= 16 * eps);  // a dozen roundings on both sides
  CHECK(beckmann.value() <= 16 * eps);
}

TEST_CASE("what a direction sees of the facets is the mean surface, no more and no less",
          "[microfacet][oracle]") {
  // Int G1(v) max(0, v.h) D(h) d omega_h = cos theta_v; against the normal Smith's G is G1.
  const Direction normal{0, 0, 1};
  for (const double alpha : {0.1, 0.5, 1.0})
    for (const Roughness& roughness : roughnesses(alpha))
      for (const double theta_deg : {10.0, 45.0, 75.0, 89.0}) {
        CAPTURE(static_cast<int>(roughness.distribution), roughness.gamma, alpha, theta_deg);
        const Direction v = direction(Angle::deg(theta_deg), {});
        const double facing =
            integral_over_facets(quadrature_width(roughness), 600, [&](const Direction& h) {
              const brdf::SquaredAngle half{h.z() * h.z(), h.x() * h.x() + h.y() * h.y()};
              return brdf::facet_density(roughness, half) * std::max(0.0, v.dot(h)) / h.z();
            });
        const double seen = masking(Masking::smith, roughness, normal, v) * facing;
        CHECK(std::abs(seen - v.z()) <= 1e-5);  // midpoints: second order in 1 / 600
      }
}

TEST_CASE("no masking shows more than there is, nor less than nothing", "[microfacet][invariant]") {
  constexpr std::uint64_t seed = 103;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError largest;
  bool negative = false;
  for (int i = 0; i < 10000; ++i) {
    const Direction l = random_direction(uniform, 89.999), v = random_direction(uniform, 89.999);
    for (const Masking model : all_maskings) {
      const double g = masking(model, {Distribution::ggx, uniform(0.01, 1)}, l, v);
      largest.see(g);
      negative = negative || !(g >= 0);
    }
  }
  CHECK(largest.value() <= 1 + 8 * eps);
  CHECK_FALSE(negative);
}
