#include "brdf/bin_interpolation.h"

#include <catch2/catch.hpp>

#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::BinInterpolation;
using brdf::InterpolatedBins;
using brdf::pi;
using brdf::SurfaceAxis;
using Complex = std::complex<double>;

namespace {

constexpr BinInterpolation few[] = {BinInterpolation::nearest, BinInterpolation::linear,
                                    BinInterpolation::sinc};

/// A tile of length 2 pi um: frequencies in rad/um are cycles.
SurfaceAxis axis_of(Eigen::Index count) {
  return {count, 2 * pi / static_cast<double>(count), static_cast<double>(count - 1) / 2, 0, 0};
}

struct Weights {
  long first;
  std::vector<double> of_bins;
};

Weights weights_of(const InterpolatedBins& bins, double q) {
  Weights weights{bins.first(q), {}};
  weights.of_bins.resize(static_cast<std::size_t>(bins.last(q) - weights.first + 1));
  bins.weights(q, weights.of_bins);
  return weights;
}

/// (1 / N) sum_n exp(2 pi i d (n - x0) / N), pixel by pixel in extended precision.
double kernel(long double distance, Eigen::Index count) {
  constexpr long double two_pi = 6.283185307179586476925286766559L;
  long double sum = 0;
  for (Eigen::Index n = 0; n < count; ++n)
    sum += std::cos(two_pi * distance *
                    (static_cast<long double>(n) - static_cast<long double>(count - 1) / 2) /
                    static_cast<long double>(count));
  return static_cast<double>(sum / static_cast<long double>(count));
}

/// The weights less the kernel's over N bins in a row; bins N apart are the same bin, with the sign
/// that the origin between two pixels gives it.
double distance_to_kernel(const InterpolatedBins& bins, double q, Eigen::Index count) {
  const auto [first, w] = weights_of(bins, q);
  const double position = axis_of(count).cycles(q);
  double sum = 0;
  for (long bin = first; bin < first + count; ++bin) {
    double difference = -kernel(position - static_cast<double>(bin), count);
    for (long k = bin - first, sign = 1; k < static_cast<long>(w.size());
         k += count, sign = count % 2 == 0 ? -sign : sign)
      difference += static_cast<double>(sign) * w[static_cast<std::size_t>(k)];
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

}  // namespace

TEST_CASE("exact weights are the kernel of the pixels, one for each bin",
          "[bin_interpolation][oracle]") {
  constexpr std::uint64_t seed = 231;
  CAPTURE(seed);
  Uniform uniform(seed);
  for (const Eigen::Index count : {1, 2, 3, 7, 8, 64, 651}) {
    const InterpolatedBins bins(BinInterpolation::exact, axis_of(count));
    WorstError error, energy;
    for (int i = 0; i < (count > 100 ? 12 : 40); ++i) {
      double q = uniform(-3, 3) * static_cast<double>(count);
      if (i < 10) q = std::round(q) + (i % 2 == 0 ? 0 : std::pow(10.0, -i));
      const auto [first, w] = weights_of(bins, q);
      REQUIRE(static_cast<Eigen::Index>(w.size()) == count);
      const double position = axis_of(count).cycles(q);
      double squares = 0;
      for (std::size_t k = 0; k < w.size(); ++k) {
        const long bin = first + static_cast<long>(k);
        error.see(std::abs(w[k] - kernel(static_cast<long double>(position) - bin, count)));
        squares += w[k] * w[k];
      }
      energy.see(std::abs(squares - 1));
    }
    CAPTURE(count);
    CHECK(error.value() <= 5e-16);   // a few roundings of at most 1
    CHECK(energy.value() <= 2e-15);  // Parseval; 651 squares of sum 1
  }
}

TEST_CASE("few weights are those of the nearest bin, the hat and the separable sinc",
          "[bin_interpolation][oracle]") {
  const SurfaceAxis axis = axis_of(16);
  for (const double position : {-5.7, -0.5, -0.2, 0.0, 0.3, 2.0, 3.49, 7.9, 40.6}) {
    CAPTURE(position);
    // One rounding of the position of up to 40, in cycles.
    constexpr double accuracy = 2e-14;
    const auto nearest = weights_of({BinInterpolation::nearest, axis}, position);
    CHECK(std::abs(static_cast<double>(nearest.first) - position) <= 0.5);
    CHECK(nearest.of_bins == std::vector<double>{1});
    const auto linear = weights_of({BinInterpolation::linear, axis}, position);
    REQUIRE(linear.of_bins.size() == 2);
    CHECK(linear.of_bins[0] + linear.of_bins[1] == 1);
    // The weights' centre is the position.
    CHECK(std::abs(static_cast<double>(linear.first) + linear.of_bins[1] - position) <= accuracy);
    const auto sinc = weights_of({BinInterpolation::sinc, axis}, position);
    REQUIRE(sinc.of_bins.size() == 3);
    CHECK(sinc.first == nearest.first - 1);
    for (int k = 0; k < 3; ++k) {
      const double d = position - static_cast<double>(sinc.first + k);
      // The mean of cos(pi d x) over |x| <= 1, by its power series.
      double series = 0, term = 1;
      for (int n = 0; n < 30; ++n) {
        series += term;
        term *= -std::pow(pi * d, 2) / ((2.0 * n + 2) * (2.0 * n + 3));
      }
      CHECK(std::abs(sinc.of_bins[static_cast<std::size_t>(k)] - series) <= accuracy);
    }
  }
}

TEST_CASE("the largest deviation bounds that of every frequency, closely",
          "[bin_interpolation][invariant]") {
  constexpr std::uint64_t seed = 232;
  CAPTURE(seed);
  Uniform uniform(seed);
  for (const BinInterpolation interpolation : few)
    for (const Eigen::Index count : {1, 2, 3, 4, 15, 32})
      for (const int replicas : {1, 2, 9, 100}) {
        const InterpolatedBins bins(interpolation, axis_of(count));
        const auto largest = bins.largest_deviation(-3, 5, replicas);
        double most = 0;
        for (int i = 0; i < 100; ++i) {
          const double q = i == 0       ? 0.5 - 1e-12
                           : i % 2 == 0 ? uniform(-3, 5)
                                        : uniform(0, 0.5 / replicas);
          const double factor = std::abs(brdf::pq_factor(axis_of(count).cycles(q), replicas));
          const double error = factor * distance_to_kernel(bins, q, count);
          double norm = 0;
          for (const double w : weights_of(bins, q).of_bins) norm += w * w;
          CAPTURE(count, replicas, q);
          // Both squared errors carry roundings of 1, which make 3e-8 of a root near 0.
          REQUIRE(error <= largest.error + 5e-8);
          if (count > 2) REQUIRE(factor * std::sqrt(norm) <= largest.norm + 1e-15);
          const auto at = bins.largest_deviation(q, q, replicas);
          REQUIRE(std::abs(at.error - error) <= 5e-8);
          most = std::max(most, error);
        }
        CAPTURE(static_cast<int>(interpolation), count, replicas, largest.error);
        // The envelope of the copies' factor is met where its sine is 1, the error grows beyond.
        CHECK(most >= (replicas == 1 ? 0.9 : 0.5) * largest.error - 5e-8);
      }
}

TEST_CASE("the deviations of a long tile are those of the closed forms",
          "[bin_interpolation][oracle]") {
  // Half way between two bins D is 2 / pi: squared, 2 - 4 / pi nearest, 3/2 - 4 / pi linear,
  // 1 - (8 + 8 / 9 / 2) / pi^2 sinc of three bins.
  const auto squared = [](BinInterpolation interpolation) {
    const double error =
        InterpolatedBins(interpolation, axis_of(1000)).largest_deviation(0, 9, 1).error;
    return error * error;
  };
  constexpr double longer = 1e-5;  // D differs from the sinc by (pi / 2000)^2 / 6 and alike
  CHECK(std::abs(squared(BinInterpolation::nearest) - (2 - 4 / pi)) <= longer);
  CHECK(std::abs(squared(BinInterpolation::linear) - (1.5 - 4 / pi)) <= longer);
  CHECK(std::abs(squared(BinInterpolation::sinc) - (1 - (8 + 4.0 / 9) / (pi * pi))) <= longer);
  const InterpolatedBins exact(BinInterpolation::exact, axis_of(10));
  CHECK(exact.largest_deviation(0, 9, 1).error == 0);
  CHECK(exact.largest_deviation(0, 9, 1).norm == 1);
}
