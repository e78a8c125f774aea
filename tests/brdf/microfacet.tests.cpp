#include "brdf/microfacet.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/hemisphere.h"
#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/rough_surfaces.h"
#include "tests/support/worst_error.h"

using brdf::Angle;
using brdf::Direction;
using brdf::direction;
using brdf::Distribution;
using brdf::Errc;
using brdf::FacetReflectance;
using brdf::Fresnel;
using brdf::FresnelModel;
using brdf::Length;
using brdf::Masking;
using brdf::material_named;
using brdf::Microfacet;
using brdf::pi;
using brdf::Roughness;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
const Length lambda = Length::nm(550);

std::vector<FacetReflectance> all_reflectances() {
  return {Fresnel{FresnelModel::none},
          Fresnel{FresnelModel::schlick, 1.5},
          Fresnel{FresnelModel::schlick_amplitude, 1.5},
          Fresnel{FresnelModel::dielectric, 1.5},
          Fresnel{FresnelModel::conductor, {0.96, 6.7}},
          material_named("copper")};
}

/// Part of the light that mirrors of reflectance 1 send back.
double albedo(const Roughness& roughness, Masking masking, double theta_i_deg) {
  const Microfacet surface{roughness, masking, Fresnel{}};
  const Direction light = direction(Angle::deg(theta_i_deg), {});
  return albedo_of_facets(light, quadrature_width(roughness), 100, [&](const Direction& viewer) {
    return surface.brdf(light, viewer, lambda);
  });
}

}  // namespace

TEST_CASE("the model is F G D / (4 (n.l) (n.v)) as printed", "[microfacet][oracle]") {
  constexpr std::uint64_t seed = 111;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError relative;
  for (int i = 0; i < 10000; ++i) {
    const Direction l = random_direction(uniform, 80), v = random_direction(uniform, 80);
    const double alpha = uniform(0.1, 1);
    const Direction h = (l + v).normalized();
    const double n_h = h.z(), l_h = l.dot(h);
    // ggx, V-shaped grooves and Schlick, each as the course writes it.
    const double spread = n_h * n_h * (alpha * alpha - 1) + 1;
    const double d = alpha * alpha / (pi * spread * spread);
    const double g = std::min({1.0, 2 * n_h * v.z() / l_h, 2 * n_h * l.z() / l_h});
    const double f = 0.04 + 0.96 * std::pow(1 - l_h, 5);
    const Microfacet surface{
        {Distribution::ggx, alpha}, Masking::cook_torrance, Fresnel{FresnelModel::schlick, 1.5}};
    relative.see(std::abs(surface.brdf(l, v, lambda) / (f * g * d / (4 * l.z() * v.z())) - 1));
  }
  CHECK(relative.value() <= 1e-12);  // the printed n.h and l.h lose up to three digits
}

TEST_CASE("the BRDF of every model is the same with light and viewer swapped",
          "[microfacet][invariant]") {
  constexpr std::uint64_t seed = 112;
  CAPTURE(seed);
  Uniform uniform(seed);
  const std::vector<FacetReflectance> reflectances = all_reflectances();
  WorstError change;
  for (int i = 0; i < 100000; ++i) {
    const Direction a = random_direction(uniform, 89.999), b = random_direction(uniform, 89.999);
    // Distributions and reflectances take turns; 6 and 5 share no factor, so that all pairs of them
    // meet.
    const auto all = roughnesses(std::pow(10, uniform(-2, 0)));
    const Roughness& roughness = all[static_cast<std::size_t>(i) % all.size()];
    const FacetReflectance& reflectance =
        reflectances[static_cast<std::size_t>(i) % reflectances.size()];
    for (const Masking masking : all_maskings) {
      const Microfacet surface{roughness, masking, reflectance};
      const double there = surface.brdf(a, b, lambda), back = surface.brdf(b, a, lambda);
      change.see(std::abs(there - back) / std::max(there, 1e-300));  // D may underflow to 0
    }
  }
  INFO("largest change " << change.value() / eps << " eps");
  CHECK(change.value() <= 4 * eps);  // sums and products commute: 0 where nothing is contracted
}

TEST_CASE("no model reflects more light than it receives", "[microfacet][oracle]") {
  // The white furnace: R = 1, all directions lit alike. What is missing from 1 was reflected into
  // other facets, which these models do not follow.
  WorstError largest;
  for (const double alpha : {0.01, 0.1, 0.3, 0.6, 1.0})
    for (const Roughness& roughness : roughnesses(alpha))
      for (const Masking masking : all_maskings)
        for (const double theta_deg : {0.0, 30.0, 60.0, 75.0, 80.0, 85.0}) {
          const double reflected = albedo(roughness, masking, theta_deg);
          CAPTURE(static_cast<int>(roughness.distribution), roughness.gamma,
                  static_cast<int>(masking), alpha, theta_deg, reflected);
          CHECK(reflected <= 1.01);
          CHECK(reflected >= 0);
          largest.see(reflected);
        }
  INFO("largest albedo " << largest.value());
  CHECK(largest.value() <= 1.002);  // 1 and what 100 x 50 midpoints add
}

