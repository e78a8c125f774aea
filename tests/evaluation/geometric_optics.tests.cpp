#include "evaluation/geometric_optics.h"

#include <catch2/catch.hpp>
#include <vector>

#include "evaluation/sweep.h"
#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"

namespace {

using brdf::Direction;
using brdf::Length;
using brdf::Quantity;
using evaluation::GeometricOptics;

std::vector<double> values(const GeometricOptics& surface, const Direction& omega_i,
                           const std::vector<Direction>& omega_r, Length wavelength) {
  std::vector<double> result(omega_r.size());
  std::vector<evaluation::Sample> samples;
  for (const Direction& direction : omega_r) samples.push_back({{omega_i, direction}, wavelength});
  surface.evaluate(samples, result);
  return result;
}

}  // namespace

TEST_CASE("geometric optics gives the model's BRDF, and its radiance f cos theta_i",
          "[geometric_optics][invariant]") {
  Uniform uniform(4);
  brdf::Microfacet facets;
  facets.roughness = {brdf::Distribution::beckmann, 0.4};
  facets.reflectance = brdf::material_named("copper");
  for (int trial = 0; trial < 100; ++trial) {
    const Direction omega_i = random_direction(uniform);
    const std::vector<Direction> omega_r{random_direction(uniform), random_direction(uniform)};
    const Length wavelength = Length::nm(uniform(380, 780));
    const auto f = values({facets, Quantity::brdf}, omega_i, omega_r, wavelength);
    const auto radiance = values({facets, Quantity::radiance}, omega_i, omega_r, wavelength);
    const auto grey =
        values({brdf::Lambert{0.5}, Quantity::radiance}, omega_i, omega_r, wavelength);
    for (std::size_t j = 0; j < omega_r.size(); ++j) {
      CHECK(f[j] == facets.brdf(omega_i, omega_r[j], wavelength));
      // One product each, in either order.
      CHECK(std::abs(radiance[j] - f[j] * omega_i.z()) <= 1e-15 * f[j]);
      CHECK(std::abs(grey[j] - 0.5 / brdf::pi * omega_i.z()) <= 1e-15);
    }
  }
}

TEST_CASE("geometric optics refuses what only a diffracting patch has", "[geometric_optics]") {
  for (const Quantity quantity : {Quantity::power, Quantity::relative})
    CHECK_ERROR(GeometricOptics(brdf::Lambert{}, quantity), brdf::Errc::invalid_argument,
                "geometric optics");
  CHECK_ERROR(GeometricOptics(brdf::Lambert{2}, Quantity::brdf), brdf::Errc::invalid_argument,
              "albedo 2");
}
