#include "brdf/levelling.h"

#include <catch2/catch.hpp>

#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"

using brdf::Errc;
using brdf::HeightField;
using brdf::Length;
using brdf::Level;

namespace {

constexpr Grid oblong{17, 12, 0.3, 0.2};  // odd and even sides, pixels that are not square

double largest(const brdf::HeightArray& heights_um) {
  return heights_um.abs().maxCoeff();
}

}  // namespace

TEST_CASE("the slopes of a plane are found, in both directions", "[levelling][oracle]") {
  const HeightField plane = sampled(oblong.rows, oblong.cols, oblong.dx_um, oblong.dy_um,
                                    [](double x, double y) { return 3 + 0.25 * x - 0.125 * y; });
  const Eigen::Vector2d slopes = brdf::plane_slopes(plane);
  CHECK(std::abs(slopes.x() - 0.25) <= 1e-14);  // rounding of heights of 4 um over 3 um
  CHECK(std::abs(slopes.y() + 0.125) <= 1e-14);
}

TEST_CASE("taking off the plane leaves nothing of a plane", "[levelling][oracle]") {
  const HeightField plane = sampled(oblong.rows, oblong.cols, oblong.dx_um, oblong.dy_um,
                                    [](double x, double y) { return 3 + 0.25 * x - 0.125 * y; });
  // Rounding of the stored heights of 4 um.
  CHECK(largest(brdf::levelled(plane, Level::plane).heights_um()) <= 1e-14);
}

TEST_CASE("what is left of any surface has no mean and no slope", "[levelling][invariant]") {
  constexpr std::uint64_t seed = 21;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, oblong, 1, 2);
  const HeightField rest = brdf::levelled(field, Level::plane);
  CHECK(std::abs(rest.heights_um().mean()) <= 1e-15);
  CHECK(brdf::plane_slopes(rest).norm() <= 1e-15);
  CHECK(brdf::plane_slopes(field).norm() >= 1e-3);  // there was something to take off
  // Adding a plane before changes nothing after: heights of 5 um carry 1e-15.
  const HeightField tilted(
      field.heights_um() + sampled(oblong.rows, oblong.cols, oblong.dx_um, oblong.dy_um,
                                   [](double x, double y) { return x - y / 2 + 1; })
                               .heights_um(),
      Length::um(oblong.dx_um), Length::um(oblong.dy_um));
  CHECK(largest(brdf::levelled(tilted, Level::plane).heights_um() - rest.heights_um()) <= 1e-14);
}

TEST_CASE("no levelling changes nothing and the mean is all that mean levelling takes",
          "[levelling][invariant]") {
  constexpr std::uint64_t seed = 22;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, oblong, 1, 2);
  CHECK(largest(brdf::levelled(field, Level::none).heights_um() - field.heights_um()) == 0);
  const HeightField centred = brdf::levelled(field, Level::mean);
  CHECK(std::abs(centred.heights_um().mean()) <= 1e-15);  // 200 roundings of size 1e-16, averaged
  const brdf::HeightArray taken = field.heights_um() - centred.heights_um();
  CHECK(taken.maxCoeff() - taken.minCoeff() <= 1e-15);
}

TEST_CASE("levelling keeps the pixels and the height step", "[levelling][invariant]") {
  const HeightField field(brdf::HeightArray::Random(3, 4), Length::um(0.3), Length::um(0.2),
                          Length::nm(2));
  for (const Level level : {Level::none, Level::mean, Level::plane}) {
    const HeightField result = brdf::levelled(field, level);
    CHECK(result.dx_um() == 0.3);
    CHECK(result.dy_um() == 0.2);
    CHECK(result.height_step_um() == 0.002);
  }
}

TEST_CASE("an axis of one pixel has no slope", "[levelling][crossover]") {
  const HeightField row = sampled(1, 5, 0.5, 1, [](double x, double) { return x; });
  CHECK(std::abs(brdf::plane_slopes(row).x() - 1) <= 1e-15);
  CHECK(brdf::plane_slopes(row).y() == 0);
  const HeightField pixel = sampled(1, 1, 0.5, 1, [](double, double) { return 4.0; });
  CHECK(brdf::plane_slopes(pixel).norm() == 0);
  CHECK(largest(brdf::levelled(pixel, Level::plane).heights_um()) == 0);
}

TEST_CASE("reduction takes the means of blocks", "[levelling][oracle]") {
  brdf::HeightArray heights_um(2, 4);
  heights_um << 1, 2, 5, 6,  //
      3, 6, 7, 10;
  const HeightField field(heights_um, Length::um(0.3), Length::um(0.2), Length::nm(2));
  const HeightField half = brdf::reduced(field, 2);
  REQUIRE(half.rows() == 1);
  REQUIRE(half.cols() == 2);
  CHECK(half.heights_um()(0, 0) == 3);
  CHECK(half.heights_um()(0, 1) == 7);
  CHECK(half.dx_um() == 0.6);
  CHECK(half.dy_um() == 0.4);
  CHECK(half.width_um() == field.width_um());
  CHECK(half.height_um() == field.height_um());
  CHECK(half.height_step_um() == 0.002);
}

TEST_CASE("reduction keeps a plane a plane about the same middle", "[levelling][invariant]") {
  const HeightField plane =
      sampled(12, 18, 0.3, 0.2, [](double x, double y) { return 0.5 * x + 0.25 * y; });
  const HeightField third = brdf::reduced(plane, 3);
  const HeightField expected =
      sampled(4, 6, 0.9, 0.6, [](double x, double y) { return 0.5 * x + 0.25 * y; });
  CHECK(largest(third.heights_um() - expected.heights_um()) <= 1e-15);  // means of nine
  CHECK(largest(brdf::reduced(plane, 1).heights_um() - plane.heights_um()) == 0);
}

TEST_CASE("a reduction that does not fit is refused", "[levelling][invariant]") {
  const HeightField field = sampled(4, 6, 1, 1, [](double x, double) { return x; });
  for (const int factor : {0, -2, 3, 4, 12}) {
    CAPTURE(factor);
    CHECK_ERROR(brdf::reduced(field, factor), Errc::invalid_argument,
                "reduction " + std::to_string(factor) + " ");
  }
}
