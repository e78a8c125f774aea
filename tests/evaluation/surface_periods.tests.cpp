#include "evaluation/period/surface_periods.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "brdf/levelling.h"
#include "brdf/synthetic_surface.h"
#include "tests/support/figure.h"
#include "tests/support/is_error.h"
#include "tests/support/real_data.h"
#include "tests/support/real_scans.h"
#include "tests/support/surfaces.h"

using brdf::Angle;
using brdf::Errc;
using brdf::HeightField;
using brdf::Length;
using brdf::Profile;
using evaluation::Frequency;
using evaluation::PeriodEstimate;
using evaluation::surface_periods;
using evaluation::SurfacePeriod;

namespace {

/// Periods in um that are multiples of neither the pixel, 0.1 um, nor the patches.
const std::vector<double> periods_um{0.813,  0.947,  1.1537, 1.3331, 1.6181, 1.9473,
                                     2.3339, 2.7183, 3.1416, 3.7707, 4.3519, 4.9391};

/// A patch of at least ten periods, 65 um wide where that is more.
Eigen::Index columns_for(double period_um) {
  return static_cast<Eigen::Index>(std::max(65.0, 10.4 * period_um) / 0.1);
}

/// A sawtooth's first three harmonics, softened: band-limited to three times the frequency.
double smoothed_blaze(double t) {
  double height = 0.5;
  for (int m = 1; m <= 3; ++m) {
    const double x = brdf::pi * m / 4;
    height += std::sin(x) / x * std::sin(2 * brdf::pi * m * t) / (brdf::pi * m);
  }
  return height;
}

template <class Shape>
PeriodEstimate estimate_of(double period_um, double phase, Eigen::Index rows, Shape shape) {
  const HeightField field =
      sampled(rows, columns_for(period_um), 0.1, 0.1,
              [&](double x_um, double) { return shape(x_um / period_um + phase); });
  const auto periods = surface_periods(field, 1);
  REQUIRE(periods.size() == 1);
  REQUIRE(periods[0].heights);
  return *periods[0].heights;
}

double relative_error(const PeriodEstimate& estimate, double period_um) {
  return estimate.period_nm / (1000 * period_um) - 1;
}

}  // namespace

TEST_CASE("the period of band-limited gratings is right to 5e-6", "[period][oracle][long]") {
  double worst = 0;
  for (const double depth_um : {0.02, 0.2, 0.7})
    for (const double period_um : periods_um) {
      const auto sinusoid = estimate_of(period_um, 0.17, 1, [&](double t) {
        return depth_um * (1 + std::cos(2 * brdf::pi * t)) / 2;
      });
      const auto blaze =
          estimate_of(period_um, 0.31, 1, [&](double t) { return depth_um * smoothed_blaze(t); });
      for (const auto& estimate : {sinusoid, blaze}) {
        const double error = relative_error(estimate, period_um);
        INFO(period_um << " um: " << error);
        // Phases of lines are right to 1e-9 rad; ten of them make the slope right to as much.
        CHECK(std::abs(error) <= 1e-8);
        CHECK(estimate.interval_nm.holds(1000 * period_um));
        CHECK(estimate.interval_nm.width() <= 1e-5 * estimate.period_nm);
        worst = std::max(worst, std::abs(error));
      }
    }
  figure("period", "worst relative error of band-limited profiles", worst);
}

TEST_CASE("the period of sharp edges is as right as their samples allow",
          "[period][oracle][long]") {
  std::vector<double> errors;
  for (const Profile profile : {Profile::blazed, Profile::lamellar})
    for (const double period_um : periods_um)
      for (const double phase : {0.013, 0.391, 0.777}) {
        const auto estimate = estimate_of(period_um, phase, 1, [&](double t) {
          return 0.2 * brdf::profile_height({.profile = profile}, t);
        });
        const double error = std::abs(relative_error(estimate, period_um));
        INFO(static_cast<int>(profile)
             << ", " << period_um << " um, phase " << phase << ": " << error);
        CHECK(estimate.interval_nm.holds(1000 * period_um));
        // Edges known to a pixel agree with periods within about 0.1 um / (N^2 d); worst of these
        // periods, found: 3.2e-4.
        CHECK(error <= 5e-4);
        errors.push_back(error);
      }
  std::sort(errors.begin(), errors.end());
  CHECK(errors[errors.size() / 2] <= 1e-4);
}

