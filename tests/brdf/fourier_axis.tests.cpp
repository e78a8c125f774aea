#include "brdf/fourier_axis.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

using namespace brdf;

TEST_CASE("a frequency between the grid points is interpolated within the bound",
          "[fourier_axis][oracle]") {
  const double oversampling = GENERATE(1.5, 2.0, 2.5, 4.0);
  const double tolerance = GENERATE(1e-1, 1e-3, 1e-6, 1e-9, 1e-12, 1e-13);
  const std::size_t count = GENERATE(1u, 2u, 33u, 128u);
  constexpr double pitch_um = 0.3, reach_per_um = 9;
  const FourierAxis axis(EvenSamples{count, pitch_um},
                         {-reach_per_um, reach_per_um, tolerance, oversampling});
  CAPTURE(oversampling, tolerance, count, axis.kernel().width(), axis.kernel().degree());
  // The widest kernel, of 17 taps, leaves 1e-12 at the coarsest of these grids.
  CHECK(axis.error_bound() <= std::max(tolerance, 1e-12));

  constexpr unsigned seed = 5;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<std::complex<double>> samples(count);
  double sum = 0;
  for (auto& sample : samples) {
    sample = {uniform(random), uniform(random)};
    sum += std::abs(sample);
  }
  std::vector<std::complex<double>> grid(axis.stored());
  ComplexFourier1d fourier(axis.length());
  axis.transform(
      fourier, [&](std::size_t n) { return samples[n]; },
      [&](std::size_t slot, std::complex<double> value) { grid[slot] = value; });

  const long period = static_cast<long>(axis.length());
  for (int i = 0; i < 50; ++i) {
    const double q_per_um = reach_per_um * uniform(random);
    const double start = q_per_um * axis.grid_per_frequency_um() - axis.kernel().width() / 2.0;
    const long k0 = static_cast<long>(std::ceil(start));
    const std::vector<double> taps = axis.kernel().taps(static_cast<double>(k0) - start);
    std::complex<double> interpolated = 0, exact = 0;
    for (std::size_t tap = 0; tap < taps.size(); ++tap) {
      long slot = k0 + static_cast<long>(tap) - axis.first();
      double sign = 1;
      for (; slot >= static_cast<long>(axis.stored()); slot -= period) sign *= axis.turn_sign();
      interpolated += sign * taps[tap] * grid[static_cast<std::size_t>(slot)];
    }
    for (std::size_t n = 0; n < count; ++n) {
      const double x_um = pitch_um * (static_cast<double>(n) - static_cast<double>(count - 1) / 2);
      exact += samples[n] * std::polar(1.0, q_per_um * x_um);
    }
    // Rounding: a few times that of the grid's entries, which the kernel amplifies.
    CHECK(std::abs(interpolated - exact) <=
          (axis.error_bound() + 2e-15 * axis.amplification()) * sum);
  }
}

TEST_CASE("the kernel is as short as the tolerance allows", "[fourier_axis][invariant]") {
  int previous = 0;
  for (const double tolerance : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
    const FourierAxis axis(EvenSamples{128, 0.3}, {-9, 9, tolerance, 2});
    const InterpolationKernel narrower =
        InterpolationKernel::semicircle(axis.kernel().width() - 1, axis.oversampling());
    CAPTURE(tolerance, axis.kernel().width());
    CHECK(axis.kernel().degree() > previous);
    previous = axis.kernel().degree();
    if (axis.kernel().width() > 2)
      CHECK(narrower.relative_errors({pi / axis.oversampling()})[0] > tolerance);
  }
}
