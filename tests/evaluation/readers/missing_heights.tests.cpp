#include "evaluation/readers/missing_heights.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/support/is_error.h"

namespace {

using brdf::Errc;
using brdf::HeightArray;
using evaluation::fill_missing;
using evaluation::MissingHeights;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

HeightArray heights(int rows, int cols, std::initializer_list<double> values) {
  HeightArray array(rows, cols);
  std::copy(values.begin(), values.end(), array.data());
  return array;
}

std::size_t filled(HeightArray& array) {
  return fill_missing(array, MissingHeights::neighbours, "scan");
}

}  // namespace

TEST_CASE("heights without a gap stay as they are under both policies", "[missing]") {
  const HeightArray before = heights(2, 2, {1, -2, 3, 1e300});
  for (const auto policy : {MissingHeights::refuse, MissingHeights::neighbours}) {
    HeightArray array = before;
    CHECK(fill_missing(array, policy, "scan") == 0);
    CHECK((array == before).all());
  }
}

TEST_CASE("missing heights are refused with their number and the first place", "[missing]") {
  HeightArray array = heights(3, 2, {1, 2, 3, none, none, 6});
  CHECK_ERROR(fill_missing(array, MissingHeights::refuse, "scan"), Errc::bad_input,
              "scan: 2 of 6 pixels");
  CHECK_ERROR(fill_missing(array, MissingHeights::refuse, "scan"), Errc::bad_input,
              "row 1, column 1");
  CHECK_ERROR(fill_missing(array, MissingHeights::refuse, "scan"), Errc::bad_input,
              "--missing neighbours");
}

TEST_CASE("a gap becomes the mean of its eight neighbours", "[missing]") {
  HeightArray array = heights(3, 3, {1, 2, 3, 4, none, 6, 7, 8, 17});
  CHECK(filled(array) == 1);
  CHECK(array(1, 1) == 6);  // 48 / 8
  // At the rim there are fewer, and no pixel of the other side.
  array = heights(2, 3, {none, 2, 100, 4, 6, 100});
  CHECK(filled(array) == 1);
  CHECK(array(0, 0) == 4);
}

TEST_CASE("a wide gap is filled ring by ring, each from the one before", "[missing]") {
  HeightArray array = heights(1, 7, {8, none, none, none, none, none, 16});
  CHECK(filled(array) == 5);
  CHECK((array == heights(1, 7, {8, 8, 8, 12, 16, 16, 16})).all());
}

TEST_CASE("a symmetric gap is filled symmetrically, whatever the order of its pixels",
          "[missing][invariant]") {
  HeightArray array(9, 9);
  for (int row = 0; row < 9; ++row)
    for (int col = 0; col < 9; ++col)
      array(row, col) = row >= 2 && row < 7 && col >= 2 && col < 7
                            ? none
                            : (row - 4) * (row - 4) + (col - 4) * (col - 4);
  CHECK(filled(array) == 25);
  // Sums of eight in another order: one rounding each.
  CHECK((array - array.transpose()).abs().maxCoeff() <= 1e-13);
  CHECK((array - array.colwise().reverse()).abs().maxCoeff() <= 1e-13);
  CHECK((array - array.rowwise().reverse()).abs().maxCoeff() <= 1e-13);
}

TEST_CASE("where no pixel has a height nothing can be filled", "[missing]") {
  HeightArray array = heights(1, 2, {none, none});
  CHECK_ERROR(filled(array), Errc::bad_input, "scan: no pixel has a height");
}

TEST_CASE("infinite heights are left to be refused by their place", "[missing]") {
  const double infinite = std::numeric_limits<double>::infinity();
  HeightArray array = heights(1, 3, {infinite, none, -infinite});
  CHECK(filled(array) == 1);  // and it ends
  CHECK(array(0, 0) == infinite);
  CHECK(!std::isfinite(array(0, 1)));
}