TEST_CASE("light from either side agrees with the heights of a blaze", "[period][oracle]") {
  for (const double period_um : {0.947, 2.5, 4.3519}) {
    const brdf::SyntheticSurface blaze{.grating = {.profile = Profile::blazed,
                                                   .period = Length::um(period_um),
                                                   .height = Length::um(0.6)},
                                       .edges = brdf::Edges::averaged};
    const auto periods = surface_periods(brdf::synthetic_surface(blaze, 4, columns_for(period_um),
                                                                 Length::um(0.1), Length::um(0.1)));
    REQUIRE(!periods.empty());
    INFO(period_um);
    for (const auto& light : {periods[0].left, periods[0].right}) {
      REQUIRE(light);
      // An edge in half a pixel of another height is a step of light: known to a pixel, 1.5e-3 of
      // the longest period over its 15 lines.
      CHECK(light->period_nm == Approx(1000 * period_um).epsilon(1.5e-3));
    }
    // A plane through the blaze would send the light of one side 6e-3 off that of the other.
    CHECK(periods[0].left->period_nm == Approx(periods[0].right->period_nm).epsilon(2e-3));
  }
}

TEST_CASE("a grating at an angle has its period and direction", "[period][oracle]") {
  for (const double degrees : {17.0, 45.0, 90.0, -62.0}) {
    const double period_um = 1.5707, azimuth = Angle::deg(degrees).rad();
    const HeightField field = sampled(300, 260, 0.1, 0.13, [&](double x, double y) {
      return 0.1 * std::cos(2 * brdf::pi * (x * std::cos(azimuth) + y * std::sin(azimuth)) /
                            period_um) +
             0.02 * x - 0.01 * y;  // and a tilt
    });
    const auto periods = surface_periods(field, 1);
    REQUIRE(periods.size() == 1);
    REQUIRE(periods[0].heights);
    INFO(degrees << " deg: " << periods[0].heights->period_nm);
    // 17 to 25 periods; the corners of the patch hold parts of lines only.
    CHECK(std::abs(relative_error(*periods[0].heights, period_um)) <= 5e-6);
    CHECK(std::abs(std::remainder(periods[0].heights->frequency.azimuth().deg() - degrees, 180)) <=
          1e-3);
    CHECK(periods[0].agree());
  }
}

TEST_CASE("a period that differs from strip to strip is known less well", "[period][oracle]") {
  // Too close for two lines: 0.3 cycles apart over the patch.
  const brdf::SyntheticSurface halves{.grating = {.profile = Profile::sinusoid,
                                                  .period = Length::um(1.5),
                                                  .height = Length::um(0.2)},
                                      .second = brdf::SecondPopulation{Length::um(1.515)}};
  const auto periods = surface_periods(
      brdf::synthetic_surface(halves, 160, 450, Length::um(0.1), Length::um(0.1)), 1);
  REQUIRE(periods.size() == 1);
  REQUIRE(periods[0].heights);
  const PeriodEstimate& estimate = *periods[0].heights;
  CHECK(estimate.interval_nm.holds(1500));
  CHECK(estimate.interval_nm.holds(1515));
  // Two strips of each: their deviation is 8.66 nm.
  CHECK(estimate.parts.patches_nm == Approx(8.66).epsilon(0.05));
}

