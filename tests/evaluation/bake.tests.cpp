#include "evaluation/bake.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "brdf/synthetic_surface.h"
#include "evaluation/spectral_colours.h"
#include "tests/support/figure.h"
#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

namespace {

using brdf::Length;
using brdf::Quantity;
using brdf::Xyz;
using evaluation::DirectionPair;

/// A surface with all that a volume of it is made from and compared with.
struct Bakeable {
  brdf::HeightField field;
  brdf::Surface surface;
  double tolerance;
  brdf::InterferenceReach reach = interference_reach(surface, tolerance);
  brdf::VolumeGrid grid{evaluation::volume_shape(reach, tolerance)};
  std::unique_ptr<evaluation::Amplitude> amplitude = plan();
  evaluation::SpectralPower spectra{
      *amplitude, brdf::AdaptiveIntegral({}, reach, 1e-4, 2 * reach.phase_rad({2, 0, -2}, {})),
      Quantity::relative};

  Bakeable(brdf::HeightField heights, Length sigma, double volume_tolerance)
      : field(std::move(heights)),
        surface{&field, brdf::GaussianWindow(sigma), brdf::SurfaceModel::isolated},
        tolerance(volume_tolerance) {}
  Bakeable(const Bakeable&) = delete;
  Bakeable& operator=(const Bakeable&) = delete;

