#include "brdf/microfacet_distribution.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/is_error.h"
#include "tests/support/rough_surfaces.h"
#include "tests/support/worst_error.h"

using brdf::Angle;
using brdf::Direction;
using brdf::direction;
using brdf::Distribution;
using brdf::Errc;
using brdf::facet_density;
using brdf::pi;
using brdf::Roughness;
using brdf::SquaredAngle;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

SquaredAngle at_tangent(double t) {
  return {1 / (1 + t * t), 1 / (1 + 1 / (t * t))};
}

/// 2 pi Int f(tan theta) D cos theta sin theta d theta. With tan theta = e^s the integrand falls
/// off exponentially on both sides, where equal steps converge faster than any power.
template <class Function>
double weighted_normalisation(const Roughness& roughness, Function f) {
  constexpr double step = 1.0 / 32;
  double sum = 0;
  for (double s = -40; s <= 40; s += step) {
    const double t = std::exp(s);
    const SquaredAngle half = at_tangent(t);
    sum += f(t) * facet_density(roughness, half) * half.sin2 * half.cos2;
  }
  return 2 * pi * step * sum;
}

double normalisation(const Roughness& roughness) {
  return weighted_normalisation(roughness, [](double) { return 1.0; });
}

}  // namespace

TEST_CASE("every distribution of facets covers the mean surface once", "[microfacet][oracle]") {
  WorstError error;
  for (const double alpha : {1e-6, 1e-3, 0.05, 0.3, 0.5, 0.9, 1.0, 1.5, 10.0})
    for (const Roughness& roughness : roughnesses(alpha)) {
      CAPTURE(static_cast<int>(roughness.distribution), alpha, roughness.gamma);
      error.see(std::abs(normalisation(roughness) - 1));
    }
  for (const double gamma : {0.5, 0.999999, 1 + 1e-12, 1.5, 2.0, 20.0})
    for (const double alpha : {1e-6, 0.1, 1 - 1e-9, 3.0})
      error.see(std::abs(normalisation({Distribution::gtr, alpha, gamma}) - 1));
  INFO("largest error " << error.value());
  CHECK(error.value() <= 1e-14);  // the rounding of a sum of 2560 terms
}

TEST_CASE("all distributions but gtr have the same peak", "[microfacet][oracle]") {
  const SquaredAngle mean{1, 0};
  for (const double alpha : {1e-6, 0.1, 1.0}) {
    for (const auto family : {Distribution::blinn_phong, Distribution::beckmann, Distribution::ggx})
      CHECK(std::abs(facet_density({family, alpha}, mean) * pi * alpha * alpha - 1) <= 4 * eps);
    // gamma = 1: the peak is lower by the logarithm, (1 - alpha^2) / -ln alpha^2.
    if (alpha < 1)
      CHECK(std::abs(facet_density({Distribution::gtr, alpha, 1}, mean) * pi * alpha * alpha * -2 *
                         std::log(alpha) / (1 - alpha * alpha) -
                     1) <= 8 * eps);
  }
}

TEST_CASE("gtr is ggx at gamma 2, and uniform at alpha 1", "[microfacet][invariant]") {
  WorstError ggx, uniform;
  for (double t = 1e-3; t < 1e3; t *= 1.7)
    for (const double alpha : {1e-3, 0.2, 0.7, 5.0}) {
      const SquaredAngle half = at_tangent(t);
      ggx.see(std::abs(facet_density({Distribution::gtr, alpha, 2}, half) /
                           facet_density({Distribution::ggx, alpha}, half) -
                       1));
      for (const double gamma : {0.5, 1.0, 4.0})
        uniform.see(std::abs(facet_density({Distribution::gtr, 1, gamma}, half) * pi - 1));
    }
  CHECK(ggx.value() <= 8 * eps);      // the square by a product and by pow
  CHECK(uniform.value() <= 8 * eps);  // alpha^2 cos^2 + sin^2 is 1 to a rounding
}

TEST_CASE("a cosine power is the course's Blinn-Phong", "[microfacet][oracle]") {
  for (const double n : {2.0, 10.0, 100.0, 1e4}) {
    const double alpha = std::sqrt(2 / (n + 2));
    for (const double theta_deg : {0.0, 1.0, 5.0, 30.0}) {
      const double cosine = std::cos(theta_deg * pi / 180), sine = std::sin(theta_deg * pi / 180);
      const double expected = (n + 2) / (2 * pi) * std::pow(cosine, n);
      const double value =
          facet_density({Distribution::blinn_phong, alpha}, {cosine * cosine, sine * sine});
      // n roundings of the cosine are magnified n times.
      CHECK(std::abs(value - expected) <= 4 * (n + 4) * eps * expected);
    }
  }
}

TEST_CASE("the alpha of Beckmann is the root mean square slope of the facets",
          "[microfacet][oracle]") {
  for (const double alpha : {1e-3, 0.1, 0.5, 2.0}) {
    const double mean_square =
        weighted_normalisation({Distribution::beckmann, alpha}, [](double t) { return t * t; });
    CHECK(std::abs(std::sqrt(mean_square) / alpha - 1) <= 1e-13);  // the quadrature's roundings
  }
}

TEST_CASE("the angle of the half vector does not cancel at either end", "[microfacet][crossover]") {
  for (const double small : {1e-3, 1e-6, 1e-9}) {
    CAPTURE(small);
    // Directions in the plane y = 0 at two angles: the half vector is at their mean.
    const auto near_normal = brdf::half_vector_angle(direction(Angle::rad(3 * small), {}),
                                                     direction(Angle::rad(-small), {}));
    CHECK(std::abs(near_normal.sin2 / std::pow(std::sin(small), 2) - 1) <= 16 * eps);
    const auto near_horizon = brdf::half_vector_angle(direction(Angle::rad(pi / 2 - small), {}),
                                                      direction(Angle::rad(pi / 2 - small), {}));
    // The angle pi/2 - small is itself rounded by 1e-16.
    CHECK(std::abs(near_horizon.cos2 / (small * small) - 1) <= small * small + 4e-16 / small);
  }
}

TEST_CASE("a density is finite and not negative down to the horizon", "[microfacet][crossover]") {
  for (const double alpha : {1e-6, 1e-3, 0.5, 1.0, 10.0})
    for (const Roughness& roughness : roughnesses(alpha))
      for (const double cosine : {1.0, 1e-3, 1e-16, 1e-100, 1e-200}) {
        CAPTURE(static_cast<int>(roughness.distribution), alpha, cosine);
        const double density = facet_density(roughness, {cosine * cosine, 1 - cosine * cosine});
        CHECK(std::isfinite(density));
        CHECK(density >= 0);
      }
}

TEST_CASE("a roughness outside its range is refused", "[microfacet]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto check = [](Roughness roughness) { brdf::require_valid(roughness); };
  for (const double alpha : {0.0, -1.0, 1e-7, 11.0, nan})
    CHECK_ERROR(check({Distribution::ggx, alpha}), Errc::invalid_argument, "roughness");
  CHECK_ERROR(check({Distribution::blinn_phong, 1.1}), Errc::invalid_argument, "cosine power");
  for (const double gamma : {0.4, 21.0, nan})
    CHECK_ERROR(check({Distribution::gtr, 0.5, gamma}), Errc::invalid_argument, "gamma");
  CHECK_NOTHROW(check({Distribution::ggx, 0.5, nan}));  // gamma is gtr's alone
  CHECK_NOTHROW(check({Distribution::beckmann, 10}));
}