TEST_CASE("a lattice has two vectors, a grating one", "[period][oracle][long]") {
  const brdf::SyntheticSurface lattice{
      .grating = {.profile = Profile::lamellar,
                  .period = Length::um(3.17),
                  .height = Length::um(0.2)},
      .direction = Angle::deg(8),
      .layout = brdf::CrossedLines{Length::um(2.71), Angle::deg(80)}};
  const HeightField field =
      brdf::synthetic_surface(lattice, 500, 500, Length::um(0.1), Length::um(0.1));
  const auto periods = surface_periods(field);
  const auto vectors = evaluation::lattice_of(periods);
  REQUIRE(vectors);
  const auto& a = *periods[vectors->first].heights;
  const auto& b = *periods[vectors->second].heights;
  const auto& longer = a.period_nm > b.period_nm ? a : b;
  const auto& shorter = a.period_nm > b.period_nm ? b : a;
  CHECK(longer.interval_nm.holds(3170));
  CHECK(shorter.interval_nm.holds(2710));
  // Edges at an angle take all places within a pixel: 0.1 um / (16^1.5 2.7 um) = 6e-4.
  CHECK(longer.period_nm == Approx(3170).epsilon(1e-3));
  CHECK(shorter.period_nm == Approx(2710).epsilon(1e-3));
  CHECK(longer.frequency.azimuth().deg() == Approx(8).margin(0.1));
  CHECK(shorter.frequency.azimuth().deg() == Approx(88).margin(0.1));
}

TEST_CASE("intervals cover in 92 to 98 % of disordered gratings", "[period][oracle][long]") {
  struct Case {
    const char* name;
    brdf::Disorder jitter;
    double noise_um;
  };
  const double period_um = 1.5707;
  const Case cases[]{{"places scatter by 5 % of the period",
                      {Length::um(0.05 * period_um), brdf::DisorderKind::position},
                      0},
                     {"distances scatter by 3 % of the period",
                      {Length::um(0.03 * period_um), brdf::DisorderKind::spacing},
                      0},
                     {"white noise, a fifth of the depth", {}, 0.04}};
  constexpr int replicas = 500;
  for (const Case& c : cases) {
    int held = 0;
    std::vector<double> widths;
    for (int replica = 0; replica < replicas; ++replica) {
      const brdf::SyntheticSurface surface{.grating = {.profile = Profile::blazed,
                                                       .period = Length::um(period_um),
                                                       .height = Length::um(0.2)},
                                           .jitter = c.jitter,
                                           .noise = Length::um(c.noise_um),
                                           // Sampled, an edge is known to a pixel, 0.4 rad, and
                                           // disorder of half a pixel is no longer normal.
                                           .edges = brdf::Edges::averaged,
                                           .seed = 1000 + static_cast<std::uint64_t>(replica)};
      const HeightField field =
          brdf::synthetic_surface(surface, 1, 650, Length::um(0.1), Length::um(0.1));
      const PeriodEstimate estimate = estimate_period(
          evaluation::height_wave(brdf::levelled(field, brdf::Level::plane)), {1 / period_um, 0});
      held += estimate.interval_nm.holds(1000 * period_um) ? 1 : 0;
      widths.push_back(estimate.interval_nm.width() / (1000 * period_um));
    }
    std::nth_element(widths.begin(), widths.begin() + replicas / 2, widths.end());
    const double share = static_cast<double>(held) / replicas;
    INFO(c.name);
    figure("period: covered", c.name, share);
    figure("period: width, median", c.name, widths[replicas / 2]);
    CHECK(share >= 0.92);
    CHECK(share <= 0.98);
  }
}

TEST_CASE("two populations 3 % apart are both found", "[period][oracle]") {
  // Halves of the rows each, and one upon the other.
  const double first_um = 1.0313, second_um = first_um * 1.03;
  const brdf::SyntheticSurface halves{.grating = {.profile = Profile::sinusoid,
                                                  .period = Length::um(first_um),
                                                  .height = Length::um(0.2)},
                                      .second = brdf::SecondPopulation{Length::um(second_um)}};
  const HeightField side_by_side =
      brdf::synthetic_surface(halves, 300, 900, Length::um(0.1), Length::um(0.1));
  const HeightField upon = sampled(40, 900, 0.1, 0.1, [&](double x, double) {
    return 0.1 * std::cos(2 * brdf::pi * x / first_um) +
           0.07 * std::cos(2 * brdf::pi * x / second_um);
  });
  for (const HeightField* field : {&side_by_side, &upon}) {
    const auto periods = surface_periods(*field);
    for (const double truth_um : {first_um, second_um}) {
      INFO(truth_um);
      const auto found = std::find_if(periods.begin(), periods.end(), [&](const SurfacePeriod& p) {
        return p.heights && std::abs(p.heights->period_nm / (1000 * truth_um) - 1) <= 0.01;
      });
      REQUIRE(found != periods.end());
      CHECK(found->in_group);
      CHECK(found->heights->interval_nm.holds(1000 * truth_um));
    }
  }
}

