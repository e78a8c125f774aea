#include "evaluation/direction_colours.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>

#include "evaluation/hemisphere.h"
#include "tests/support/is_error.h"

namespace {

using brdf::Xyz;
using evaluation::DirectionPair;
using evaluation::Hemisphere;

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
    CHECK(expected == colours_of(pairs, Smooth{}, limits, [&](double part) { progress = part; }));
    CHECK(progress == 1);
  }
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

TEST_CASE("a hemisphere lists each pixel of its disk once, block by block", "[hemisphere]") {
  for (const int size : {2, 17, 64}) {
    const Hemisphere hemisphere(size);
    std::set<std::size_t> seen;
    for (const auto& pixel : hemisphere.pixels()) {
      CHECK(seen.insert(pixel.index(size)).second);
      CHECK(hemisphere.direction(pixel.column, pixel.row)->norm() == Approx(1).epsilon(1e-15));
    }
    std::size_t inside = 0;
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column)
        inside += hemisphere.direction(column, row).has_value();
    CHECK(seen.size() == inside);
  }
  // The disk fills pi / 4 of the square, but for pixels at its edge.
  CHECK(std::abs(static_cast<double>(Hemisphere(200).pixels().size()) / 40000 - brdf::pi / 4) <=
        2e-3);
  const Hemisphere blocks(64);
  const auto& first = blocks.pixels();
  for (std::size_t i = 1; i < 100; ++i)
    CHECK(std::abs(first[i].column - first[i - 1].column) <= 16);
  CHECK_ERROR(Hemisphere(1), brdf::Errc::invalid_argument, "1 pixels");
}

TEST_CASE("the middle of a pixel is its direction", "[hemisphere]") {
  const Hemisphere hemisphere(4);
  CHECK(*hemisphere.direction(2, 1) == brdf::Direction(0.25, -0.25, std::sqrt(0.875)));
  CHECK_FALSE(hemisphere.direction(0, 0));
  CHECK(hemisphere.direction(1, 3)->y() == 0.75);
}
