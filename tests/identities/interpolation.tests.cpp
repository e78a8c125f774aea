// Reading a tile's transform: where it lies in the array, between its bins, and rescaled.
#include "brdf/bin_interpolation.h"

#include <catch2/catch.hpp>

#include "brdf/fourier.h"
#include "brdf/spectrum_extrema.h"
#include "tests/support/amplitudes.h"
#include "tests/support/exact_sums.h"
#include "tests/support/figure.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"

using brdf::BinInterpolation;
using brdf::HeightField;
using brdf::InterpolatedBins;
using brdf::Length;
using brdf::pi;
using exact::Complex;
using exact::Real;

namespace {

brdf::SurfaceAxis axis_of(const HeightField& tile) {
  return brdf::x_axis({&tile, brdf::GaussianWindow(Length::um(1)), brdf::SurfaceModel::replicated});
}

/// Transform of a one-row tile at a place among its bins, origin in its middle.
Complex exact_at(const HeightField& tile, double bins, double c_per_um) {
  return exact::transform(tile, {2 * pi * bins / tile.width_um(), 0, 0}, exact::evenly,
                          exact::phase(c_per_um))
      .amplitude();
}

/// The same from the bins that an interpolation takes.
Complex interpolated(BinInterpolation kind, const HeightField& tile, double bins, double c_per_um) {
  const InterpolatedBins stencil(kind, axis_of(tile));
  const double q = 2 * pi * bins / tile.width_um();
  std::vector<double> weights(static_cast<std::size_t>(stencil.stencil()));
  stencil.weights(q, weights);
  Complex sum = 0;
  long bin = stencil.first(q);
  for (const double weight : weights)
    sum += static_cast<Real>(weight) * exact_at(tile, static_cast<double>(bin++), c_per_um);
  return sum;
}

/// A plane so steep that its peak lies at `bins`, with c = -20.
HeightField tilted_plane(Eigen::Index count, double bins) {
  return sampled(1, count, 0.1, 1, [&](double x, double) {
    return 2 * pi * bins / (static_cast<double>(count) * 0.1) * x / 20;
  });
}

}  // namespace

TEST_CASE("Implementation chapter: the bin of a direction is u N dH / lambda",
          "[identity][oracle]") {
  constexpr std::uint64_t seed = 361;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField tile(brdf::HeightArray::Zero(1, 650), Length::um(0.1), Length::um(1));
  WorstError error;
  for (int i = 0; i < 1000; ++i) {
    const double u = uniform(-2, 2), lambda_um = uniform(0.38, 0.78);
    const Real bin = static_cast<Real>(u) * 650 * tile.dx_um() / lambda_um;
    const double ours = axis_of(tile).cycles(brdf::wavenumber_per_um(Length::um(lambda_um)) * u);
    error.see(static_cast<double>(std::abs(ours - bin)));
  }
  // Up to 342 bins, in six products.
  CHECK(figure("look-up", "u N dH / lambda [bins]", error.value()) <= 3e-13);
}

TEST_CASE("Implementation chapter: the shifted array has the bin j at j + b, b = N/2 rounded down",
          "[identity][oracle]") {
  constexpr std::uint64_t seed = 362;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError error;
  for (const int n : {7, 8}) {
    brdf::RealFourier2d fourier(1, n);
    for (double& sample : fourier.samples()) sample = uniform(-1, 1);
    fourier.transform();
    const int b = n / 2;
    for (int place = 0; place < n; ++place) {
      Complex sum = 0;
      for (int x = 0; x < n; ++x)
        sum += static_cast<Real>(fourier.samples()[static_cast<std::size_t>(x)]) *
               exact::turned(2 * exact::pi * x * (place - b) / n);
      error.see(exact::difference(fourier.bin(0, place - b), sum));
    }
  }
  CHECK(figure("look-up", "transform at j + b, 7 and 8 samples", error.value()) <= 4e-15);
}

TEST_CASE("Thesis 1.54: the sum of periodic sincs over all bins is exact", "[identity][oracle]") {
  constexpr std::uint64_t seed = 363;
  CAPTURE(seed);
  Uniform uniform(seed);
  for (const Eigen::Index count : {15, 16}) {
    const HeightField tile = random_heights(uniform, {1, count, 0.1, 1}, 0, 0.4);
    WorstError error;
    for (double bins = -9; bins <= 9; bins += 0.063)
      error.see(static_cast<double>(std::abs(
          interpolated(BinInterpolation::exact, tile, bins, -20) - exact_at(tile, bins, -20))));
    CHECK(figure("Thesis 1.54", "periodic sinc over all bins", error.value()) <= 2e-15);
  }
}