TEST_CASE("what has no period is refused", "[period]") {
  const auto refuses = [](const HeightField& field) {
    CHECK_THROWS_MATCHES(surface_periods(field), brdf::Error,
                         IsError(Errc::not_attainable, "no period"));
  };
  std::mt19937_64 engine(7);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53 - 0.5; };
  refuses(sampled(128, 128, 0.1, 0.1, [&](double, double) { return uniform(); }));
  refuses(sampled(64, 64, 0.1, 0.1, [](double, double) { return 0.0; }));
  refuses(sampled(200, 200, 0.1, 0.1, [](double x, double y) {  // rings
    return 0.1 * std::cos(2 * brdf::pi * std::hypot(x, y) / 1.57);
  }));
}

TEST_CASE("fewer than five lines make no period", "[period]") {
  const HeightField field = sampled(
      1, 300, 0.1, 0.1, [](double x, double) { return 0.1 * std::cos(2 * brdf::pi * x / 7.7); });
  const auto periods = surface_periods(field);
  REQUIRE(periods.size() == 1);
  CHECK_FALSE(periods[0].heights);
  CHECK_THAT(periods[0].reason, Catch::Contains("3 lines") || Catch::Contains("4 lines"));
}

TEST_CASE("the periods of real scans are those measured by others", "[period][real]") {
  const auto folder = real_data();
  if (!folder) return;
  struct Known {
    const char* file;
    std::vector<double> periods_nm;
    double widest_nm;  ///< three times the drift that the data's README gives, to either side
  };
  const double none = 1e9;
  for (const Known& known : {Known{"grating_317nm.gsf", {316.6}, 3 * 0.2},
                             Known{"pillars_10um.gsf", {10120, 9880}, none},
                             Known{"turned_9um_nonsquare.gsf", {9130}, 3 * 160}}) {
    INFO(known.file);
    const auto periods = surface_periods(read_scan(*folder, known.file).field);
    for (const double truth_nm : known.periods_nm) {
      const auto found = std::find_if(periods.begin(), periods.end(), [&](const SurfacePeriod& p) {
        return p.heights && p.heights->interval_nm.holds(truth_nm);
      });
      INFO(truth_nm);
      REQUIRE(found != periods.end());
      CHECK(found->heights->interval_nm.width() / 2 <= known.widest_nm);
      CHECK(found->agree());
    }
  }
}

TEST_CASE("a measured rough surface is refused", "[period][real]") {
  const auto folder = real_data();
  if (!folder) return;
  CHECK_ERROR(surface_periods(read_scan(*folder, "rough_matrix.txt").field), Errc::not_attainable,
              "no period");
}

TEST_CASE("light from either side gives intervals that overlap on skins", "[period][real][long]") {
  const auto folder = real_data();
  if (!folder) return;
  for (const char* name : {"elaphe_65um.png", "xenopeltis_65um.png"}) {
    INFO(name);
    const auto periods = surface_periods(read_scan(*folder, name).field);
    CHECK(periods.size() >= 3);
    std::size_t measured = 0;
    for (const SurfacePeriod& p : periods) {
      if (p.left && p.right) CHECK(p.left->interval_nm.overlaps(p.right->interval_nm));
      if (p.heights) {
        ++measured;
        CHECK(p.heights->interval_nm.holds(p.heights->period_nm));
        CHECK(p.agree());
      }
    }
    CHECK(measured >= 3);
  }
}
