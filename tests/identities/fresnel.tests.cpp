// Schlick's reflectance as the sources use it.
#include "brdf/fresnel.h"

#include <catch2/catch.hpp>

#include "tests/support/exact_sums.h"
#include "tests/support/figure.h"
#include "tests/support/worst_error.h"

using exact::Real;

namespace {

/// Fresnel's equations in angles, unpolarised, from air into a real index.
Real fresnel(Real cos_i, Real n) {
  const Real sin_t = std::sqrt(1 - cos_i * cos_i) / n, cos_t = std::sqrt(1 - sin_t * sin_t);
  const Real s = (cos_i - n * cos_t) / (cos_i + n * cos_t);
  const Real p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
  return (s * s + p * p) / 2;
}

}  // namespace

TEST_CASE("Thesis B.1: Schlick's approximation and R_0", "[identity][oracle]") {
  CHECK(std::abs(brdf::normal_reflectance(1, 1.5) - 0.04) <= 2e-17);
  CHECK(std::abs(brdf::normal_reflectance(1.5, 1) - 0.04) <= 2e-17);
  WorstError formula, physics;
  for (int i = 0; i <= 1000; ++i) {
    const double cosine = i / 1000.0;
    const double r = brdf::schlick_reflectance(cosine, brdf::normal_reflectance(1, 1.5));
    formula.see(static_cast<double>(
        std::abs(r - (0.04L + 0.96L * std::pow(1 - static_cast<Real>(cosine), 5)))));
    physics.see(static_cast<double>(std::abs(r - fresnel(cosine, 1.5L))));
  }
  CHECK(figure("Thesis B.1", "Schlick's R, n = 1.5", formula.value()) <=
        6e-16);  // six products of at most 1
  const double off =
      figure("Thesis B.1", "Schlick's R against Fresnel's, n = 1.5", physics.value());
  CHECK(off >= 0.035);
  CHECK(off <= 0.0365);
}

TEST_CASE("Erratum E12: Stam's F is an amplitude, Schlick's R is not to be squared",
          "[identity][erratum][E12]") {
  const auto at = [](brdf::FresnelModel model, double cosine) {
    return brdf::Fresnel{model, 1.5}.reflectance(cosine);
  };
  constexpr auto schlick = brdf::FresnelModel::schlick,
                 schlick_amplitude = brdf::FresnelModel::schlick_amplitude;
  CHECK(brdf::Fresnel{}.reflectance(1) == 1);
  CHECK(at(schlick, 1) == Approx(0.04).epsilon(1e-15));
  CHECK(figure("E12", "reflectance at normal incidence, n = 1.5; right: 0.04",
               at(schlick_amplitude, 1)) == Approx(0.0016).epsilon(1e-14));
  // Relative to normal incidence, at 60 deg: 0.07 / 0.04, and its square.
  CHECK(brdf::Fresnel{schlick, 1.5}.relative_reflectance(0.5) == Approx(1.75).epsilon(1e-14));
  CHECK(figure("E12", "relative reflectance at 60 deg; right: 1.75",
               brdf::Fresnel{schlick_amplitude, 1.5}.relative_reflectance(0.5)) ==
        Approx(1.75 * 1.75).epsilon(1e-14));
  // Offered under its own name; the two agree at grazing only.
  for (const double cosine : {0.0, 0.2, 0.7})
    CHECK(at(schlick_amplitude, cosine) == Approx(std::pow(at(schlick, cosine), 2)).epsilon(1e-15));
}
