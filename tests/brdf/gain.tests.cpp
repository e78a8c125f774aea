#include "brdf/gain.h"

#include <catch2/catch.hpp>
#include <limits>

#include "brdf/direct_sum.h"
#include "tests/support/albedo.h"
#include "tests/support/amplitudes.h"
#include "tests/support/oracle_table.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::Angle;
using brdf::Direction;
using brdf::direction;
using brdf::GaussianWindow;
using brdf::HeightField;
using brdf::Length;
using brdf::pi;
using brdf::Surface;
using brdf::SurfaceModel;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
const Length lambda = Length::nm(550);

Direction in_plane(double theta_deg) {
  return direction(Angle::deg(theta_deg), {});
}

}  // namespace

TEST_CASE("the gain of an order's efficiency is that of the table", "[gain][oracle]") {
  // e = g |a|^2, and the lobe of an order integrates to brdf_gain lambda^2 / area: with the area
  // lambda^2 the gain is g itself.
  WorstError gain, efficiency;
  for (const OracleRow& row : oracle_table("sinusoid_orders.csv")) {
    const Length wavelength = Length::um(number(row[4]));
    const double g = brdf::brdf_gain(in_plane(number(row[5])), in_plane(number(row[7])), wavelength,
                                     wavelength.um() * wavelength.um());
    gain.see(std::abs(g / number(row[10]) - 1));
    efficiency.see(std::abs(g * number(row[9]) / number(row[11]) - 1));
  }
  // The worst row is at 83.8 deg, where the angle's 16 digits make 1e-15 of the cosine.
  CHECK(gain.value() <= 1e-14);
  CHECK(efficiency.value() <= 1e-14);
}

TEST_CASE("the two gains differ by cos theta_i, the area and lambda squared", "[gain][invariant]") {
  constexpr std::uint64_t seed = 71;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError relative;
  for (int i = 0; i < 1000; ++i) {
    const Direction a = random_direction(uniform), b = random_direction(uniform);
    const double area_um2 = uniform(1, 5000);
    const double expected = brdf::relative_gain(a, b) * area_um2 / (a.z() * 0.55 * 0.55);
    relative.see(std::abs(brdf::brdf_gain(a, b, lambda, area_um2) / expected - 1));
  }
  CHECK(relative.value() <= 8 * eps);  // the same product in another order
}

TEST_CASE("the radiance is the BRDF times the irradiance of the light", "[gain][oracle]") {
  constexpr std::uint64_t seed = 73;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError of_brdf, printed;
  for (int i = 0; i < 10000; ++i) {
    const Direction a = random_direction(uniform), b = random_direction(uniform);
    const double area_um2 = uniform(1, 5000);
    const double value = brdf::radiance_gain(a, b, lambda, area_um2);
    of_brdf.see(std::abs(value / (brdf::brdf_gain(a, b, lambda, area_um2) * a.z()) - 1));
    // L / I = (1 + omega_i . omega_r)^2 abs(P)^2 / (lambda^2 A w^2 cos theta_r), abs(P)^2 / A being
    // abs(a)^2 area.
    const double w = a.z() + b.z(), g = 1 + a.dot(b);
    printed.see(std::abs(value / (g * g * area_um2 / (0.55 * 0.55 * w * w * b.z())) - 1));
  }
  CHECK(of_brdf.value() <= 8 * eps);  // the same product in another order
  CHECK(printed.value() <= 1e-8);     // its 1 + cosine cancels near the opposite direction
}

TEST_CASE("the BRDF gain is the same with light and viewer swapped", "[gain][invariant]") {
  constexpr std::uint64_t seed = 72;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError brdf_change;
  double relative_change = 0;
  for (int i = 0; i < 100000; ++i) {
    const Direction a = random_direction(uniform, 89.999), b = random_direction(uniform, 89.999);
    brdf_change.see(
        std::abs(brdf::brdf_gain(a, b, lambda, 3300) / brdf::brdf_gain(b, a, lambda, 3300) - 1));
    relative_change = std::max(relative_change,
                               std::abs(brdf::relative_gain(a, b) / brdf::relative_gain(b, a) - 1));
  }
  CHECK(brdf_change.value() <= 4 * eps);  // sums and products commute
  CHECK(relative_change >= 1);            // radiance carries 1 / cos theta_r alone
}

