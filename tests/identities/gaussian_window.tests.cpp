// The Gaussian window in space and in frequency.
#include "brdf/gaussian_window.h"

#include <catch2/catch.hpp>

#include "brdf/direct_sum.h"
#include "brdf/periodic_bins.h"
#include "brdf/taylor_series.h"
#include "tests/support/amplitudes.h"
#include "tests/support/exact_sums.h"
#include "tests/support/figure.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"

using brdf::GaussianWindow;
using brdf::HeightField;
using brdf::Length;
using brdf::PeriodicBins;
using brdf::pi;
using brdf::Surface;
using brdf::SurfaceModel;

namespace {

/// The sources' window: 4 sigma are the width of the patch, so that 4 sigma_f are 2.55 bins.
Surface under_sources_window(const HeightField& field) {
  return {&field, GaussianWindow(Length::um(field.width_um() / 4)), SurfaceModel::periodic};
}

/// Amplitude of a one-row surface at a position in bins, from the bins [nearest - reach,
/// nearest + reach] alone.
exact::Complex from_nearest_bins(const Surface& surface, double position, double c_per_um,
                                 long reach) {
  const PeriodicBins bins(surface.window, brdf::x_axis(surface), 9);
  const double per_bin = 2 * pi / surface.heights->width_um();
  exact::Complex sum = 0;
  for (long bin = std::lround(position) - reach; bin <= std::lround(position) + reach; ++bin)
    sum += static_cast<exact::Real>(bins.weight(position * per_bin, bin)) *
           exact::transform(*surface.heights, {per_bin * static_cast<double>(bin), 0, 0},
                            exact::evenly, exact::phase(c_per_um))
               .amplitude();
  return sum;
}

}  // namespace

TEST_CASE("Thesis 1.33, 1.34: the spectral form is the transform of the spatial form",
          "[identity][oracle]") {
  // The trapezoid rule errs by the transform one period away: at a step of sigma / 4 and up to
  // 0.06 per um less than 1e-70; cut at 9 sigma 3e-18. What is left is the rounding of 73 terms.
  const GaussianWindow window(Length::um(16.25));
  const double step_um = window.sigma_um() / 4;
  WorstError error;
  for (double f_per_um = -0.06; f_per_um <= 0.06; f_per_um += 0.0025) {
    double transform = 0, area = 0;
    for (int i = -36; i <= 36; ++i) {
      const double x_um = i * step_um;
      transform += window.spatial(x_um) * std::cos(2 * pi * f_per_um * x_um);
      area += window.spatial(x_um);
    }
    error.see(std::abs(transform / area - window.spectral(f_per_um)));
  }
  CHECK(figure("Thesis 1.33, 1.34", "transform of g against the spectral form", error.value()) <=
        1e-15);
}

TEST_CASE("Thesis 1.33, 1.34: a product in space is a convolution in frequency",
          "[identity][oracle]") {
  // The lines of a periodic patch, each spread by the window's transform, against the patch and its
  // repetitions under the window. 2-D, even and odd counts, x and y of different length.
  constexpr std::uint64_t seed = 331;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, {5, 8, 0.2, 0.25}, 0, 0.3);
  const double sigma_um = 0.5;
  const Surface surface{&field, GaussianWindow(Length::um(sigma_um)), SurfaceModel::periodic};
  const PeriodicBins x(surface.window, brdf::x_axis(surface), 9),
      y(surface.window, brdf::y_axis(surface), 9);
  WorstError error;
  for (int i = 0; i < 20; ++i) {
    const brdf::Query q{uniform(-12, 12), uniform(-12, 12), -20};
    exact::Complex convolved = 0;
    for (long j = y.first(q.qy_per_um); j <= y.last(q.qy_per_um); ++j)
      for (long l = x.first(q.qx_per_um); l <= x.last(q.qx_per_um); ++l)
        convolved += static_cast<exact::Real>(y.weight(q.qy_per_um, j) * x.weight(q.qx_per_um, l)) *
                     exact::transform(field,
                                      {2 * pi * static_cast<double>(l) / field.width_um(),
                                       2 * pi * static_cast<double>(j) / field.height_um(), 0},
                                      exact::evenly, exact::phase(q.c_per_um))
                         .amplitude();
    // 9 sigma are 2.8 and 3.6 patches: 4 repetitions on each side.
    const auto multiplied = exact::transform(field, q, exact::gaussian(sigma_um),
                                             exact::phase(q.c_per_um), {.x = 4, .y = 4})
                                .amplitude();
    error.see(static_cast<double>(std::abs(convolved - multiplied)));
  }
  // Weights in double: exponents of up to 40 right to 2^-53 of themselves.
  CHECK(figure("Thesis 1.33, 1.34", "convolution against product", error.value()) <= 1e-14);
}

