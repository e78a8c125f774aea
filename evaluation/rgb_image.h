// Colour pictures of 8 bits, to and from PNG.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/colour.h"

namespace evaluation {

/// The codes 0 to 255 of red, green and blue, each through the transfer curve of sRGB.
using RgbCode = std::array<std::uint8_t, 3>;

/// Rows from the top.
struct RgbImage {
  int cols = 0, rows = 0;
  std::vector<RgbCode> pixels;
};

/// Most pixels of a picture that is read.
inline constexpr std::size_t max_image_pixels = std::size_t{1} << 26;

/// The nearest codes. encoded: 0 to 1 each, through the transfer curve.
RgbCode to_code(const brdf::Rgb& encoded);

/// Linear light of a code.
brdf::Rgb linear_light(const RgbCode& code);

/// The bytes of a PNG, 8-bit sRGB; the same image gives the same bytes.
///
/// Throws Errc::invalid_argument where the count of pixels is not cols x rows > 0.
std::string to_png(const RgbImage& image);

/// A picture from the bytes of a PNG: grey, palette or colour of 1 to 16 bits, rounded to 8.
///
/// Throws Errc::bad_input naming `name`: no PNG, a damaged one, more than max_image_pixels, one
/// with transparency.
RgbImage decode_rgb_png(std::string_view bytes, const std::string& name);

/// Linear light of a picture at texture coordinates, bilinear between the centres of pixels.
///
/// u to the right, v up, 0 to 1 from edge to edge, repeated outside; finite.
brdf::Rgb texture_at(const RgbImage& image, double u, double v);

}  // namespace evaluation
