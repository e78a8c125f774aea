#include "brdf/slope.h"

#include <catch2/catch.hpp>
#include <limits>

#include "brdf/levelling.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"

using brdf::HeightField;
using brdf::pi;
using brdf::rms_slope;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("the slope of a tilted plane is its gradient, whatever the pixels", "[slope][oracle]") {
  const HeightField plane =
      sampled(20, 30, 0.1, 0.25, [](double x, double y) { return 0.3 * x - 0.4 * y + 7; });
  // Heights near 10 um carry 1e-15 um: 1e-14 of a difference over a pixel.
  CHECK(std::abs(rms_slope(plane) - 0.5) <= 1e-13);
  CHECK(rms_slope(levelled(plane, brdf::Level::plane)) <= 1e-13);
}

TEST_CASE("the slope of a sinusoid is k A / sqrt 2 less what the pixels average",
          "[slope][oracle]") {
  const double amplitude_um = 0.2, period_um = 2;
  for (const int per_period : {5, 10, 40}) {
    CAPTURE(per_period);
    const double pixel_um = period_um / per_period, k = 2 * pi / period_um;
    const auto height_um = [&](double x, double) { return amplitude_um * std::sin(k * x + 0.3); };
    // One sample more than whole periods: as many differences as fill them.
    const Eigen::Index samples = 7 * per_period + 1;
    const double x = k * pixel_um / 2;
    const double expected = k * amplitude_um / std::sqrt(2) * std::sin(x) / x;
    CHECK(std::abs(rms_slope(sampled(1, samples, pixel_um, 5, height_um)) / expected - 1) <= 1e-13);
    const auto across = [&](double, double y) { return height_um(y, 0); };
    CHECK(std::abs(rms_slope(sampled(samples, 1, 5, pixel_um, across)) / expected - 1) <= 1e-13);
  }
}

TEST_CASE("the slopes of the two axes add in squares", "[slope][invariant]") {
  const auto along_x = [](double x, double) { return 0.1 * std::sin(3 * x); };
  const auto along_y = [](double, double y) { return 0.2 * std::cos(2 * y); };
  const auto field = [](auto height_um) { return sampled(40, 50, 0.1, 0.2, height_um); };
  const double both =
      rms_slope(field([&](double x, double y) { return along_x(x, y) + along_y(x, y); }));
  CHECK(std::abs(both / std::hypot(rms_slope(field(along_x)), rms_slope(field(along_y))) - 1) <=
        1e-13);
}

TEST_CASE("the slope grows with the height, shrinks with the pixel and needs two pixels",
          "[slope][invariant]") {
  constexpr std::uint64_t seed = 95;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, {9, 13, 0.1, 0.3}, 0, 1);
  const auto scaled = [&](double height, double pixel) {
    return HeightField(height * field.heights_um(), brdf::Length::um(pixel * 0.1),
                       brdf::Length::um(pixel * 0.3));
  };
  CHECK(std::abs(rms_slope(scaled(4, 2)) / rms_slope(field) - 2) <= 8 * eps);
  CHECK(rms_slope(sampled(1, 1, 1, 1, [](double, double) { return 3.0; })) == 0);
}
