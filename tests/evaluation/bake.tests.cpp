#include "evaluation/bake.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "brdf/synthetic_profile.h"
#include "evaluation/spectral_colours.h"
#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"

namespace {

using brdf::Length;
using brdf::Quantity;
using brdf::Xyz;
using evaluation::DirectionPair;

/// A rough surface of 3 um under a narrow window: a volume of it takes a second.
struct Baked {
  Uniform uniform{11};
  brdf::HeightField field = random_heights(uniform, {20, 20, 0.15, 0.15}, 0, 0.12);
  brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(0.5)),
                        brdf::SurfaceModel::isolated};
  static constexpr double tolerance = 2e-2;
  brdf::InterferenceReach reach = interference_reach(surface, tolerance);
  brdf::VolumeGrid grid{evaluation::volume_shape(reach, tolerance)};
  std::unique_ptr<evaluation::Amplitude> amplitude = plan();
  evaluation::SpectralPower spectra{
      *amplitude, brdf::AdaptiveIntegral({}, reach, 1e-4, 2 * reach.phase_rad({2, 0, -2}, {})),
      Quantity::relative};

  std::unique_ptr<evaluation::Amplitude> plan() {
    std::vector<brdf::Query> corners;
    for (const Eigen::Vector3d& s : evaluation::volume_corners(grid)) {
      const Eigen::Vector3d q = brdf::SpectralBand().k_hi_per_um() * (1 + 1e-12) * s;
      corners.push_back({q.x(), q.y(), q.z()});
    }
    brdf::QueryBounds bounds = brdf::bounds_of(corners, 1e-6);
    bounds.count = 10'000'000;
    return evaluation::method_named("chebyshev").plan(surface, bounds, {});
  }
};

std::vector<DirectionPair> random_pairs(int count) {
  Uniform uniform(5);
  std::vector<DirectionPair> pairs;
  for (int i = 0; i < count; ++i)
    pairs.push_back({random_direction(uniform), random_direction(uniform)});
  return pairs;
}

}  // namespace

TEST_CASE("a volume gives the colours of its spectra, with the same bits for any threads",
          "[bake][oracle]") {
  const Baked baked;
  const std::vector<float> numbers = bake(baked.grid, baked.spectra, {});
  evaluation::RunLimits three;
  three.threads = 3;
  double progress = 0;
  CHECK(numbers == bake(baked.grid, baked.spectra, three, [&](double part) { progress = part; }));
  CHECK(progress == 1);

  const evaluation::BakedColours volume(brdf::ColourVolume(baked.grid, numbers));
  const auto pairs = random_pairs(400);
  const evaluation::DiffractionColours direct(baked.spectra, {}), read(volume, {});
  std::vector<Xyz> expected(pairs.size()), found(pairs.size());
  direct.evaluate(pairs, expected);
  read.evaluate(pairs, found);
  double squared_error = 0, squared = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    squared_error += (found[i].y - expected[i].y) * (found[i].y - expected[i].y);
    squared += expected[i].y * expected[i].y;
  }
  CHECK(squared > 0);
  // The tolerance of the volume is that of its rarest parts; the mean is well below it.
  CHECK(std::sqrt(squared_error / squared) <= Baked::tolerance);
}

TEST_CASE("a colour is the gain times V, and of a radiance pi (1 um / lambda)^2 besides",
          "[bake][invariant]") {
  struct One final : evaluation::ScatteringColours {
    void evaluate(std::span<const Eigen::Vector3d> s, std::span<Xyz> colours) const override {
      for (std::size_t i = 0; i < s.size(); ++i) colours[i] = {s[i].x(), 1, s[i].z()};
    }
  } const one;
  const auto pairs = random_pairs(20);
  const evaluation::Optics relative{}, radiance{Quantity::radiance, 700};
  std::vector<Xyz> a(pairs.size()), b(pairs.size());
  evaluation::DiffractionColours(one, relative).evaluate(pairs, a);
  evaluation::DiffractionColours(one, radiance).evaluate(pairs, b);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [omega_i, omega_r] = pairs[i];
    // Rounding of a few factors.
    CHECK(a[i].y == Approx(brdf::relative_gain(omega_i, omega_r)).epsilon(1e-14));
    CHECK(a[i].x == Approx(-a[i].y * (omega_i + omega_r).x()).epsilon(1e-13).margin(1e-13));
    CHECK(b[i].y == Approx(brdf::pi * 700 * a[i].y).epsilon(1e-13));
  }
  CHECK(evaluation::spectral_factor(Quantity::relative, Length::nm(500)) == 1);
  CHECK(evaluation::spectral_factor(Quantity::radiance, Length::nm(500)) == Approx(4));
  for (const auto none : {Quantity::power, Quantity::brdf}) {
    CHECK_ERROR(evaluation::white_scale(none), brdf::Errc::invalid_argument, "white");
    CHECK_ERROR(evaluation::spectral_factor(none, Length::nm(500)), brdf::Errc::invalid_argument,
                "white");
  }
}