TEST_CASE("smooth surfaces reflect all light but where the implicit masking darkens it",
          "[microfacet][oracle]") {
  for (const double theta_deg : {0.0, 30.0, 60.0}) {
    CAPTURE(theta_deg);
    for (const Masking masking : {Masking::cook_torrance, Masking::kelemen, Masking::smith})
      CHECK(std::abs(albedo({Distribution::beckmann, 0.01}, masking, theta_deg) - 1) <= 1e-3);
    // G = (n.l) (n.v) leaves cos^2 theta in the mirror direction.
    const double cosine = std::cos(theta_deg * pi / 180);
    CHECK(std::abs(albedo({Distribution::beckmann, 0.01}, Masking::implicit, theta_deg) -
                   cosine * cosine) <= 1e-3);
  }
}

TEST_CASE("uniform facets under a cosine have their closed form", "[microfacet][oracle]") {
  // D = 1 / pi at alpha 1; implicit, light from the normal: f = 1 / (4 pi), and 1/4 comes back.
  for (const Roughness& roughness : roughnesses(1)) {
    if (roughness.distribution == Distribution::beckmann) continue;
    CHECK(std::abs(albedo(roughness, Masking::implicit, 0) - 0.25) <= 1e-4);  // midpoints
    const Microfacet surface{roughness, Masking::implicit, Fresnel{}};
    CHECK(std::abs(surface.brdf(direction(Angle::deg(20), {}), {0, 0, 1}, lambda) * 4 * pi - 1) <=
          8 * eps);
  }
}

TEST_CASE("every model is a finite number at grazing and at the smallest roughness",
          "[microfacet][crossover]") {
  bool good = true;
  for (const double alpha : {1e-6, 1e-3, 0.5, 1.0, 10.0})
    for (const Roughness& roughness : roughnesses(alpha))
      for (const Masking masking : all_maskings)
        for (const FacetReflectance& reflectance : all_reflectances()) {
          const Microfacet surface{roughness, masking, reflectance};
          for (const double from_horizon : {pi / 2 * eps / 2, 1e-9, 1e-6, 1e-3, 0.5, 1.5})
            for (const double phi_deg : {0.0, 40.0, 179.9, 180.0})
              for (const double light_from_horizon : {pi / 2 * eps / 2, 1e-9, 0.5, pi / 2}) {
                const double f = surface.brdf(
                    direction(Angle::rad(pi / 2 - light_from_horizon), {}),
                    direction(Angle::rad(pi / 2 - from_horizon), Angle::deg(phi_deg)), lambda);
                good = good && std::isfinite(f) && f >= 0;
              }
        }
  CHECK(good);
}

TEST_CASE("a facet's reflectance is taken at the half vector and at the wavelength",
          "[microfacet][oracle]") {
  const Direction l = direction(Angle::deg(75), {}), v = direction(Angle::deg(-45), {});
  const auto ratio = [&](const FacetReflectance& reflectance, Length wavelength) {
    const Roughness roughness;
    return Microfacet{roughness, Masking::smith, reflectance}.brdf(l, v, wavelength) /
           Microfacet{roughness, Masking::smith, Fresnel{}}.brdf(l, v, wavelength);
  };
  // 120 deg between the directions: 60 deg at the facet, (1 - 1/2)^5 = 1/32.
  CHECK(std::abs(ratio(Fresnel{FresnelModel::schlick, 1.5}, lambda) - 0.07) <= 4 * eps);
  for (const auto& [nm, r0] : {std::pair{465.0, 0.538}, {550.0, 0.638}, {610.0, 0.955}})
    CHECK(std::abs(ratio(material_named("copper"), Length::nm(nm)) - (r0 + (1 - r0) / 32)) <=
          4 * eps);
}

TEST_CASE("a diffuse surface sends its albedo back", "[microfacet][oracle]") {
  CHECK(std::abs(brdf::Lambert{0.5}.brdf() * pi - 0.5) <= eps);  // Int cos theta d omega = pi
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double albedo : {-0.1, 1.1, nan})
    CHECK_ERROR(brdf::require_valid(brdf::Lambert{albedo}), Errc::invalid_argument, "albedo");
  CHECK_NOTHROW(brdf::require_valid(brdf::Lambert{1}));
}

TEST_CASE("a model is refused where one of its parts is", "[microfacet]") {
  CHECK_ERROR(brdf::require_valid(Microfacet{{Distribution::ggx, 0}}), Errc::invalid_argument,
              "roughness 0 must lie");
  CHECK_ERROR(
      brdf::require_valid(Microfacet{{}, Masking::smith, Fresnel{FresnelModel::dielectric, 1}}),
      Errc::invalid_argument, "must differ from 1");
  CHECK_NOTHROW(brdf::require_valid(Microfacet{}));
  CHECK_NOTHROW(brdf::require_valid(Microfacet{{}, Masking::smith, material_named("silver")}));
}