TEST_CASE("Thesis 1.54: nearest, linear and three-tap sinc are wrong between the bins",
          "[identity][oracle]") {
  // A tilted plane has sinc(d) in the bin at distance d from its peak. Halfway: 2/pi in both
  // neighbours, -2/(3 pi) in the next.
  constexpr double near = 2 / pi, next = -2 / (3 * pi);
  const HeightField plane = tilted_plane(256, 6.5);
  const auto error = [&](BinInterpolation kind) {
    CHECK(std::abs(std::abs(exact_at(plane, 6.5, -20)) - 1) <= 1e-12);
    return static_cast<double>(
        std::abs(interpolated(kind, plane, 6.5, -20) - exact_at(plane, 6.5, -20)));
  };
  // 256 samples instead of a continuum: 3e-5 of each bin.
  CHECK(figure("Thesis 1.54", "nearest bin, peak halfway, off by",
               error(BinInterpolation::nearest)) == Approx(1 - near).margin(1e-4));
  CHECK(figure("Thesis 1.54", "linear, peak halfway, off by", error(BinInterpolation::linear)) ==
        Approx(1 - near).margin(1e-4));
  CHECK(figure("Thesis 1.54", "three-tap sinc, peak halfway, off by",
               error(BinInterpolation::sinc)) ==
        Approx(1 - 2 * near * near - next * next).margin(1e-4));
}

TEST_CASE("Erratum E15: a radial sinc is not 0 at the diagonal bins", "[identity][erratum][E15]") {
  const auto printed_radial = [](double dx, double dy) {
    constexpr double epsilon = 1e-9;
    const double x = std::hypot(dx, dy) * pi + epsilon;
    return std::sin(x) / x;
  };
  const HeightField tile(brdf::HeightArray::Zero(1, 64), Length::um(0.1), Length::um(1));
  const InterpolatedBins bins(BinInterpolation::sinc, axis_of(tile));
  std::vector<double> weights(3);
  bins.weights(0, weights);
  // Ours, on a bin: 1 there, sin(pi) / pi beside it.
  CHECK(weights[1] == 1);
  CHECK(std::abs(weights[0]) <= 1e-16);
  CHECK(std::abs(weights[2]) <= 1e-16);
  CHECK(figure("E15", "printed weight of a diagonal bin, on a bin; right: 0",
               printed_radial(1, 1)) == Approx(-0.217).epsilon(2e-3));
}

TEST_CASE("Erratum E18: with the origin at the corner neighbouring bins cancel",
          "[identity][erratum][E18]") {
  // Between two bins of a tilted plane, peak 1. The corner's bins turn by pi from one to the next.
  const HeightField plane = tilted_plane(256, 6.5);
  const auto bin = [&](double distance, double origin) {
    return exact_at(plane, 6.5 + distance, -20) *
           exact::turned(2 * exact::pi * (distance + 6.5) * origin / 256);
  };
  const auto linear = [&](double origin) {
    return static_cast<double>(std::abs(bin(-0.5, origin) + bin(0.5, origin)) / 2);
  };
  const auto four_tap_sinc = [&](double origin) {
    Complex sum = 0;
    for (const double d : {-1.5, -0.5, 0.5, 1.5})
      sum += exact::sinc(exact::pi * d) * bin(d, origin);
    return static_cast<double>(std::abs(sum));
  };
  const double corner = 127.5;
  CHECK(figure("E18", "linear, origin at the corner; right: 1", linear(corner)) ==
        Approx(0.004).epsilon(0.05));
  CHECK(figure("E18", "four-tap sinc, origin at the corner; right: 1", four_tap_sinc(corner)) ==
        Approx(0.003).epsilon(0.2));
  CHECK(figure("E18", "linear, centred; right: 1", linear(0)) == Approx(0.64).epsilon(0.01));
  CHECK(figure("E18", "four-tap sinc, centred; right: 1", four_tap_sinc(0)) ==
        Approx(0.90).epsilon(0.01));
  // What the code reads is the centred one.
  CHECK(std::abs(interpolated(BinInterpolation::linear, plane, 6.5, -20)) ==
        Approx(linear(0)).epsilon(1e-12));
}

TEST_CASE("Erratum E24: a value stored between its extrema comes back by max - min",
          "[identity][erratum][E24]") {
  const HeightField tile =
      brdf::synthetic_grating({.period = Length::um(2.33), .height = Length::um(0.15)}, 1, 65,
                              Length::um(1), Length::um(1));
  std::vector<std::complex<double>> spectrum;
  for (int bin = 0; bin < 65; ++bin)
    spectrum.emplace_back(
        exact::transform(tile, {2 * pi * bin / 65, 0, 0}, exact::evenly, [](Real h) {
          return Complex(h - 0.075L);
        }).amplitude());
  const brdf::SpectrumExtrema extrema = brdf::spectrum_extrema(spectrum);
  const auto printed = [](double value, const brdf::Extrema& e) { return value * e.max + e.min; };
  WorstError right, off;
  for (const std::complex<double>& value : spectrum) {
    const std::complex<double> stored = normalised(value, extrema);
    right.see(std::abs(rescaled(stored, extrema) - value) / extrema.im.range());
    off.see(std::abs(printed(stored.imag(), extrema.im) - value.imag()) / extrema.im.range());
  }
  CHECK(figure("E24", "stored and rescaled, of the range", right.value()) <= 4e-16);
  // The imaginary parts are odd, min = -max: the largest comes back as 0.
  CHECK(figure("E24", "rescaled as printed, of the range, off by", off.value()) ==
        Approx(0.5).epsilon(1e-9));
}
