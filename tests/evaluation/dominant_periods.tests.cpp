#include "evaluation/dominant_periods.h"

#include <catch2/catch.hpp>
#include <random>

#include "brdf/levelling.h"
#include "tests/support/real_data.h"
#include "tests/support/real_scans.h"
#include "tests/support/surfaces.h"

using brdf::Length;
using brdf::Profile;
using evaluation::dominant_periods;
using evaluation::HeightPeriod;

namespace {

std::vector<HeightPeriod> periods_of(const brdf::HeightField& field) {
  return dominant_periods(brdf::HeightSpectrum(brdf::levelled(field, brdf::Level::plane)));
}

brdf::HeightField grating(Profile profile, double period_um, Eigen::Index rows,
                          double pixel_um = 0.1) {
  return brdf::synthetic_grating({profile, Length::um(period_um), Length::um(0.2)}, rows, 650,
                                 Length::um(pixel_um), Length::um(pixel_um));
}

/// The smallest angle between two lines [deg].
double apart_deg(double a_deg, double b_deg) {
  return std::abs(std::remainder(a_deg - b_deg, 180));
}

constexpr Eigen::Index n = 256;
double uniform(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53 - 0.5;
}
brdf::HeightField on_pixels(brdf::HeightArray heights_um) {
  return brdf::HeightField(std::move(heights_um), Length::um(0.04), Length::um(0.04));
}

}  // namespace

TEST_CASE("the period of a grating is found between the bins", "[periods]") {
  for (const auto profile : {Profile::sinusoid, Profile::blazed, Profile::lamellar})
    for (const double period_um : {1.15, 2.5, 7.3})
      for (const Eigen::Index rows : {1, 40}) {
        const auto periods = periods_of(grating(profile, period_um, rows));
        INFO(period_um << " um, " << rows << " rows, profile " << static_cast<int>(profile));
        REQUIRE(!periods.empty());
        // 1e-3: 0.01 bins at the 8.9 periods of the longest; levelling a blaze takes part of it.
        CHECK(periods[0].period.um() == Approx(period_um).epsilon(2e-3));
        CHECK(periods[0].azimuth.deg() == Approx(0).margin(1e-6));
        CHECK_FALSE(periods[0].harmonic);
        for (std::size_t i = 1; i < periods.size(); ++i) CHECK(periods[i].harmonic);
      }
}

TEST_CASE("a component's depth is its Fourier coefficient's", "[periods]") {
  // Peak to valley of the first sinusoid in a profile of height 1: 1, 2/pi, 4/pi, 8/pi^2.
  const std::pair<Profile, double> expected[]{{Profile::sinusoid, 1},
                                              {Profile::blazed, 2 / brdf::pi},
                                              {Profile::lamellar, 4 / brdf::pi},
                                              {Profile::triangle, 8 / (brdf::pi * brdf::pi)}};
  for (const auto& [profile, depth] : expected) {
    const auto periods = periods_of(grating(profile, 2.5, 40));
    REQUIRE(!periods.empty());
    // 1 %: 25 samples a period.
    CHECK(periods[0].depth_um == Approx(0.2 * depth).epsilon(0.01));
  }
}

TEST_CASE("the harmonics of a lamellar grating are odd, folded ones too", "[periods]") {
  // 1.15 um in pixels of 0.1 um: from the 6th on they fold.
  const auto periods = periods_of(grating(Profile::lamellar, 1.15, 40));
  REQUIRE(periods.size() == 6);
  for (std::size_t i = 1; i < periods.size(); ++i) {
    REQUIRE(periods[i].harmonic);
    CHECK(periods[i].harmonic->of == 0);
    CHECK(periods[i].harmonic->order == static_cast<int>(2 * i + 1));
  }
}

TEST_CASE("few periods are enough of a grating, too few are not", "[periods][crossover]") {
  const auto three = periods_of(grating(Profile::sinusoid, 20, 40));
  REQUIRE(three.size() == 1);
  CHECK(three[0].period.um() == Approx(20).epsilon(0.01));
  CHECK(periods_of(grating(Profile::sinusoid, 40, 40)).empty());
}

