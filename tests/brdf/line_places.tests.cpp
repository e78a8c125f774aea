#include "brdf/line_places.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/is_error.h"

using brdf::Disorder;
using brdf::DisorderKind;
using brdf::Errc;
using brdf::Length;
using brdf::LinePlaces;
using brdf::random_engine;
using brdf::random_normal;
using brdf::RandomEngine;

namespace {

const Length period = Length::um(2);

LinePlaces lines(DisorderKind kind, double deviation, double reach, std::uint64_t seed = 1) {
  return {{.deviation = Length::um(2 * deviation), .kind = kind},
          period,
          reach,
          random_engine(seed, 0)};
}

/// Place of a numbered line; there are as many on the right of line 0 as on its left.
double place_of(const LinePlaces& places, int number) {
  const auto middle = static_cast<int>(places.places().size()) / 2;
  return places.places().at(static_cast<std::size_t>(middle + number));
}

// Sums of places up to 10 periods.
constexpr double rounding = 1e-14;

}  // namespace

TEST_CASE("numbers are drawn for the lines 0, 1, -1, 2, -2", "[line_places][oracle]") {
  RandomEngine engine = random_engine(1, 0);
  double z[7];
  for (double& value : z) value = 0.1 * random_normal(engine);

  const LinePlaces position = lines(DisorderKind::position, 0.1, 2);
  CHECK(std::abs(place_of(position, 0) - z[0]) <= rounding);
  CHECK(std::abs(place_of(position, 1) - (1 + z[1])) <= rounding);
  CHECK(std::abs(place_of(position, -1) - (-1 + z[2])) <= rounding);
  CHECK(std::abs(place_of(position, 2) - (2 + z[3])) <= rounding);
  CHECK(std::abs(place_of(position, -2) - (-2 + z[4])) <= rounding);

  const LinePlaces spacing = lines(DisorderKind::spacing, 0.1, 2);
  CHECK(place_of(spacing, 0) == 0);
  CHECK(std::abs(place_of(spacing, 1) - (1 + z[1])) <= rounding);
  CHECK(std::abs(place_of(spacing, -1) - (-1 - z[2])) <= rounding);
  CHECK(std::abs(place_of(spacing, 2) - (2 + z[1] + z[3])) <= rounding);
  CHECK(std::abs(place_of(spacing, -2) - (-2 - z[2] - z[4])) <= rounding);
}

TEST_CASE("a line keeps its place whatever the number of lines", "[line_places][invariant]") {
  for (const DisorderKind kind : {DisorderKind::position, DisorderKind::spacing}) {
    const LinePlaces few = lines(kind, 0.1, 5), many = lines(kind, 0.1, 50);
    REQUIRE(few.places().size() < many.places().size());
    for (int number = -5; number <= 5; ++number)
      CHECK(place_of(few, number) == place_of(many, number));
  }
}

TEST_CASE("stretches between lines fill the patch", "[line_places][invariant]") {
  for (const DisorderKind kind : {DisorderKind::position, DisorderKind::spacing})
    for (const double reach : {0.0, 0.3, 1.0, 7.77}) {
      CAPTURE(kind, reach);
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const LinePlaces places = lines(kind, 0.15, reach, seed);
        for (int i = -100; i <= 100; ++i) {
          const double position = reach * i / 100;
          const LinePlaces::Stretch stretch = places.at(position);
          REQUIRE(stretch.start <= position);
          REQUIRE(position < stretch.start + stretch.width);
        }
      }
    }
}

TEST_CASE("lines in order lie at the whole numbers", "[line_places][invariant]") {
  for (const LinePlaces& places : {LinePlaces(), lines(DisorderKind::position, 0, 9)}) {
    CHECK(places.in_order());
    CHECK(places.at(-0.25).start == -1);
    CHECK(places.at(3).start == 3);
    CHECK(places.at(3).width == 1);
  }
}

TEST_CASE("varied places keep the lattice, varied spacings lose it", "[line_places][invariant]") {
  constexpr int count = 2000;
  constexpr double deviation = 0.1;
  for (const DisorderKind kind : {DisorderKind::position, DisorderKind::spacing})
    for (const int number : {-16, 1, 4, 16}) {
      double sum = 0, squares = 0;
      for (std::uint64_t seed = 1; seed <= count; ++seed) {
        const double off = place_of(lines(kind, deviation, 17, seed), number) - number;
        sum += off;
        squares += off * off;
      }
      const double variance =
          deviation * deviation * (kind == DisorderKind::spacing ? std::abs(number) : 1);
      CAPTURE(kind, number);
      // Five standard errors of a mean and of a variance.
      CHECK(std::abs(sum / count) <= 5 * std::sqrt(variance / count));
      CHECK(std::abs(squares / count - variance) <= 5 * variance * std::sqrt(2.0 / count));
    }
}

TEST_CASE("disorder in which lines cross is refused", "[line_places][invariant]") {
  const auto with = [](double deviation) { return lines(DisorderKind::position, deviation, 9); };
  CHECK_ERROR(with(0.25), Errc::invalid_argument, "jitter 0.5 um must be below a quarter of");
  CHECK_ERROR(with(-0.1), Errc::invalid_argument, "jitter -0.2 um must be >= 0");
  CHECK_ERROR(with(std::numeric_limits<double>::quiet_NaN()), Errc::invalid_argument,
              "jitter nan um");
  // One pair in 430 crosses, in one of 32000 two lines fall back: 1e4 and 1e6 lines have some.
  CHECK_ERROR(lines(DisorderKind::position, 0.2499, 5e3), Errc::invalid_argument, "lines cross");
  CHECK_ERROR(lines(DisorderKind::spacing, 0.2499, 5e5), Errc::invalid_argument, "lines cross");
}

TEST_CASE("more lines than memory should hold are refused", "[line_places][invariant]") {
  CHECK_ERROR(lines(DisorderKind::position, 0.1, 1e9), Errc::invalid_argument,
              "jitter of 2e+09 lines: at most 16777216");
}
