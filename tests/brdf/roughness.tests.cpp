#include "brdf/roughness.h"

#include <catch2/catch.hpp>
#include <random>

#include "brdf/levelling.h"
#include "tests/support/surfaces.h"

using brdf::correlation_length_um;
using brdf::HeightSpectrum;

namespace {

brdf::HeightField sinusoid(Eigen::Index rows, double period_um, double azimuth_deg) {
  const double phi = brdf::Angle::deg(azimuth_deg).rad();
  return sampled(rows, 400, 0.1, 0.1, [&](double x, double y) {
    return 0.1 * std::cos(2 * brdf::pi * (x * std::cos(phi) + y * std::sin(phi)) / period_um);
  });
}

}  // namespace

TEST_CASE("a sinusoid is correlated over acos(1/e) / (2 pi) of its period", "[roughness]") {
  const double part = std::acos(std::exp(-1.0)) / (2 * brdf::pi);
  for (const double period_um : {1.7, 4.0}) {
    // 1 %: linear between pixels of a 17th of the period, at most (pi / 17)^2 / 2 of the value.
    const auto row = correlation_length_um(HeightSpectrum(sinusoid(1, period_um, 0)));
    REQUIRE(row);
    CHECK(*row == Approx(part * period_um).epsilon(0.01));
    for (const double azimuth_deg : {0.0, 32.0, 90.0, -45.0}) {
      INFO(azimuth_deg << " deg");
      const auto found =
          correlation_length_um(HeightSpectrum(sinusoid(300, period_um, azimuth_deg)));
      REQUIRE(found);
      CHECK(*found == Approx(part * period_um).epsilon(0.02));
    }
  }
}

TEST_CASE("Gaussian hills are correlated over their correlation length", "[roughness]") {
  // White noise under a kernel exp(-r^2 / s^2) has the autocorrelation exp(-r^2 / (2 s^2)).
  std::mt19937_64 engine(7);
  constexpr Eigen::Index n = 256, reach = 20;
  const double s_px = 5;
  brdf::HeightArray noise(n + 2 * reach, n + 2 * reach), rows(n + 2 * reach, n), heights(n, n);
  for (double& value : noise.reshaped<Eigen::RowMajor>())
    value = static_cast<double>(engine() >> 11) * 0x1p-53 - 0.5;
  rows.setZero();
  heights.setZero();
  for (Eigen::Index d = 0; d <= 2 * reach; ++d) {
    const double weight = std::exp(-std::pow(static_cast<double>(d - reach) / s_px, 2));
    rows += weight * noise.middleCols(d, n);
  }
  for (Eigen::Index d = 0; d <= 2 * reach; ++d) {
    const double weight = std::exp(-std::pow(static_cast<double>(d - reach) / s_px, 2));
    heights += weight * rows.middleRows(d, n);
  }
  const brdf::HeightField field(heights, brdf::Length::um(0.1), brdf::Length::um(0.1));
  const auto found = correlation_length_um(HeightSpectrum(field));
  REQUIRE(found);
  // 10 %: some 400 independent hills under the window, and the shortest of all directions counts.
  CHECK(*found == Approx(std::sqrt(2.0) * s_px * 0.1).epsilon(0.1));
}

TEST_CASE("a flat surface has no correlation length", "[roughness]") {
  const auto flat = sampled(50, 50, 0.1, 0.1, [](double, double) { return 0.25; });
  CHECK_FALSE(correlation_length_um(HeightSpectrum(flat)));
}

TEST_CASE("the spectrum holds the amplitude and the variance of a component", "[roughness]") {
  // 20 cycles in 40 um; 1e-4: sidelobes of the window, cut at 0.011, at twice the frequency.
  const HeightSpectrum spectrum(sinusoid(300, 2, 0));
  CHECK(spectrum.amplitude_um(spectrum.power(0, 20)) == Approx(0.1).epsilon(1e-4));
  CHECK(spectrum.power(0, -20) == spectrum.power(0, 20));
  CHECK(spectrum.power(0, 20 + 400) == spectrum.power(0, 20));
  CHECK(spectrum.variance_um2() == Approx(0.005).epsilon(1e-4));
}