TEST_CASE("two crossed gratings are two periods with their azimuths", "[periods]") {
  const auto field = sampled(300, 400, 0.1, 0.07, [](double x, double y) {
    const auto wave = [&](double period_um, double azimuth_deg) {
      const double phi = brdf::Angle::deg(azimuth_deg).rad();
      return std::cos(2 * brdf::pi * (x * std::cos(phi) + y * std::sin(phi)) / period_um);
    };
    return 0.1 * wave(1.3, 20) + 0.06 * wave(0.9, -65);
  });
  const auto periods = periods_of(field);
  REQUIRE(periods.size() == 2);
  CHECK(periods[0].period.um() == Approx(1.3).epsilon(1e-3));
  CHECK(periods[0].azimuth.deg() == Approx(20).margin(0.05));
  CHECK(periods[1].period.um() == Approx(0.9).epsilon(1e-3));
  CHECK(periods[1].azimuth.deg() == Approx(-65).margin(0.05));
  CHECK(periods[1].depth_um == Approx(0.12).epsilon(0.01));
}

TEST_CASE("a flat surface has no period", "[periods]") {
  CHECK(periods_of(on_pixels(brdf::HeightArray::Constant(n, n, 0.3))).empty());
}

TEST_CASE("rough surfaces have no period, whatever their grain", "[periods][seeded]") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    std::mt19937_64 engine(seed);
    brdf::HeightArray white(n, n);
    for (double& value : white.reshaped<Eigen::RowMajor>()) value = uniform(engine);
    CHECK(periods_of(on_pixels(white)).empty());
    brdf::HeightArray streaks = white;  // lines of a scan, each at its own height
    for (Eigen::Index row = 0; row < n; ++row) streaks.row(row) += 4 * uniform(engine);
    CHECK(periods_of(on_pixels(streaks)).empty());
    brdf::HeightArray walk = white;  // power that falls as the square of the frequency
    for (Eigen::Index row = 1; row < n; ++row) walk.row(row) += walk.row(row - 1);
    CHECK(periods_of(on_pixels(walk)).empty());
  }
}

TEST_CASE("a period buried in noise is found while it stands clear", "[periods][seeded]") {
  // Amplitude 0.1 in white noise of variance 1/12: the power is 0.05 n^2 / 5.7 to 1/12 a bin.
  std::mt19937_64 engine(4);
  auto field = sampled(n, n, 0.04, 0.04, [&](double x, double y) {
    return 0.1 * std::cos(2 * brdf::pi * (x + y) / 0.5) + uniform(engine);
  });
  const auto periods = periods_of(field);
  REQUIRE(periods.size() == 1);
  CHECK(periods[0].period.um() == Approx(0.5 / std::sqrt(2.0)).epsilon(0.005));
  CHECK(periods[0].azimuth.deg() == Approx(45).margin(0.5));
}

TEST_CASE("the periods of real gratings are those known", "[periods][real]") {
  const auto folder = real_data();
  if (!folder) return;
  const auto of = [&](const std::string& name) {
    return periods_of(read_scan(*folder, name).field);
  };
  const auto grating = of("grating_317nm.gsf");
  REQUIRE(!grating.empty());
  CHECK(grating[0].period.nm() == Approx(316.59).margin(0.4));
  CHECK(grating[0].azimuth.deg() == Approx(45.5).margin(0.3));
  const auto turned = of("turned_9um_nonsquare.gsf");
  REQUIRE(!turned.empty());
  CHECK(turned[0].period.um() == Approx(9.13).margin(0.2));
  const auto pillars = of("pillars_10um.gsf");
  REQUIRE(pillars.size() >= 2);
  CHECK(pillars[0].period.um() == Approx(10.12).margin(0.05));
  CHECK(apart_deg(pillars[0].azimuth.deg(), 5.6) < 0.3);
  CHECK(pillars[1].period.um() == Approx(9.88).margin(0.05));
  CHECK(apart_deg(pillars[1].azimuth.deg(), -85) < 0.3);
}

TEST_CASE("the periods of snake skins lie where their ridges do", "[periods][real]") {
  const auto folder = real_data();
  if (!folder) return;
  const auto check = [&](const std::string& name, double lo_um, double hi_um, double azimuth_deg) {
    INFO(name);
    const auto periods = periods_of(read_scan(*folder, name).field);
    REQUIRE(!periods.empty());
    for (const HeightPeriod& period : periods) {
      CHECK(period.period.um() > lo_um);
      CHECK(period.period.um() < hi_um);
      CHECK(apart_deg(period.azimuth.deg(), azimuth_deg) < 15);
    }
  };
  check("elaphe_65um.png", 0.94, 1.2, 0);
  check("xenopeltis_65um.png", 1.4, 1.65, 90);
}

TEST_CASE("a measured rough surface has no period", "[periods][real]") {
  const auto folder = real_data();
  if (!folder) return;
  CHECK(periods_of(read_scan(*folder, "rough_matrix.txt").field).empty());
}
