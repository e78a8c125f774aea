#include "brdf/colour_volume.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

namespace {

using brdf::VolumeGrid;
using brdf::VolumeShape;
using brdf::Xyz;

/// A volume of f(u, v) (1, T_1(w + 1), T_2(w + 1)) in X, Y and Z.
template <class Function>
std::vector<float> filled(const VolumeGrid& grid, Function f) {
  std::vector<float> numbers(grid.size());
  float* to = numbers.data();
  for (int ring = 0; ring < grid.rings(); ++ring)
    for (int i = 0; i < grid.angles(ring); ++i) {
      const double phi = 2 * brdf::pi * i / grid.angles(ring), r = grid.radius(ring);
      for (int n = 0; n < grid.shape().terms; ++n)
        for (int c = 0; c < 3; ++c)
          *to++ = c == n ? static_cast<float>(f(r * std::cos(phi), r * std::sin(phi))) : 0.0f;
    }
  return numbers;
}

/// Largest error over random places and those at the edges.
template <class Function>
double worst_error(const VolumeShape& shape, Function f) {
  const VolumeGrid grid(shape);
  const std::vector<float> numbers = filled(grid, f);
  const brdf::ColourVolume volume(grid, numbers);
  WorstError worst;
  const auto check = [&](double u, double v, double w) {
    const Xyz found = volume(u, v, w);
    const double t = w + 1, value = f(u, v);
    for (const double error :
         {found.x - value, found.y - t * value, found.z - (2 * t * t - 1) * value})
      worst.see(std::abs(error));
  };
  Uniform uniform(7);
  for (int i = 0; i < 2000; ++i) {
    const double r = uniform(0, 2), phi = uniform(-4, 4);
    check(r * std::cos(phi), r * std::sin(phi), uniform(-2, 0));
  }
  for (const double w : {-2.0, 0.0})
    for (const double r : {0.0, 1e-9, 0.01, 2.0})
      for (const double phi : {0.0, 1e-12, -1e-12, -1e-17, brdf::pi, -brdf::pi, 2.0})
        check(r * std::cos(phi), r * std::sin(phi), w);
  return worst.value();
}

}  // namespace

TEST_CASE("a volume gives a smooth function back, at every edge of its grid", "[colour_volume]") {
  const auto f = [](double u, double v) { return 1 + u - 0.5 * v + u * v + std::sin(2 * u + v); };
  // Single precision of numbers up to 8: 5e-7; the rest is the sixth power of the steps.
  CHECK(worst_error({0.01, 0.02, 400, 3}, f) <= 3e-6);
}

TEST_CASE("polynomials in u and v come back to single precision", "[colour_volume]") {
  const auto check = [](auto f) {
    // Single precision of numbers up to 8, and of 36 products: 2e-6. The steps of 0.02 of r leave
    // less than 1e-8 of a cubic.
    CHECK(worst_error({0.01, 0.02, 200, 3}, f) <= 4e-6);
  };
  check([](double, double) { return 1.0; });
  check([](double u, double) { return u; });
  check([](double u, double v) { return u * v; });
  check([](double u, double v) { return v * v * v - u * u * v; });
}

TEST_CASE("what lies a rounding beyond the grid is read at its edge", "[colour_volume]") {
  const VolumeGrid grid({0.05, 0.1, 60, 3});
  const std::vector<float> numbers = filled(grid, [](double u, double v) { return 1 + u - v; });
  const brdf::ColourVolume volume(grid, numbers);
  const double beyond = 2 * (1 + 1e-12);
  CHECK(volume(beyond, 0, -1) == volume(2, 0, -1));
  CHECK(volume(0, -beyond, -1) == volume(0, -2, -1));
  CHECK(volume(0.3, 0.4, 1e-12) == volume(0.3, 0.4, 0));
  CHECK(volume(0.3, 0.4, -beyond) == volume(0.3, 0.4, -2));
}

TEST_CASE("the error of a volume falls with the sixth power of its steps", "[colour_volume]") {
  const auto f = [](double u, double v) { return std::sin(3 * u) * std::cos(3 * v); };
  const double coarse = worst_error({0.05, 0.1, 60, 3}, f),
               fine = worst_error({0.025, 0.05, 120, 3}, f);
  CAPTURE(coarse, fine);
  CHECK(coarse <= 0.01);
  CHECK(fine <= coarse / 30);  // 64 where all steps are halved; rings have a few points besides
}

TEST_CASE("the rings of a volume cover all directions, the last beyond abs(u, v) = 2",
          "[colour_volume]") {
  const VolumeGrid grid({0.01, 0.02, 300, 4});
  CHECK(grid.radius(0) == 0);
  CHECK(grid.angles(0) == 1);
  CHECK(grid.radius(1) == Approx(0.01).epsilon(1e-3));
  CHECK(grid.radius(grid.rings() - 1 - VolumeGrid::margin) >= 2);
  CHECK(grid.ring_of(grid.radius(57)) == Approx(57));
  std::size_t points = 0;
  for (int ring = 0; ring < grid.rings(); ++ring) {
    CHECK(grid.first(ring) == points);
    points += static_cast<std::size_t>(grid.angles(ring));
  }
  CHECK(grid.points() == points);
  CHECK(grid.size() == points * 12);
}

TEST_CASE("shapes that no volume has are refused", "[colour_volume]") {
  const auto refused = [](const VolumeShape& shape, const char* part) {
    CHECK_ERROR(VolumeGrid(shape), brdf::Errc::invalid_argument, part);
  };
  refused({0, 0.02, 300, 4}, "centre step");
  refused({0.01, 1e-9, 300, 4}, "relative step");
  refused({0.01, std::nan(""), 300, 4}, "relative step");
  refused({0.01, 0.02, 1e9, 4}, "angles");
  refused({0.01, 0.02, 300, 0}, "terms");
  refused({0.01, 0.02, 300, 257}, "terms");
  refused({-0.01, 0.02, 300, 4}, "centre step");
  refused({0.01, 0.02, 0, 4}, "angles");
  refused({0.01, 0.02, 300, -1}, "terms");
  const std::vector<float> few(10);
  CHECK_ERROR(brdf::ColourVolume(VolumeGrid({0.01, 0.02, 300, 4}), few),
              brdf::Errc::invalid_argument, "10 numbers");
}
