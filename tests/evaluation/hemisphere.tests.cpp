#include "evaluation/hemisphere.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <utility>

#include "tests/support/is_error.h"

namespace {

using evaluation::Hemisphere;

}  // namespace

TEST_CASE("a hemisphere lists each pixel of its disk once", "[hemisphere]") {
  for (const int size : {2, 3, 15, 16, 17, 64}) {
    CAPTURE(size);
    const Hemisphere hemisphere(size);
    CHECK(hemisphere.size() == size);
    std::set<std::size_t> seen;
    for (const auto& pixel : hemisphere.pixels()) {
      CHECK(seen.insert(pixel.index(size)).second);
      const auto direction = hemisphere.direction(pixel.column, pixel.row);
      REQUIRE(direction);
      CHECK(direction->z() > 0);
      // Rounding of three squares and a root.
      CHECK(std::abs(direction->norm() - 1) <= 1e-15);
    }
    // In whole numbers: a centre is inside where (2 c + 1 - n)^2 + (2 r + 1 - n)^2 < n^2.
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) {
        const int x = 2 * column + 1 - size, y = 2 * row + 1 - size;
        const auto index = Hemisphere::Pixel{column, row}.index(size);
        CHECK((seen.count(index) == 1) == (x * x + y * y < size * size));
      }
  }
}

TEST_CASE("the disk fills pi / 4 of its square", "[hemisphere]") {
  for (const int size : {50, 201, 400}) {
    const double part = static_cast<double>(Hemisphere(size).pixels().size()) / size / size;
    // Pixels that the rim cuts, some 4 n of them, are in or out by chance: 2 sqrt(n) / n^2.
    CHECK(std::abs(part - brdf::pi / 4) <= 2 * std::pow(size, -1.5));
  }
}

TEST_CASE("the pixels of a block of 16 x 16 follow each other", "[hemisphere]") {
  for (const int size : {40, 64}) {
    const Hemisphere hemisphere(size);
    std::set<std::pair<int, int>> blocks;
    std::pair<int, int> last{-1, -1};
    for (const auto& pixel : hemisphere.pixels()) {
      const std::pair<int, int> block{pixel.column / 16, pixel.row / 16};
      if (block != last) CHECK(blocks.insert(block).second);  // none is come back to
      last = block;
    }
    const auto along = static_cast<std::size_t>((size + 15) / 16);
    CHECK(blocks.size() == along * along);
  }
}

TEST_CASE("the middle of a pixel is its direction, row 0 at the bottom", "[hemisphere]") {
  const Hemisphere even(4);
  CHECK(*even.direction(2, 1) == brdf::Direction(0.25, -0.25, std::sqrt(0.875)));
  CHECK(even.direction(1, 3)->y() == 0.75);
  CHECK_FALSE(even.direction(0, 0));
  const Hemisphere odd(5);
  // (2 2 + 1) / 5 - 1 is exactly 0.
  CHECK(*odd.direction(2, 2) == brdf::Direction(0, 0, 1));
}

TEST_CASE("a hemisphere of less than two pixels a side is refused", "[hemisphere]") {
  for (const int size : {1, 0, -7})
    CHECK_ERROR(Hemisphere(size), brdf::Errc::invalid_argument, std::to_string(size) + " pixels");
}
