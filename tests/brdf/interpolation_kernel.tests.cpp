#include "brdf/interpolation_kernel.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

using namespace brdf;

TEST_CASE("taps are the exponential of semicircle", "[interpolation_kernel][oracle]") {
  const int width = GENERATE(2, 5, 8, 13);
  const InterpolationKernel kernel = InterpolationKernel::semicircle(width, 2);
  const double beta = 0.976 * pi * width * 0.75;
  // The polynomials stand in for the kernel: they may differ by no more than it is wrong anyway.
  const double tolerance = 3 * std::exp(-beta) + 1e-14;
  for (double x = 0; x < 1; x += 0.0625) {
    const std::vector<double> taps = kernel.taps(x);
    for (int i = 0; i < width; ++i) {
      const double z = 2 * (i - width / 2.0 + x) / width;
      CHECK(std::abs(taps[static_cast<std::size_t>(i)] -
                     std::exp(beta * (std::sqrt(std::max(0.0, 1 - z * z)) - 1))) <= tolerance);
    }
  }
}

TEST_CASE("a wave is interpolated within the stated error", "[interpolation_kernel][oracle]") {
  const double oversampling = GENERATE(1.5, 2.0, 4.0);
  const int width = GENERATE(3, 6, 9, 12);
  const InterpolationKernel kernel = InterpolationKernel::semicircle(width, oversampling);
  // Other frequencies and positions than those that the error was measured at.
  std::vector<double> omegas;
  for (int m = 0; m <= 37; ++m) omegas.push_back(pi / oversampling * m / 37);
  const std::vector<double> errors = kernel.relative_errors(omegas),
                            hats = kernel.transform(omegas);
  for (std::size_t m = 0; m < omegas.size(); ++m)
    for (double x = 0; x < 1; x += 0.009) {
      const std::vector<double> taps = kernel.taps(x);
      std::complex<double> sum = 0;
      for (int i = 0; i < width; ++i)
        sum +=
            std::polar(1.0, omegas[m] * (i - width / 2.0 + x)) * taps[static_cast<std::size_t>(i)];
      // Rounding of a dozen taps, relative to their sum.
      CHECK(std::abs(sum / hats[m] - 1.0) <= errors[m] + 4e-15 * hats[0] / hats[m]);
    }
}

TEST_CASE("gaussian taps, from far narrower than the grid to wide",
          "[interpolation_kernel][oracle]") {
  const double sigma = GENERATE(0.01, 0.1, 0.6366, 1.6);
  const InterpolationKernel kernel = InterpolationKernel::gaussian(9, sigma, 1);
  for (double x = 0; x < 1; x += 1.0 / 1024) {
    const std::vector<double> taps = kernel.taps(x);
    for (int i = 0; i < 9; ++i) {
      const double d = (i - 4.5 + x) / sigma;
      // Polynomials of degree 14 over one sigma: 1e-15; 1e-14 allows for their rounding.
      CHECK(std::abs(taps[static_cast<std::size_t>(i)] - std::exp(-0.5 * d * d)) <= 1e-14);
    }
  }
}

TEST_CASE("a shortened kernel differs by no more than it says", "[interpolation_kernel][oracle]") {
  const int split = GENERATE(1, 2, 4);
  const double tolerance = GENERATE(0.0, 1e-13, 1e-9, 1e-6, 1e-3);
  const InterpolationKernel kernel = GENERATE(
      InterpolationKernel::semicircle(7, 4), InterpolationKernel::semicircle(12, 2),
      InterpolationKernel::gaussian(7, 0.6366, 1), InterpolationKernel::gaussian(9, 0.1, 1));
  const InterpolationKernel shortened = kernel.shortened(split, tolerance);
  CAPTURE(split, tolerance, kernel.degree(), shortened.degree());
  CHECK(shortened.width() == kernel.width());
  CHECK(shortened.pieces() == split * kernel.pieces());
  CHECK(shortened.shortening_error() <= tolerance);
  if (split > 1 && tolerance >= 1e-9) CHECK(shortened.degree() < kernel.degree());
  for (double x = 0; x < 1; x += 1.0 / 512) {
    const std::vector<double> before = kernel.taps(x), after = shortened.taps(x);
    double sum = 0;
    for (std::size_t tap = 0; tap < before.size(); ++tap) sum += std::abs(after[tap] - before[tap]);
    CHECK(sum <= shortened.shortening_error() + 1e-14);  // rounding of a dozen taps
  }
}
