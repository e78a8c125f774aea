#include "evaluation/direction_colours.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/support/is_error.h"

namespace {

using brdf::Xyz;
using evaluation::DirectionPair;

struct Smooth final : evaluation::DirectionColours {
  double at_x_of_one = 1;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Xyz> colours) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const brdf::Direction& d = pairs[i].omega_r;
      colours[i] = {std::exp(d.x()), d.y() * d.y(), d.x() == 0.8 ? at_x_of_one : d.z()};
    }
  }
};

std::vector<DirectionPair> many_pairs() {
  std::vector<DirectionPair> pairs;
  for (int i = 0; i < 1000; ++i) pairs.push_back({{0, 0, 1}, {std::sin(i), std::cos(i), 0.5}});
  return pairs;
}

}  // namespace

TEST_CASE("colours have the same bits for any number of threads", "[direction_colours]") {
  const auto pairs = many_pairs();
  const auto expected = colours_of(pairs, Smooth{}, {});
  REQUIRE(expected.size() == pairs.size());
  CHECK(expected[617].x == std::exp(std::sin(617)));
  for (const int threads : {2, 5}) {
    evaluation::RunLimits limits;
    limits.threads = threads;
    double progress = 0;
    bool ascends = true;
    CHECK(expected == colours_of(pairs, Smooth{}, limits, [&](double part) {
            ascends = ascends && part > progress;
            progress = part;
          }));
    CHECK(ascends);
    CHECK(progress == 1);
  }
}

TEST_CASE("no pairs have no colours", "[direction_colours]") {
  CHECK(colours_of({}, Smooth{}, {}).empty());
}

TEST_CASE("a colour that is no number, or comes too late, is refused", "[direction_colours]") {
  auto pairs = many_pairs();
  pairs[700].omega_r = {0.8, 0, 0.6};
  Smooth broken;
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    broken.at_x_of_one = value;
    CHECK_ERROR(colours_of(pairs, broken, {}), brdf::Errc::not_attainable, "(0.8, 0, 0.6)");
  }
  evaluation::RunLimits late;
  late.time = {std::chrono::steady_clock::now() - std::chrono::hours(1),
               std::chrono::duration<double>(1)};
  CHECK_ERROR(colours_of(pairs, Smooth{}, late, {}), brdf::Errc::over_limit, "--time-limit");
}