TEST_CASE("gains stay finite and right to within 1e-9 rad of the horizon", "[gain][crossover]") {
  for (const double from_horizon : {1e-3, 1e-6, 1e-9}) {
    CAPTURE(from_horizon);
    const Direction light = direction(Angle::rad(pi / 2 - from_horizon), {});
    for (const double phi_deg : {0.0, 40.0, 180.0}) {
      const Direction viewer = direction(Angle::rad(pi / 2 - from_horizon), Angle::deg(phi_deg));
      CHECK(std::isfinite(brdf::relative_gain(light, viewer)));
      CHECK(std::isfinite(brdf::brdf_gain(light, viewer, lambda, 3300)));
    }
    const Direction mirror = direction(Angle::rad(from_horizon - pi / 2), {});
    // In the mirror direction the grazing factors cancel: cos theta, and area / lambda^2.
    CHECK(std::abs(brdf::relative_gain(light, mirror) / mirror.z() - 1) <= 8 * eps);
    CHECK(std::abs(brdf::brdf_gain(light, mirror, lambda, 3300) * 0.55 * 0.55 / 3300 - 1) <=
          8 * eps);
  }
}

TEST_CASE("a flat patch reflects all the light that falls on it", "[gain][oracle]") {
  // Albedo of the periodic model, a = exp(-k^2 sigma^2 (u^2 + v^2) / 2), with sigma 16.25 um; at
  // 85 deg part of the lobe lies below the horizon. Known to six decimals.
  const HeightField field = sampled(4, 4, 0.1, 0.1, [](double, double) { return 0.0; });
  const Surface surface{&field, GaussianWindow(Length::um(16.25)), SurfaceModel::periodic};
  const double area_um2 = brdf::coherence_area_um2(surface);
  const double k = brdf::wavenumber_per_um(lambda);
  const auto window = [&](double s) { return std::exp(-std::pow(k * 16.25 * s, 2) / 2); };
  for (const auto& [theta_deg, expected] : {std::pair{0.0, 1.000014},
                                            {30.0, 1.000021},
                                            {60.0, 1.000102},
                                            {75.0, 1.001002},
                                            {85.0, 0.898572}}) {
    CAPTURE(theta_deg);
    const Direction light = in_plane(theta_deg);
    const double albedo = albedo_of_separable(
        light, window, window,
        [&](const Direction& viewer) { return brdf::brdf_gain(light, viewer, lambda, area_um2); },
        {.half_width_u = 0.035, .half_width_v = 0.035});
    CHECK(std::abs(albedo - expected) <= 6e-7);  // half of the last digit, and the quadrature
  }
}

TEST_CASE("an isolated flat patch loses what its cut window throws beyond the horizon",
          "[gain][oracle]") {
  // A patch of 65 um; its sidelobes reach the whole hemisphere, and towards the horizon the gain
  // lifts them: what is left out there decides the fourth decimal.
  const HeightField field = sampled(1, 650, 0.1, 65, [](double, double) { return 0.0; });
  const Surface surface{&field, GaussianWindow(Length::um(16.25)), SurfaceModel::isolated};
  // The row is one pixel of 65 um across, whose own factor of the area is 65 um.
  const double along_um = brdf::coherence_area_um2(surface) / 65;
  const double area_um2 = along_um * along_um;
  const double k = brdf::wavenumber_per_um(lambda);
  // Cubic interpolation at 32 samples to the width of a sidelobe adds 1e-7 to the albedo.
  const double step = 0.55 / 65 / 32;
  std::vector<brdf::Query> queries;
  for (int i = -1; i * step <= 2 + 2 * step; ++i) queries.push_back({k * i * step, 0, 0});
  const Amplitudes table = amplitudes(brdf::DirectSum{}, surface, queries);
  const auto window = [&](double s) {
    const double position = std::abs(s) / step;
    const auto i = static_cast<std::size_t>(position);
    return cubic(position - static_cast<double>(i), &table[i]);
  };
  const auto albedo = [&](double theta_deg, Lobe lobe) {
    const Direction light = in_plane(theta_deg);
    return albedo_of_separable(
        light, window, window,
        [&](const Direction& viewer) { return brdf::brdf_gain(light, viewer, lambda, area_um2); },
        lobe);
  };
  // Up to 0.6 from the mirror direction in u and in v, from the continuous window, known to five
  // decimals; pixels of 0.1 um add up to 6e-6.
  const Lobe near{.half_width_u = 0.6, .half_width_v = 0.6};
  CHECK(std::abs(albedo(0, near) - 0.99992) <= 1.2e-5);
  CHECK(std::abs(albedo(60, near) - 1.00001) <= 1.2e-5);
  CHECK(std::abs(albedo(75, near) - 1.00073) <= 1.2e-5);
  CHECK(std::abs(albedo(85, near) - 0.8811) <= 6e-5);  // known to four
  // The whole hemisphere with these pixels, from a grid in polar angles in another language that
  // moved by 1e-6 when refined.
  CHECK(std::abs(albedo(0, {}) - 1.000024) <= 2e-6);
  CHECK(std::abs(albedo(60, {}) - 1.000151) <= 2e-6);
  CHECK(std::abs(albedo(75, {}) - 1.001164) <= 2e-6);
  CHECK(std::abs(albedo(85, {}) - 0.884207) <= 2e-6);
}
