#include "brdf/fresnel.h"

#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <numbers>

#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::Errc;
using brdf::Fresnel;
using brdf::FresnelModel;
using brdf::PolarisedReflectance;
using Index = std::complex<double>;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

struct Reference {
  long double s, p;
};

/// Fresnel's equations as in a textbook, from the two cosines of Snell's law, with 64 bits.
Reference textbook(long double cosine, std::complex<long double> m) {
  const std::complex<long double> sin_t = std::sqrt(1 - cosine * cosine) / m;
  const std::complex<long double> cos_t = std::sqrt(1.0L - sin_t * sin_t);
  return {std::norm((cosine - m * cos_t) / (cosine + m * cos_t)),
          std::norm((m * cosine - cos_t) / (m * cosine + cos_t))};
}

double relative_error(const PolarisedReflectance& value, const Reference& expected) {
  return std::abs(static_cast<double>(value.unpolarised() / ((expected.s + expected.p) / 2) - 1));
}

constexpr std::array all_models = {FresnelModel::none, FresnelModel::schlick,
                                   FresnelModel::schlick_amplitude, FresnelModel::dielectric,
                                   FresnelModel::conductor};

}  // namespace

TEST_CASE("the cosine at the half vector is that of half the angle between the directions",
          "[fresnel][oracle]") {
  using brdf::Angle;
  using brdf::direction;
  for (const double theta_deg : {0.0, 1.0, 45.0, 89.0, 89.9999}) {
    CAPTURE(theta_deg);
    const brdf::Direction light = direction(Angle::deg(theta_deg), Angle::deg(30));
    const brdf::Direction mirror = direction(Angle::deg(-theta_deg), Angle::deg(30));
    CHECK(std::abs(brdf::cos_half(light, mirror) / light.z() - 1) <= 4 * eps);
    CHECK(std::abs(brdf::cos_half(light, light) - 1) <= 2 * eps);
    CHECK(brdf::cos_half(light, light) <= 1);
  }
  const brdf::Direction x = direction(Angle::deg(60), {}),
                        y = direction(Angle::deg(60), Angle::deg(90));
  CHECK(std::abs(brdf::cos_half(x, y) - std::sqrt((1 + x.dot(y)) / 2)) <= 4 * eps);
}

TEST_CASE("glass reflects 4 percent at normal incidence, whichever side", "[fresnel][oracle]") {
  CHECK(std::abs(brdf::normal_reflectance(1.0, 1.5) - 0.04) <= eps);
  CHECK(brdf::normal_reflectance(1.5, 1.0) == brdf::normal_reflectance(1.0, 1.5));
  CHECK(std::abs(brdf::normal_reflectance(Index(1.5)) - 0.04) <= eps);
  // Closed form with k: ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2) = (1 + 9) / (9 + 9).
  CHECK(std::abs(brdf::normal_reflectance(Index(2, 3)) - 10.0 / 18) <= 2 * eps);
}

TEST_CASE("every model starts from R_0 at normal incidence and reaches 1 at grazing",
          "[fresnel][invariant]") {
  for (const FresnelModel model : all_models)
    for (const Index index : {Index(1.5), Index(1.33), Index(2.4)}) {
      CAPTURE(static_cast<int>(model), index.real());
      const Fresnel fresnel{model, index};
      double at_normal = brdf::normal_reflectance(index);
      if (model == FresnelModel::none) at_normal = 1;
      if (model == FresnelModel::schlick_amplitude) at_normal *= at_normal;
      CHECK(std::abs(fresnel.reflectance(1) / at_normal - 1) <= 8 * eps);
      CHECK(std::abs(fresnel.reflectance(0) - 1) <= 4 * eps);
      CHECK(fresnel.relative_reflectance(1) == 1);
    }
}

