#include <catch2/catch.hpp>
#include <cmath>

#include "evaluation/rgb_image.h"
#include "tests/support/is_error.h"

namespace {

using namespace evaluation;
using brdf::Errc;

const RgbImage image{2, 2, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {9, 99, 199}}};

}  // namespace

TEST_CASE("a picture comes back from its PNG", "[image]") {
  const std::string png = to_png(image);
  CHECK(png == to_png(image));
  const RgbImage read = decode_rgb_png(png, "x.png");
  CHECK((read.cols == 2 && read.rows == 2));
  CHECK(read.pixels == image.pixels);
}

TEST_CASE("textures are read at the centres of pixels and between, and repeat", "[image]") {
  CHECK(texture_at(image, 0.25, 0.75) == brdf::Rgb{1, 0, 0});
  CHECK(texture_at(image, 0.25, 0.25) == brdf::Rgb{0, 0, 1});
  CHECK(texture_at(image, 0.5, 0.75) == brdf::Rgb{0.5, 0.5, 0});
  CHECK(texture_at(image, 0, 0.75) == brdf::Rgb{0.5, 0.5, 0});
  CHECK(texture_at(image, -6.75, 3.75) == brdf::Rgb{1, 0, 0});
}

TEST_CASE("damaged pictures are refused", "[image][refusal]") {
  const std::string png = to_png(image);
  for (std::size_t length = 0; length < png.size() - 12; ++length)
    CHECK_THROWS_AS(decode_rgb_png(png.substr(0, length), "x.png"), brdf::Error);
  std::string wide = png;  // IHDR says 2^31 - 1 columns; its check sum is wrong as well
  wide.replace(16, 4, "\x7f\xff\xff\xff");
  CHECK_ERROR(decode_rgb_png(wide, "x.png"), Errc::bad_input, "x.png");
  CHECK_ERROR(to_png({2, 2, {}}), Errc::invalid_argument, "0 pixels");
}

TEST_CASE("codes are the nearest", "[image]") {
  CHECK(to_code({0, 0.5, 1}) == RgbCode{0, 128, 255});
  CHECK(to_code({0.4999 / 255, 0.5001 / 255, 254.6 / 255}) == RgbCode{0, 1, 255});
}