  std::unique_ptr<evaluation::Amplitude> plan() const {
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

/// 3 um, rough, under a narrow window: a volume of it takes a second.
brdf::HeightField rough() {
  Uniform uniform(11);
  return random_heights(uniform, {20, 20, 0.15, 0.15}, 0, 0.12);
}

brdf::HeightField blazed() {
  return brdf::synthetic_grating({brdf::Profile::blazed, Length::nm(800), Length::nm(200)}, 32, 32,
                                 Length::nm(100), Length::nm(100));
}

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
  const bool lines = GENERATE(false, true);
  CAPTURE(lines);
  const Bakeable baked(lines ? blazed() : rough(), Length::um(0.5), lines ? 1e-2 : 2e-2);
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
  Xyz squared_error, squared;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Xyz error = found[i] + -1.0 * expected[i];
    squared_error = squared_error + Xyz{error.x * error.x, error.y * error.y, error.z * error.z};
    squared = squared + Xyz{expected[i].x * expected[i].x, expected[i].y * expected[i].y,
                            expected[i].z * expected[i].z};
  }
  const double x = figure("volume", lines ? "X of a blaze" : "X of a rough surface",
                          std::sqrt(squared_error.x / squared.x)),
               y = figure("volume", lines ? "Y of a blaze" : "Y of a rough surface",
                          std::sqrt(squared_error.y / squared.y)),
               z = figure("volume", lines ? "Z of a blaze" : "Z of a rough surface",
                          std::sqrt(squared_error.z / squared.z));
  CHECK(squared.y > 0);
  // The tolerance of the volume is that of its rarest parts; the mean is well below it.
  CHECK(x <= baked.tolerance);
  CHECK(y <= baked.tolerance);
  CHECK(z <= baked.tolerance);
}

TEST_CASE("a volume errs by less than its tolerance of the brightness around it, however dark",
          "[bake][oracle]") {
  const Bakeable baked(rough(), Length::um(0.5), 2e-2);
  const std::vector<float> numbers = bake(baked.grid, baked.spectra, {});
  const brdf::ColourVolume volume(baked.grid, numbers);
  // Around: the mean of a ring, whose speckle has one brightness, as the window and the pixels are
  // as round as this surface is rough.
  constexpr int around = 24, count = 150;
  Uniform uniform(13);
  double squares = 0;
  for (int i = 0; i < count; ++i) {
    const double r = uniform(0, 1.9), w = -uniform(0.1, std::sqrt(4 - r * r)),
                 start = uniform(0, 6);
    std::vector<Eigen::Vector3d> ring;
    for (int j = 0; j < around; ++j) {
      const double phi = start + 2 * brdf::pi * j / around;
      ring.emplace_back(r * std::cos(phi), r * std::sin(phi), w);
    }
    std::vector<Xyz> exact(ring.size());
    baked.spectra.evaluate(ring, exact);
    double mean = 0;
    for (const Xyz& colour : exact) mean += colour.y / around;
    const double error = (volume(ring[0].x(), ring[0].y(), w).y - exact[0].y) / mean;
    squares += error * error / count;
  }
  CHECK(figure("volume", "Y against the ring, rms", std::sqrt(squares)) <= baked.tolerance);
}

TEST_CASE("a flat mirror's volume is its lobe, by closed form", "[bake][oracle]") {
  // abs(a)^2 = exp(-(sigma k)^2 (u^2 + v^2)) of a Gaussian window that ends at 6 sigma: 1e-8.
  const double sigma_um = 0.5;
  brdf::HeightArray heights_um = brdf::HeightArray::Zero(40, 40);
  const brdf::HeightField flat(std::move(heights_um), Length::um(0.15), Length::um(0.15));
  const double tolerance = 1e-2;
  const Bakeable baked(flat, Length::um(sigma_um), tolerance);
  const std::vector<float> numbers = bake(baked.grid, baked.spectra, {});
  const brdf::ColourVolume volume(baked.grid, numbers);
  std::vector<Length> wavelengths;
  for (int i = 0; i <= 400; ++i) wavelengths.push_back(Length::nm(380 + i));
  const auto weights = brdf::colour_weights(wavelengths);
  WorstError error;
  for (const double r : {0.0, 0.01, 0.05, 0.1, 0.2, 0.3})
    for (const double phi : {0.0, 0.7, 2.9, -1.3})
      for (const double w : {-2.0, -1.2, -0.3}) {
        double exact = 0;
        for (std::size_t i = 0; i < weights.size(); ++i) {
          const double k = wavenumber_per_um(wavelengths[i]);
          exact += weights[i].y * std::exp(-(sigma_um * k * r) * (sigma_um * k * r));
        }
        error.see(std::abs(volume(r * std::cos(phi), r * std::sin(phi), w).y - exact));
      }
  // Of the white: the lobe is smooth, and sampled five times as finely as its shortest period.
  CHECK(figure("volume", "Y of a flat mirror", error.value()) <= tolerance);
}

TEST_CASE("a finer tolerance takes a finer volume, and its corners hold all its points", "[bake]") {
  const Bakeable baked(rough(), Length::um(0.5), 2e-2);
  const auto coarse = evaluation::volume_shape(baked.reach, 5e-2),
             fine = evaluation::volume_shape(baked.reach, 5e-3);
  CHECK(fine.relative_step < coarse.relative_step);
  CHECK(fine.terms > coarse.terms);
  const double r = baked.grid.radius(baked.grid.rings() - 1);
  Eigen::Vector3d lo(0, 0, -1), hi = lo;
  for (const Eigen::Vector3d& s : evaluation::volume_corners(baked.grid)) {
    lo = lo.cwiseMin(s);
    hi = hi.cwiseMax(s);
  }
  CHECK(lo == Eigen::Vector3d(-r, -r, -2));
  CHECK(hi == Eigen::Vector3d(r, r, 0));
}

TEST_CASE("a bake past its time limit is refused", "[bake]") {
  const Bakeable baked(rough(), Length::um(0.5), 5e-2);
  evaluation::RunLimits late;
  late.time = {std::chrono::steady_clock::now() - std::chrono::hours(1),
               std::chrono::duration<double>(1)};
  CHECK_ERROR(bake(baked.grid, baked.spectra, late), brdf::Errc::over_limit, "--time-limit");
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
    CHECK_ERROR(evaluation::DiffractionColours(one, {none, 1}), brdf::Errc::invalid_argument,
                "white");
    CHECK_ERROR(evaluation::white_scale(none), brdf::Errc::invalid_argument, "white");
    CHECK_ERROR(evaluation::spectral_factor(none, Length::nm(500)), brdf::Errc::invalid_argument,
                "white");
  }
}