TEST_CASE("the exact reflectances are a textbook's in higher precision", "[fresnel][oracle]") {
  constexpr std::uint64_t seed = 81;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError dielectric, conductor;
  for (int i = 0; i < 100000; ++i) {
    // Angles from 0 to within 1e-8 rad of the horizon, crowded there.
    const double cosine = i % 2 ? uniform(0, 1) : std::pow(10, uniform(-8, 0));
    const double n = 1 + std::pow(10, uniform(-4, 0.95));
    dielectric.see(relative_error(brdf::dielectric_reflectance(cosine, n), textbook(cosine, n)));
    const Index m(std::pow(10, uniform(-1.3, 0.7)), std::pow(10, uniform(-1, 1)));
    conductor.see(relative_error(brdf::conductor_reflectance(cosine, m),
                                 textbook(cosine, std::complex<long double>(m))));
  }
  INFO("dielectric " << dielectric.value() / eps << " eps, conductor " << conductor.value() / eps);
  // A dozen roundings each. Near the critical angle of n < 1, which k = 0.1 only blunts, the
  // reflectance itself is that much steeper.
  CHECK(dielectric.value() <= 12 * eps);
  CHECK(conductor.value() <= 40 * eps);
}

TEST_CASE("at Brewster's angle nothing is reflected in p", "[fresnel][oracle]") {
  for (const double n : {1.01, 1.33, 1.5, 2.4, 0.75}) {
    CAPTURE(n);
    // tan theta = n; r_p passes through 0 with a slope of about n, and the cosine has its rounding.
    const double cosine = 1 / std::hypot(1, n);
    const PolarisedReflectance r = brdf::dielectric_reflectance(cosine, n);
    CHECK(r.p <= 100 * eps * eps);
    // There s has the closed form ((1 - n^2) / (1 + n^2))^2.
    const double r_s = (1 - n * n) / (1 + n * n);
    CHECK(std::abs(r.s / (r_s * r_s) - 1) <= 40 * eps);  // the 1 - n^2 of this line, at n = 1.01
  }
}

TEST_CASE("at 45 degrees the p reflectance is the square of the s reflectance",
          "[fresnel][oracle]") {
  constexpr double cosine = std::numbers::sqrt2 / 2;
  for (const Index m : {Index(1.5), Index(0.05, 3.1), Index(0.96, 6.7), Index(4, 0.03)}) {
    CAPTURE(m.real(), m.imag());
    const PolarisedReflectance r = brdf::conductor_reflectance(cosine, m);
    CHECK(std::abs(r.p / (r.s * r.s) - 1) <= 16 * eps);  // twice the error of s, and of p
  }
}

TEST_CASE("a conductor without absorption is a dielectric", "[fresnel][invariant]") {
  WorstError difference;
  for (const double n : {0.6, 0.75, 1.2, 1.5, 2.4, 10.0})
    for (int i = 0; i <= 1000; ++i) {
      const double cosine = i / 1000.0;
      const PolarisedReflectance a = brdf::dielectric_reflectance(cosine, n);
      const PolarisedReflectance b = brdf::conductor_reflectance(cosine, n);
      difference.see(std::abs(a.s - b.s));
      difference.see(std::abs(a.p - b.p));
    }
  CHECK(difference.value() <= 8 * eps);  // the same equations, in real and in complex numbers
}

TEST_CASE("what is not reflected is transmitted", "[fresnel][oracle]") {
  constexpr std::uint64_t seed = 82;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError missing;
  for (int i = 0; i < 10000; ++i) {
    const double cosine = uniform(0.001, 1), n = uniform(1.01, 4);
    const double cos_t = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
    const double t_s = 2 * cosine / (cosine + n * cos_t), t_p = 2 * cosine / (n * cosine + cos_t);
    const double flux = n * cos_t / cosine;
    const PolarisedReflectance r = brdf::dielectric_reflectance(cosine, n);
    missing.see(std::abs(r.s + flux * t_s * t_s - 1));
    missing.see(std::abs(r.p + flux * t_p * t_p - 1));
  }
  CHECK(missing.value() <= 16 * eps);  // the transmitted part's own roundings
}