TEST_CASE("Erratum E6: Thesis 1.35 multiplies every amplitude by pi", "[identity][erratum][E6]") {
  const HeightField flat(brdf::HeightArray::Constant(8, 8, 0.3), Length::um(0.1), Length::um(0.1));
  const Surface surface{&flat, GaussianWindow(Length::um(0.4)), SurfaceModel::periodic};
  const double right = std::abs(amplitude(brdf::TaylorSeries{}, surface, {0, 0, -20}));
  CHECK(std::abs(right - 1) <= 1e-14);  // a few neighbours' rounding
  const auto printed_thesis_1_35 = [&](double f_per_um) {
    return pi * surface.window.spectral(f_per_um);
  };
  CHECK(surface.window.spectral(0) == 1);
  CHECK(figure("E6", "flat patch by the printed weight; right: 1",
               printed_thesis_1_35(0) * right) == Approx(pi).epsilon(1e-13));
}

TEST_CASE("Erratum E6: Thesis 1.33 multiplies the transforms where it must convolve them",
          "[identity][erratum][E6]") {
  // A blaze at phase depth 2 pi has all its light in order +1; the product of its transform with
  // the window's, at 0.4 cycles/um and sigma_f 0.0098, leaves nothing of it.
  const HeightField field = one_period({.period = Length::um(2.5), .height = Length::um(0.2)}, 50);
  const Surface surface{&field, GaussianWindow(Length::um(16.25)), SurfaceModel::periodic};
  const brdf::Query q = order_query(1, 2.5, 2 * pi / 0.2);
  CHECK(std::abs(std::norm(amplitude(brdf::TaylorSeries{}, surface, q)) - 1) <= 1e-13);
  const auto line = exact::transform(field, q, exact::evenly, exact::phase(q.c_per_um)).amplitude();
  const double printed_thesis_1_33 =
      static_cast<double>(std::norm(line)) * std::pow(surface.window.spectral(1 / 2.5), 2);
  CHECK(figure("E6", "power of order 1 by the printed product; right: 1", printed_thesis_1_33) <=
        1e-300);
}

TEST_CASE("Erratum E17: a window on the patch's corner sees another surface",
          "[identity][erratum][E17]") {
  constexpr std::uint64_t seed = 332;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, {24, 24, 0.1, 0.1}, 0, 0.3);
  const GaussianWindow window(Length::um(0.6));
  const Surface centre{&field, window, SurfaceModel::periodic};
  const Surface corner{&field, window, SurfaceModel::periodic, brdf::Origin::patch_corner};
  WorstError right;
  double change = 0, size = 0;
  for (int i = 0; i < 20; ++i) {
    const brdf::Query q{uniform(-15, 15), uniform(-15, 15), -25};
    const auto at_centre = amplitude(brdf::TaylorSeries{}, centre, q);
    const auto at_corner = amplitude(brdf::TaylorSeries{}, corner, q);
    // 9 sigma are 2.25 patches: 3 repetitions on each side.
    right.see(exact::difference(at_centre, exact::transform(field, q, exact::gaussian(0.6L),
                                                            exact::phase(-25), {.x = 3, .y = 3})
                                               .amplitude()));
    change = std::max(change, std::abs(std::abs(at_centre) - std::abs(at_corner)));
    size = std::max(size, std::abs(at_centre));
  }
  CHECK(figure("E17", "amplitude, window in the centre", right.value()) <= 1e-13);  // e^4 terms
  CHECK(figure("E17", "change of the amplitude by the corner, of the largest", change / size) >=
        0.2);
}

TEST_CASE("Erratum E23: one neighbour on each side is not 4 sigma_f", "[identity][erratum][E23]") {
  // 4 sigma_f are 2.55 bins; halfway between the next two bins the printed 3 x 3 leaves out one at
  // 1.5 bins, exp(-(3 pi / 4)^2 / 2) = 0.0623.
  const auto dropped = [](const HeightField& field, int bin, double c_per_um) {
    const Surface surface = under_sources_window(field);
    WorstError printed_3x3;
    for (int i = -30; i <= 30; ++i)
      printed_3x3.see(
          static_cast<double>(std::abs(from_nearest_bins(surface, bin + 0.05 * i, c_per_um, 1) -
                                       from_nearest_bins(surface, bin + 0.05 * i, c_per_um, 10))));
    return printed_3x3.value();
  };
  const HeightField flat(brdf::HeightArray::Zero(1, 100), Length::um(0.65), Length::um(1));
  const Surface surface = under_sources_window(flat);
  CHECK(PeriodicBins(surface.window, brdf::x_axis(surface), 4).max_count() == 6);
  CHECK(figure("E23", "left out by 3 x 3, flat patch", dropped(flat, 0, 0)) ==
        Approx(std::exp(-std::pow(3 * pi / 4, 2) / 2)).epsilon(1e-4));  // two bins more: 1e-6 of it
  // A blaze at phase depth 2 pi, around its order +1: 27.9 periods, so that the light is shared
  // among the bins near -28.
  const HeightField blaze =
      brdf::synthetic_grating({.period = Length::um(2.33), .height = Length::um(0.2)}, 1, 650,
                              Length::um(0.1), Length::um(1));
  const double of_blaze = figure("E23", "left out by 3 x 3, blaze of 2.33 um, around order 1",
                                 dropped(blaze, -28, -2 * pi / 0.2));
  CHECK(of_blaze >= 0.04);
  CHECK(of_blaze <= 0.07);
}
