#include "brdf/random_numbers.h"

#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "tests/support/oracle_table.h"

using brdf::normal_quantile;
using brdf::random_engine;
using brdf::random_normal;
using brdf::RandomEngine;
using brdf::unit_interval;

// Wichura's fractions are good to 1e-16; a dozen roundings of 1.1e-16 add up to some of the last
// bits. Measured 4.4e-16.
constexpr double quantile_rounding = 5e-16;

TEST_CASE("the engine is the one of the standard", "[random_numbers][oracle]") {
  RandomEngine engine;
  engine.discard(9999);
  CHECK(engine() == 9981545732273789042U);  // [rand.predef]
}

TEST_CASE("quantiles of the normal distribution are those of the table",
          "[random_numbers][oracle]") {
  for (const OracleRow& row : oracle_table("normal_quantiles.csv")) {
    CAPTURE(row[0]);
    const double z = number(row[1]);
    CHECK(std::abs(normal_quantile(number(row[0])) - z) <= quantile_rounding * std::abs(z));
  }
}

TEST_CASE("numbers of an engine are those of another program", "[random_numbers][oracle]") {
  for (const OracleRow& row : oracle_table("normal_numbers.csv")) {
    CAPTURE(row);
    RandomEngine engine = random_engine(
        std::stoull(row[0]), static_cast<std::uint32_t>(std::stoul(row[1])), std::stoll(row[2]));
    engine.discard(std::stoull(row[3]) - 1);
    const double z = number(row[4]);
    CHECK(std::abs(random_normal(engine) - z) <= quantile_rounding * std::abs(z));
  }
}

TEST_CASE("no bits make a 0 or a 1", "[random_numbers][crossover]") {
  const std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
  CHECK(unit_interval(0) == 0x1p-53);
  CHECK(unit_interval(all) == 1 - 0x1p-53);
  CHECK(normal_quantile(unit_interval(all)) == -normal_quantile(unit_interval(0)));
}

TEST_CASE("quantiles are odd about one half", "[random_numbers][invariant]") {
  RandomEngine engine(5);
  for (int i = 0; i < 1000; ++i) {
    const double p = unit_interval(engine());
    REQUIRE(normal_quantile(1 - p) == -normal_quantile(p));  // 1 - p is exact
  }
}

TEST_CASE("a million numbers have the moments of the normal distribution",
          "[random_numbers][invariant]") {
  constexpr int count = 1'000'000;
  double sums[5] = {};
  int beyond_3 = 0;
  RandomEngine engine = random_engine(1, 0);
  for (int i = 0; i < count; ++i) {
    const double z = random_normal(engine);
    double power = 1;
    for (double& sum : sums) {
      sum += power;
      power *= z;
    }
    beyond_3 += std::abs(z) > 3;
  }
  // Five standard errors: the variances of z, z^2, z^3, z^4 are 1, 2, 15, 96.
  const double five_errors = 5 / std::sqrt(count);
  CHECK(std::abs(sums[1] / count) <= five_errors);
  CHECK(std::abs(sums[2] / count - 1) <= five_errors * std::sqrt(2));
  CHECK(std::abs(sums[3] / count) <= five_errors * std::sqrt(15));
  CHECK(std::abs(sums[4] / count - 3) <= five_errors * std::sqrt(96));
  const double share = std::erfc(3 / std::sqrt(2));
  CHECK(std::abs(static_cast<double>(beyond_3) / count - share) <= five_errors * std::sqrt(share));
}

TEST_CASE("every seed, part and index has its own numbers", "[random_numbers][invariant]") {
  std::set<std::uint64_t> firsts;
  for (const std::uint64_t seed : {1ULL, 2ULL, 1ULL << 32, (1ULL << 32) + 1})
    for (const std::uint32_t part : {0U, 1U, 4U})
      for (const std::int64_t index : {-1, 0, 1, 2})
        firsts.insert(random_engine(seed, part, index)());
  CHECK(firsts.size() == 4 * 3 * 4);
}
