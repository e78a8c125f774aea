#include "evaluation/rgb_image.h"

#include <png.h>

#include <cmath>

#include "brdf/error.h"

namespace evaluation {
namespace {

using brdf::Rgb;

/// Frees what libpng holds of a picture, whichever way its scope is left.
struct PngImage : png_image {
  PngImage() : png_image{} { version = PNG_IMAGE_VERSION; }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  ~PngImage() { png_image_free(this); }
};

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw brdf::Error(brdf::Errc::bad_input, name + ": " + what);
}

Rgb mixed(double t, const Rgb& a, const Rgb& b) {
  return {(1 - t) * a.r + t * b.r, (1 - t) * a.g + t * b.g, (1 - t) * a.b + t * b.b};
}

/// The two pixels around a position in pixels, repeated, and the share of the second.
struct Between {
  std::size_t first, second;
  double share;
};

Between between(double position, int count) {
  const double floor = std::floor(position);
  const double wrapped = floor - count * std::floor(floor / count);
  const auto size = static_cast<std::size_t>(count);
  const std::size_t first = static_cast<std::size_t>(wrapped) % size;
  return {first, (first + 1) % size, position - floor};
}

}  // namespace

RgbCode to_code(const Rgb& encoded) {
  const auto code = [](double c) { return static_cast<std::uint8_t>(std::lround(255 * c)); };
  return {code(encoded.r), code(encoded.g), code(encoded.b)};
}

Rgb linear_light(const RgbCode& code) {
  static const std::array<double, 256> table = [] {
    std::array<double, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = brdf::srgb_decoded(static_cast<double>(i) / 255);
    return values;
  }();
  return {table[code[0]], table[code[1]], table[code[2]]};
}

std::string to_png(const RgbImage& image) {
  if (image.cols < 1 || image.rows < 1 ||
      image.pixels.size() !=
          static_cast<std::size_t>(image.cols) * static_cast<std::size_t>(image.rows))
    throw brdf::Error(brdf::Errc::invalid_argument,
                      "picture of " + std::to_string(image.cols) + " x " +
                          std::to_string(image.rows) + " has " +
                          std::to_string(image.pixels.size()) + " pixels");
  PngImage png;
  png.width = static_cast<png_uint_32>(image.cols);
  png.height = static_cast<png_uint_32>(image.rows);
  png.format = PNG_FORMAT_RGB;
  const auto write = [&](void* memory, png_alloc_size_t& size) {
    if (!png_image_write_to_memory(&png, memory, &size, 0, image.pixels.data(), 0, nullptr))
      throw brdf::Error(brdf::Errc::cannot_write, std::string("PNG: ") + png.message);
  };
  png_alloc_size_t size = 0;
  write(nullptr, size);
  std::string bytes(size, '\0');
  write(bytes.data(), size);
  bytes.resize(size);
  return bytes;
}

RgbImage decode_rgb_png(std::string_view bytes, const std::string& name) {
  PngImage png;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()))
    refuse(name, std::string("PNG: ") + png.message);
  if (std::size_t{png.width} * png.height > max_image_pixels)
    refuse(name, std::to_string(png.width) + " x " + std::to_string(png.height) +
                     " pixels; at most " + std::to_string(max_image_pixels));
  if (png.format & PNG_FORMAT_FLAG_ALPHA)
    refuse(name, "has transparency; a texture needs opaque pixels");
  // 16 bits are sRGB as 8 are, not linear light.
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  png.format = PNG_FORMAT_RGB;
  RgbImage image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.pixels.resize(std::size_t{png.width} * png.height);
  if (!png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr))
    refuse(name, std::string("PNG: ") + png.message);
  return image;
}

Rgb texture_at(const RgbImage& image, double u, double v) {
  const auto repeated = [](double c) { return c - std::floor(c); };
  const Between col = between(repeated(u) * image.cols - 0.5, image.cols);
  const Between row = between((1 - repeated(v)) * image.rows - 0.5, image.rows);
  const auto at = [&](std::size_t r, std::size_t c) {
    return linear_light(image.pixels[r * static_cast<std::size_t>(image.cols) + c]);
  };
  return mixed(row.share, mixed(col.share, at(row.first, col.first), at(row.first, col.second)),
               mixed(col.share, at(row.second, col.first), at(row.second, col.second)));
}

}  // namespace evaluation
