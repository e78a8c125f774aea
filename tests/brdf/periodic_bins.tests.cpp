#include "brdf/periodic_bins.h"

#include <catch2/catch.hpp>

#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::GaussianWindow;
using brdf::HeightField;
using brdf::Length;
using brdf::omitted_neighbours_bound;
using brdf::Origin;
using brdf::PeriodicBins;
using brdf::pi;
using brdf::Surface;
using brdf::SurfaceAxis;
using brdf::SurfaceModel;
using Complex = std::complex<double>;

namespace {

struct Setup {
  HeightField field;
  GaussianWindow window;
  SurfaceAxis axis;

  Setup(Eigen::Index count, double pixel_um, double sigma_um, Origin origin = Origin::patch_centre)
      : field(sampled(1, count, pixel_um, 1, [](double, double) { return 0.0; })),
        window(Length::um(sigma_um)),
        axis(brdf::x_axis({&field, window, SurfaceModel::periodic, origin})) {}
  PeriodicBins bins(double radius) const { return {window, axis, radius}; }
};

/// The identity that the model rests on: for one pixel n of the patch,
/// 1/N sum_j W_j exp(2 pi i j (n - x0) / N) = sum_copies g exp(i q x) / sum g.
double single_pixel_error(const Setup& setup) {
  constexpr std::uint64_t seed = 51;
  Uniform uniform(seed);
  const PeriodicBins bins = setup.bins(9);
  const auto count = static_cast<double>(setup.axis.count);
  const double sum_g =
      brdf::window_sums({&setup.field, setup.window, SurfaceModel::periodic}, setup.axis).g;
  WorstError error;
  for (int trial = 0; trial < 20; ++trial) {
    const double q_per_um = uniform(-40, 40);
    for (Eigen::Index pixel = 0; pixel < setup.axis.count; ++pixel) {
      Complex by_bins = 0, by_copies = 0;
      for (long j = bins.first(q_per_um); j <= bins.last(q_per_um); ++j)
        by_bins += bins.weight(q_per_um, j) * bins.origin_phase(j) *
                   std::polar(1.0, 2 * pi * static_cast<double>(j * pixel) / count);
      for (int copy = setup.axis.first_copy; copy <= setup.axis.last_copy; ++copy) {
        const double x_um = setup.axis.position_um(pixel, copy);
        by_copies += std::polar(setup.window.spatial(x_um), q_per_um * x_um);
      }
      error.see(std::abs(by_bins / count - by_copies / sum_g));
    }
  }
  return error.value();
}

/// Both sides are cut at 9 sigma, 3e-18; phases of up to 40 * 4.5 rad carry 180 * 2e-16.
constexpr double rounding = 5e-14;

}  // namespace

TEST_CASE("weighted bins of a single pixel are its window over all repetitions",
          "[periodic_bins][oracle]") {
  for (const Origin origin : {Origin::patch_centre, Origin::patch_corner})
    for (const Eigen::Index count : {7, 8})
      for (const double sigma_um : {0.15, 0.2, 0.5}) {
        CAPTURE(sigma_um, count);
        CHECK(single_pixel_error(Setup(count, 0.1, sigma_um, origin)) <= rounding);
      }
}

TEST_CASE("under a window narrower than a pixel the aliases of the window count",
          "[periodic_bins][crossover]") {
  for (const double sigma_um : {0.04, 0.1}) {
    CAPTURE(sigma_um);
    CHECK(single_pixel_error(Setup(7, 0.1, sigma_um)) <= rounding);
    CHECK(single_pixel_error(Setup(8, 0.1, sigma_um, Origin::patch_corner)) <= rounding);
  }
}

TEST_CASE("aliases change sign where the origin lies between two pixels",
          "[periodic_bins][regression]") {
  // An even patch with the origin in its middle: sum g((n + 1/2) dx) dx = sum (-1)^a G(a / dx).
  for (const double sigma_um : {0.04, 0.1}) {
    CAPTURE(sigma_um);
    CHECK(single_pixel_error(Setup(8, 0.1, sigma_um)) <= rounding);
  }
}

TEST_CASE("the bins within the radius are all counted and none beyond",
          "[periodic_bins][invariant]") {
  const Setup setup(650, 0.1, 16.25);
  constexpr std::uint64_t seed = 52;
  CAPTURE(seed);
  Uniform uniform(seed);
  for (const double radius : {1.0, 4.0, 6.5}) {
    const PeriodicBins bins = setup.bins(radius);
    const double radius_bins = radius / (2 * pi * 16.25) * 65;
    long most = 0;
    for (int i = 0; i < 1000; ++i) {
      const double position = uniform(-300, 300);
      const double q_per_um = position * 2 * pi / 65;
      const long first = bins.first(q_per_um), last = bins.last(q_per_um);
      REQUIRE(std::abs(static_cast<double>(first) - position) <= radius_bins);
      REQUIRE(std::abs(static_cast<double>(last) - position) <= radius_bins);
      REQUIRE(std::abs(static_cast<double>(first - 1) - position) > radius_bins);
      REQUIRE(std::abs(static_cast<double>(last + 1) - position) > radius_bins);
      most = std::max(most, last - first + 1);
    }
    CHECK(most == bins.max_count());
  }
  // The sources' window: 4 sigma_f are 2.55 bins, up to 6 of them.
  CHECK(setup.bins(4).max_count() == 6);
}

