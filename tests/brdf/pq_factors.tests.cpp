#include "brdf/pq_factors.h"

#include <catch2/catch.hpp>
#include <complex>
#include <limits>

#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::Errc;
using brdf::pq_factor;

namespace {

constexpr long double pi_wide = 3.14159265358979323846264338327950288L;

/// sin(N pi nu) / (N sin(pi nu)) in extended precision; every product and remainder of it is
/// exact or within 2^-64, as nu is a double and N an integer.
long double closed_form(double cycles, int replicas) {
  const long double nearest = std::round(static_cast<long double>(cycles));
  const long double t = cycles - nearest, n = replicas;
  const long double sign = replicas % 2 == 0 && std::fmod(nearest, 2.0L) != 0 ? -1 : 1;
  if (t == 0) return sign;
  return sign * std::sin(pi_wide * std::remainder(n * t, 2.0L)) / (n * std::sin(pi_wide * t));
}

/// The copies one by one, each phase reduced in cycles. cycles: below 2^20, where the products with
/// half integers below 2^10 are exact in 64 bits for the values taken here.
long double sum_of_copies(double cycles, int replicas) {
  std::complex<long double> sum = 0;
  for (int copy = 0; copy < replicas; ++copy) {
    const long double place = copy - (replicas - 1) / 2.0L;
    // e^{2 pi i nu j} for half-integer j has the period 2 in nu.
    const long double turns = std::fmod(static_cast<long double>(cycles), 2.0L) * place;
    sum += std::polar(1.0L, 2 * pi_wide * std::remainder(turns, 1.0L));
  }
  return sum.real() / replicas;
}

const std::vector<int> all_replicas{1, 2, 3, 7, 10, 99, 100, 101, 1000, 1'000'000, 1'000'000'000};

// Two units in the last place of the peak: two sines, their arguments, a product and a quotient
// round by half a unit each, and do not all add up.
constexpr double accuracy = 2 * std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("the closed form is the sum over the copies", "[pq_factors][oracle]") {
  constexpr std::uint64_t seed = 201;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError error;
  for (const int replicas : {1, 2, 3, 4, 7, 25, 99, 100})
    for (int i = 0; i < 200; ++i) {
      const double cycles = i < 40 ? (i - 20) / 2.0 : uniform(-60, 60);
      error.see(std::abs(
          static_cast<double>(pq_factor(cycles, replicas) - sum_of_copies(cycles, replicas))));
    }
  CHECK(error.value() <= accuracy);
}

TEST_CASE("the factor keeps its accuracy at any distance from any order", "[pq_factors][oracle]") {
  WorstError error;
  for (const int replicas : all_replicas)
    for (const double order : {0.0, 1.0, 2.0, 3.0, 10.0, 999.0, 1e3, 65537.0, 1e6, -1.0, -1e6})
      for (int decade = 1; decade <= 16; ++decade)
        for (const double digit : {-5.0, -2.3, -1.0, 1.0, 3.7, 5.0}) {
          const double cycles = order + digit * std::pow(10.0, -decade);
          error.see(static_cast<double>(
              std::abs(pq_factor(cycles, replicas) - closed_form(cycles, replicas))));
        }
  CHECK(error.value() <= accuracy);
}

TEST_CASE("both sides of the branch near an order are as good", "[pq_factors][crossover]") {
  // Where N t passes 1e-9.
  WorstError error;
  for (const int replicas : all_replicas) {
    double below = 1e-9 / replicas * (1 - 1e-14), above = below;
    for (int step = 0; step < 200; ++step) {
      for (const double t : {below, above, -below, -above})
        error.see(static_cast<double>(std::abs(pq_factor(t, replicas) - closed_form(t, replicas))));
      below = std::nextafter(below, 0.0);
      above = std::nextafter(above, 1.0);
    }
  }
  CHECK(error.value() <= accuracy);
}

TEST_CASE("at an order the factor is its peak, with the sign of the copies' phase",
          "[pq_factors][invariant]") {
  for (const int replicas : all_replicas)
    for (const double order :
         {0.0, 1.0, 2.0, 3.0, 1e6, 1e6 + 1, 1e15 + 1, 1e17, -1.0, -4.0, -7.0}) {
      CAPTURE(replicas, order);
      const bool negative = replicas % 2 == 0 && std::fmod(order, 2) != 0;
      CHECK(pq_factor(order, replicas) == (negative ? -1 : 1));
    }
}

TEST_CASE("at a frequency so small that its products round, the factor is 1",
          "[pq_factors][crossover]") {
  // pi times the smallest denormal rounds by 5 per cent.
  for (const int replicas : {2, 3, 100, 1000000})
    CHECK(brdf::pq_factor(std::numeric_limits<double>::denorm_min(), replicas) == 1);
}

TEST_CASE("the factor is never NaN and never above its peak", "[pq_factors][invariant]") {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  constexpr std::uint64_t seed = 202;
  CAPTURE(seed);
  Uniform uniform(seed);
  std::vector<double> cycles{
      0.0,  -0.0, tiny, -tiny, 3 * tiny, 2.3e-308, 0.5,
      -0.5, 1e16, 1e17, 1e18,  -1e17,    1e300,    std::numeric_limits<double>::max()};
  for (int i = 0; i < 1000; ++i) cycles.push_back(std::pow(10.0, uniform(-320, 20)));
  WorstError largest;
  for (const int replicas : all_replicas)
    for (const double nu : cycles) largest.see(std::abs(pq_factor(nu, replicas)));
  CHECK(largest.value() <= 1 + accuracy);
}

TEST_CASE("the factor has N - 1 zeros between two orders", "[pq_factors][oracle]") {
  for (const int replicas : {2, 5, 16, 100})
    for (int m = 1; m < replicas; ++m) {
      // The double next to m / N is off by up to eps / 2 of it, times the slope there.
      const double nu = static_cast<double>(m) / replicas;
      const double slope = brdf::pi / std::sin(brdf::pi * nu);
      CHECK(std::abs(pq_factor(nu, replicas)) <= accuracy + 1.2e-16 * nu * slope);
    }
}

TEST_CASE("no copies are refused", "[pq_factors][invariant]") {
  for (const int replicas : {0, -1})
    CHECK_ERROR(pq_factor(0.3, replicas), Errc::invalid_argument,
                "replicas " + std::to_string(replicas));
}
