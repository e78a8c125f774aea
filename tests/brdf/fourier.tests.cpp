#include "brdf/fourier.h"

#include <catch2/catch.hpp>
#include <numbers>
#include <vector>

#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::RealFourier2d;
using Complex = std::complex<double>;

namespace {

/// The definition, with the phase reduced in whole steps so that only the sum rounds.
Complex definition(const std::vector<double>& samples, int rows, int cols, long j, long l) {
  Complex sum = 0;
  for (long r = 0; r < rows; ++r)
    for (long c = 0; c < cols; ++c) {
      const double turns =
          static_cast<double>((j * r) % rows) / rows + static_cast<double>((l * c) % cols) / cols;
      sum +=
          std::polar(samples[static_cast<std::size_t>(r * cols + c)], 2 * std::numbers::pi * turns);
    }
  return sum;
}

}  // namespace

TEST_CASE("every bin equals the sum with the plus sign, for odd and even sides",
          "[fourier][oracle]") {
  constexpr std::uint64_t seed = 31;
  CAPTURE(seed);
  Uniform uniform(seed);
  for (const auto& [rows, cols] :
       {std::pair{1, 1}, {1, 8}, {7, 1}, {6, 5}, {5, 6}, {4, 8}, {3, 7}}) {
    CAPTURE(rows, cols);
    RealFourier2d fourier(rows, cols);
    REQUIRE(fourier.samples().size() == static_cast<std::size_t>(rows) * cols);
    std::vector<double> samples(fourier.samples().size());
    for (double& sample : samples) sample = uniform(-1, 1);
    std::copy(samples.begin(), samples.end(), fourier.samples().begin());
    fourier.transform();
    WorstError error;
    // From one period below to one above: bins repeat with the grid.
    for (long j = -rows - 1; j <= 2 * rows; ++j)
      for (long l = -cols - 1; l <= 2 * cols; ++l)
        error.see(std::abs(fourier.bin(j, l) - definition(samples, rows, cols, j, l)));
    CHECK(error.value() <= 2e-14);  // at most 42 terms of size 1, each some eps in phase
    // The samples are kept.
    CHECK(std::equal(samples.begin(), samples.end(), fourier.samples().begin()));
  }
}

TEST_CASE("a second transform sees new samples and forgets the old", "[fourier][invariant]") {
  RealFourier2d fourier(4, 4);
  for (double& sample : fourier.samples()) sample = 1;
  fourier.transform();
  CHECK(fourier.bin(0, 0) == Complex(16));
  for (double& sample : fourier.samples()) sample = -0.5;
  fourier.transform();
  CHECK(fourier.bin(0, 0) == Complex(-8));
  CHECK(std::abs(fourier.bin(1, 3)) <= 1e-15);  // sums of equal numbers cancel
}

TEST_CASE("a single sample gives a phase that turns with the plus sign", "[fourier][oracle]") {
  RealFourier2d fourier(8, 8);
  for (double& sample : fourier.samples()) sample = 0;
  fourier.samples()[1] = 1;  // row 0, column 1
  fourier.transform();
  CHECK(std::abs(fourier.bin(0, 2) - Complex(0, 1)) <= 1e-15);  // exp(+2 pi i 2/8)
  CHECK(std::abs(fourier.bin(0, -2) - Complex(0, -1)) <= 1e-15);
  CHECK(std::abs(fourier.bin(2, 0) - Complex(1, 0)) <= 1e-15);
}

TEST_CASE("transforms of the same samples are bit-identical", "[fourier][invariant]") {
  constexpr std::uint64_t seed = 32;
  CAPTURE(seed);
  const auto run = [&] {
    Uniform uniform(seed);
    RealFourier2d fourier(12, 10);
    for (double& sample : fourier.samples()) sample = uniform(-1, 1);
    fourier.transform();
    std::vector<Complex> bins;
    for (long j = 0; j < 12; ++j)
      for (long l = 0; l < 10; ++l) bins.push_back(fourier.bin(j, l));
    return bins;
  };
  CHECK(run() == run());
}

TEST_CASE("the bytes of a transform are its samples and its half of the bins",
          "[fourier][oracle]") {
  CHECK(RealFourier2d::bytes(6, 5) == 6 * 5 * 8 + 6 * 3 * 16);
  CHECK(RealFourier2d::bytes(650, 650) == 650 * 650 * 8 + 650 * 326 * 16);
}