TEST_CASE("light inside the denser side is reflected totally beyond the critical angle",
          "[fresnel][crossover]") {
  const double n = 0.75, critical_cosine = std::sqrt(1 - n * n);
  for (const double cosine : {0.0, 0.3, critical_cosine - 1e-9}) {
    CHECK(brdf::dielectric_reflectance(cosine, n).unpolarised() == 1);
    CHECK(std::abs(brdf::conductor_reflectance(cosine, n).unpolarised() - 1) <= 8 * eps);
  }
  CHECK(brdf::dielectric_reflectance(critical_cosine + 1e-3, n).unpolarised() < 0.8);
}

TEST_CASE("towards grazing the reflectance falls off from 1 by its known slope",
          "[fresnel][oracle]") {
  // 1 - R = 2 cos theta (n^2 + 1) / sqrt(n^2 - 1) to first order, the mean of s and p.
  for (const double n : {1.33, 1.5, 2.4}) {
    const double slope = 2 * (n * n + 1) / std::sqrt(n * n - 1), cosine = 1e-6;
    const double lost = 1 - brdf::dielectric_reflectance(cosine, n).unpolarised();
    CHECK(std::abs(lost / (slope * cosine) - 1) <= 1e-5);  // the next order: about 5 cos theta
  }
}

TEST_CASE("Schlick's approximation is within its stated distance of the exact one",
          "[fresnel][oracle]") {
  const auto farthest = [](double n) {
    WorstError error;
    const Fresnel schlick{FresnelModel::schlick, n}, exact{FresnelModel::dielectric, n};
    for (int i = 0; i <= 1000; ++i)
      error.see(std::abs(schlick.reflectance(i / 1000.0) - exact.reflectance(i / 1000.0)));
    return error.value();
  };
  INFO(farthest(1.5) << " " << farthest(2));
  CHECK(farthest(1.5) <= 0.036);
  CHECK(farthest(2) <= 0.045);
  // Closed form: n = 1.5 at 60 deg, 0.04 + 0.96 / 32.
  CHECK(std::abs(Fresnel{FresnelModel::schlick, 1.5}.reflectance(0.5) - 0.07) <= 2 * eps);
}

TEST_CASE("reflectances of metals stay within 0 and 1 at every angle", "[fresnel][invariant]") {
  constexpr std::uint64_t seed = 83;
  CAPTURE(seed);
  Uniform uniform(seed);
  bool within = true;
  for (int i = 0; i < 100000; ++i) {
    const Index m(std::pow(10, uniform(-6, 6)), std::pow(10, uniform(-6, 6)));
    const double cosine = i % 2 ? uniform(0, 1) : std::pow(10, uniform(-17, 0));
    const PolarisedReflectance r = brdf::conductor_reflectance(cosine, m);
    // 1 but for the rounding of the index' squares.
    within = within && r.s >= 0 && r.s <= 1 + 8 * eps && r.p >= 0 && r.p <= 1 + 8 * eps;
  }
  CHECK(within);
}

TEST_CASE("an index that stands for no boundary is refused", "[fresnel]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto check = [](FresnelModel model, Index index) {
    brdf::require_valid(Fresnel{model, index});
  };
  CHECK_ERROR(check(FresnelModel::schlick, 0), Errc::invalid_argument, "real part > 0");
  CHECK_ERROR(check(FresnelModel::conductor, Index(nan, 1)), Errc::invalid_argument, "real part");
  CHECK_ERROR(check(FresnelModel::conductor, Index(2e6, 1)), Errc::invalid_argument, "real part");
  CHECK_ERROR(check(FresnelModel::conductor, Index(1, -1)), Errc::invalid_argument, "imaginary");
  CHECK_ERROR(check(FresnelModel::conductor, Index(1, nan)), Errc::invalid_argument, "imaginary");
  CHECK_ERROR(check(FresnelModel::dielectric, 1), Errc::invalid_argument, "must differ from 1");
  CHECK_ERROR(check(FresnelModel::dielectric, Index(1.5, 0.1)), Errc::invalid_argument,
              "1.5 + 0.1 i must be real");
  CHECK_NOTHROW(check(FresnelModel::none, 1));
  CHECK_NOTHROW(check(FresnelModel::conductor, Index(1, 0.001)));
  CHECK_NOTHROW(check(FresnelModel::dielectric, 0.75));
}