TEST_CASE("a weight is 1 on its bin and the Gaussian of the distance beside it",
          "[periodic_bins][oracle]") {
  const PeriodicBins bins = Setup(650, 0.1, 16.25).bins(4);
  const double q_per_um = 2 * pi * 37 / 65;
  CHECK(std::abs(bins.weight(q_per_um, 37) - 1) <= 1e-15);
  // One bin is 1/65 per um, pi/2 sigma_f: exp(-pi^2 / 8). Its exponent carries 37 roundings.
  for (const long bin : {36, 38})
    CHECK(std::abs(bins.weight(q_per_um, bin) - std::exp(-pi * pi / 8)) <= 1e-14);
}

TEST_CASE("the phase of the origin is exact for bins however far", "[periodic_bins][oracle]") {
  // Half pixels: x0 = 3.5 of 8 and 3 of 7. The phase repeats with 2 N bins.
  for (const Eigen::Index count : {7, 8}) {
    const PeriodicBins bins = Setup(count, 0.1, 0.2).bins(4);
    const double x0 = static_cast<double>(count - 1) / 2;
    WorstError near, far;
    for (long j = -20; j <= 20; ++j) {
      near.see(std::abs(
          bins.origin_phase(j) -
          std::polar(1.0, -2 * pi * static_cast<double>(j) * x0 / static_cast<double>(count))));
      const long period = 2 * static_cast<long>(count) * 1000003;
      far.see(std::abs(bins.origin_phase(j + period) - bins.origin_phase(j)));
    }
    CHECK(near.value() <= 2e-14);  // the plain form's phase of up to 60 rad
    CHECK(far.value() <= 4e-15);   // two evaluations within one turn
  }
}

TEST_CASE("the energies bound the weights of any frequency, closely",
          "[periodic_bins][invariant]") {
  constexpr std::uint64_t seed = 53;
  CAPTURE(seed);
  Uniform uniform(seed);
  for (const double sigma_um : {4.0, 16.25, 40.0})
    for (const double radius : {2.0, 4.0, 6.0}) {
      CAPTURE(sigma_um, radius);
      const PeriodicBins bins = Setup(650, 0.1, sigma_um).bins(radius);
      double most_all = 0, most_omitted = 0;
      for (int trial = 0; trial < 200; ++trial) {
        // The first trial lies on a bin, where the sum over all of them is largest.
        const double position = trial == 0 ? 0 : uniform(-0.5, 0.5);
        const double q_per_um = position * 2 * pi / 65;
        double all = 0, omitted = 0;
        for (long j = -60; j <= 60; ++j) {
          const double energy = std::pow(bins.weight(q_per_um, j), 2);
          all += energy;
          if (j < bins.first(q_per_um) || j > bins.last(q_per_um)) omitted += energy;
        }
        REQUIRE(all <= bins.weight_energy() * (1 + 1e-14));  // sums of 121 squares
        REQUIRE(omitted <= bins.omitted_energy());
        most_all = std::max(most_all, all);
        most_omitted = std::max(most_omitted, omitted);
      }
      CHECK(std::abs(most_all / bins.weight_energy() - 1) <= 1e-14);
      // Twice one side at its worst: no trial has both sides there, but half of it is met.
      CHECK(most_omitted >= 0.25 * bins.omitted_energy());
    }
}

TEST_CASE("the bound on omitted neighbours falls with the radius and joins both axes",
          "[periodic_bins][invariant]") {
  const Setup setup(650, 0.1, 16.25);
  double before = 10;
  for (const double radius : {1.0, 2.0, 3.0, 4.0, 6.0, 8.0}) {
    const PeriodicBins bins = setup.bins(radius);
    const double bound = omitted_neighbours_bound(bins, bins);
    // At least the weight of one bin left out at the very edge, at most a few of them.
    CHECK(bound >= std::exp(-radius * radius / 2));
    CHECK(bound <= 4 * std::exp(-radius * radius / 2));
    CHECK(bound <= before);
    before = bound;
    const double wide = omitted_neighbours_bound(bins, setup.bins(12));
    CHECK(wide <= bound);  // the other axis leaves nothing out
    CHECK(std::abs(wide - omitted_neighbours_bound(setup.bins(12), bins)) <= 1e-15);
  }
}
