// The codes of a PNG, by libpng.
#pragma once

#include <png.h>

#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

using Code = std::array<int, 3>;

/// Codes of a picture, row by row from the top.
struct Pixels {
  std::size_t cols, rows;
  std::vector<unsigned char> codes;

  Code at(std::size_t col, std::size_t row) const {
    const auto* p = &codes.at(3 * (row * cols + col));
    return {p[0], p[1], p[2]};
  }
};

inline Pixels pixels_of(const std::string& bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()))
    throw std::runtime_error(png.message);
  png.format = PNG_FORMAT_RGB;
  Pixels pixels{png.width, png.height, {}};
  pixels.codes.resize(PNG_IMAGE_SIZE(png));
  if (!png_image_finish_read(&png, nullptr, pixels.codes.data(), 0, nullptr))
    throw std::runtime_error(png.message);
  return pixels;
}

/// The code of most pixels, paper aside.
inline Code commonest_code(const Pixels& picture) {
  std::map<Code, int> counts;
  for (std::size_t row = 0; row < picture.rows; ++row)
    for (std::size_t col = 0; col < picture.cols; ++col) ++counts[picture.at(col, row)];
  counts.erase({255, 255, 255});
  Code commonest{};
  int most = 0;
  for (const auto& [code, count] : counts)
    if (count > most) {
      commonest = code;
      most = count;
    }
  return commonest;
}
