// The parts that a period is measured from: a line's place, its phases, the folded profile.
#include "evaluation/period/spectral_line.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "brdf/line_places.h"
#include "evaluation/period/folded_period.h"
#include "evaluation/period/line_phases.h"
#include "evaluation/period/slope_posterior.h"
#include "tests/support/is_error.h"
#include "tests/support/surfaces.h"

using evaluation::Frequency;
using evaluation::height_wave;
using evaluation::line_phases;
using evaluation::LinePhases;
using evaluation::refined_line;

namespace {

constexpr double two_pi = 2 * brdf::pi;

/// A sinusoid along an azimuth with a second and third harmonic, a tilt and a bow.
brdf::HeightField wavy(double period_um, double azimuth_rad) {
  return sampled(120, 160, 0.1, 0.12, [=](double x, double y) {
    const double t = (x * std::cos(azimuth_rad) + y * std::sin(azimuth_rad)) / period_um;
    return std::cos(two_pi * t) + 0.4 * std::sin(2 * two_pi * t) + 0.2 * std::cos(3 * two_pi * t) +
           0.3 * x;
  });
}

}  // namespace

TEST_CASE("a line's place is found between the bins to 1e-7", "[spectral_line][oracle]") {
  const double period_um = 1.0517;
  for (const double azimuth : {0.0, 0.6, 1.3}) {
    const brdf::HeightField field = sampled(200, 220, 0.1, 0.1, [=](double x, double y) {
      return std::cos(two_pi * (x * std::cos(azimuth) + y * std::sin(azimuth)) / period_um + 0.4);
    });
    const Frequency truth{std::cos(azimuth) / period_um, std::sin(azimuth) / period_um};
    const Frequency start{truth.x_per_um + 0.3 / 22, truth.y_per_um - 0.3 / 20};
    const auto found = refined_line(height_wave(field), start);
    REQUIRE(found);
    // 19 periods: the window's tails weigh 4e-6 at the edges.
    CHECK(evaluation::distance_per_um(*found, truth) <= 1e-7 / period_um);
  }
}

TEST_CASE("a start away from any line finds none", "[spectral_line]") {
  const brdf::HeightField field =
      sampled(1, 400, 0.1, 0.1, [](double x, double) { return std::cos(two_pi * x / 1.57); });
  CHECK_FALSE(refined_line(height_wave(field), {1 / 1.57 + 5.0 / 40, 0}));
}

TEST_CASE("phases of lines do not see tilt, harmonics or the patch's edges",
          "[line_phases][oracle]") {
  for (const double azimuth : {0.0, 0.35, 1.2}) {
    const double period_um = 1.313;
    const Frequency f{std::cos(azimuth) / period_um, std::sin(azimuth) / period_um};
    const LinePhases phases = line_phases(height_wave(wavy(period_um, azimuth)), f);
    CHECK(phases.size() >= 7);
    for (const double phase : phases.phase_rad) CHECK(std::abs(phase) <= 1e-9);  // rounding
    // exp(2 pi i t) holds half of the cosine.
    for (const double amplitude : phases.amplitude) CHECK(amplitude == Approx(0.5).epsilon(1e-9));
  }
}

TEST_CASE("phases of light do not see a bow", "[line_phases][oracle]") {
  const double period_um = 1.313, c_per_um = -20;
  const auto light = [&](double bow) {
    return line_phases(evaluation::light_wave(
                           sampled(1, 300, 0.1, 0.1,
                                   [=](double x, double) {
                                     return 0.03 * std::cos(two_pi * x / period_um) + bow * x * x;
                                   }),
                           c_per_um),
                       {1 / period_um, 0});
  };
  const LinePhases flat = light(0), bowed = light(1e-4);
  REQUIRE(flat.size() == bowed.size());
  // A bow of 22 nm at the edge shifts the lobe by 2 % of a line's phase there and back; what is
  // left is of second order in its change over one line.
  for (std::size_t i = 0; i < flat.size(); ++i)
    CHECK(std::abs(bowed.phase_rad[i] - flat.phase_rad[i]) <= 2e-3);
}

TEST_CASE("the slope of even lines is exact, and of too few refused", "[slope_posterior]") {
  LinePhases phases;
  for (int i = -6; i <= 6; ++i) {
    phases.line.push_back(i);
    phases.phase_rad.push_back(0.3 + 0.0123 * i);
    phases.weight.push_back(1);
    phases.amplitude.push_back(1);
  }
  const auto slope = evaluation::slope_posterior(phases);
  CHECK(slope.median == Approx(0.0123).epsilon(1e-8));
  CHECK(slope.interval.holds(0.0123));
  CHECK(slope.interval.width() <= 1e-8);
  phases.line.resize(4);
  phases.phase_rad.resize(4);
  phases.weight.resize(4);
  CHECK_ERROR(evaluation::slope_posterior(phases), brdf::Errc::not_attainable, "4 lines");
}

TEST_CASE("lines that drift are told from lines that scatter", "[slope_posterior][oracle]") {
  const auto phases_of = [](brdf::DisorderKind kind) {
    const brdf::LinePlaces places({brdf::Length::um(0.05), kind}, brdf::Length::um(1), 40,
                                  brdf::random_engine(3, 0));
    LinePhases phases;
    for (std::size_t i = 0; i < 61; ++i) {
      const double number = static_cast<double>(i) - 30;
      phases.line.push_back(number);
      phases.weight.push_back(1);
      phases.amplitude.push_back(1);
      phases.phase_rad.push_back(two_pi * (places.places().at(i) - number));
    }
    return phases;
  };
  const auto scattered = evaluation::slope_posterior(phases_of(brdf::DisorderKind::position));
  const auto drifting = evaluation::slope_posterior(phases_of(brdf::DisorderKind::spacing));
  CHECK(scattered.accumulated_share <= 0.1);
  CHECK(drifting.accumulated_share >= 0.5);
  // n^-1/2 against 12^1/2 n^-3/2.
  CHECK(drifting.interval.width() >= 5 * scattered.interval.width());
}

TEST_CASE("folding holds the truth for every sampled edge, and refuses noise", "[folded_period]") {
  for (const double period_um : {1.3331, 2.3339, 4.9391})
    for (const double phase : {0.013, 0.41, 0.777}) {
      const auto edges = sampled(1, 650, 0.1, 0.1, [=](double x, double) {
        return brdf::profile_height({.profile = brdf::Profile::lamellar}, x / period_um + phase);
      });
      const auto found = evaluation::folded_period_um(height_wave(edges), period_um * 1.0004, 6e-3);
      REQUIRE(found);
      CHECK(found->holds(period_um));
      CHECK(found->width() <= 3e-3 * period_um);
    }
  const auto noisy = sampled(1, 650, 0.1, 0.1, [](double x, double) {
    return std::cos(two_pi * x / 1.57) + 0.3 * std::sin(1e4 * x * x);
  });
  CHECK_FALSE(evaluation::folded_period_um(height_wave(noisy), 1.57, 2e-3));
}
