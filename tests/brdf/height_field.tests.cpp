#include "brdf/height_field.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/is_error.h"

using brdf::Errc;
using brdf::HeightArray;
using brdf::HeightField;
using brdf::Length;

namespace {

HeightArray heights(std::initializer_list<std::initializer_list<double>> rows) {
  return HeightArray(rows);
}

}  // namespace

TEST_CASE("a height field keeps its heights, its pixels and its extent",
          "[height_field][invariant]") {
  const HeightField field(heights({{1, 2, 3}, {-4, 5, 6.5}}), Length::um(0.5), Length::um(0.25),
                          Length::nm(4));
  CHECK(field.rows() == 2);
  CHECK(field.cols() == 3);
  CHECK(field.dx_um() == 0.5);
  CHECK(field.dy_um() == 0.25);
  CHECK(field.width_um() == 1.5);
  CHECK(field.height_um() == 0.5);
  CHECK(field.height_step_um() == 0.004);
  CHECK(field.heights_um()(1, 0) == -4);
  CHECK(field.heights_um()(0, 2) == 3);
}

TEST_CASE("heights lie row by row in memory, as in the file", "[height_field][invariant]") {
  const HeightField field(heights({{1, 2, 3}, {4, 5, 6}}), Length::um(1), Length::um(1));
  for (int i = 0; i < 6; ++i) CHECK(field.heights_um().data()[i] == i + 1);
}

TEST_CASE("the range of heights is symmetric about its middle", "[height_field][invariant]") {
  const HeightField field(heights({{1, 2, 3}, {-4, 5, 6.5}}), Length::um(1), Length::um(1));
  CHECK(field.min_um() == -4);
  CHECK(field.max_um() == 6.5);
  CHECK(field.mid_range_um() == 1.25);
  CHECK(field.half_range_um() == 5.25);
  const HeightField flat(heights({{7.5}}), Length::um(1), Length::um(1));
  CHECK(flat.mid_range_um() == 7.5);
  CHECK(flat.half_range_um() == 0);
  CHECK(flat.height_step_um() == 0);
}

TEST_CASE("the first height that is not finite is named", "[height_field][invariant]") {
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Length um = Length::um(1);
  CHECK_ERROR(HeightField(heights({{1, 2, 3}, {4, 5, nan}, {inf, 1, 1}}), um, um), Errc::bad_input,
              "row 1, column 2 is nan");
  CHECK_ERROR(HeightField(heights({{1, -inf}}), um, um), Errc::bad_input,
              "row 0, column 1 is -inf");
}

TEST_CASE("a height field without pixels is refused", "[height_field][invariant]") {
  CHECK_ERROR(HeightField(HeightArray(0, 0), Length::um(1), Length::um(1)), Errc::bad_input,
              "no pixels");
  CHECK_ERROR(HeightField(HeightArray(3, 0), Length::um(1), Length::um(1)), Errc::bad_input,
              "no pixels");
}

TEST_CASE("a pixel that is not positive and finite is refused", "[height_field][invariant]") {
  const HeightArray one = heights({{0}});
  const Length good = Length::um(1);
  for (const auto& [bad_um, shown] : {std::pair<double, std::string>{0, "pixel 0 um"},
                                      {-0.1, "pixel -0.1 um"},
                                      {1 / 0.0, "pixel inf um"},
                                      {std::numeric_limits<double>::quiet_NaN(), "pixel nan um"}}) {
    CAPTURE(bad_um);
    CHECK_ERROR(HeightField(one, Length::um(bad_um), good), Errc::invalid_argument, shown);
    CHECK_ERROR(HeightField(one, good, Length::um(bad_um)), Errc::invalid_argument, shown);
  }
}
