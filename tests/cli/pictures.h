// What every picture of the program is.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>
#include <string>

inline std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | static_cast<std::uint8_t>(bytes.at(at + i));
  return value;
}

/// A whole PNG of a size that can be looked at.
inline void check_picture(const std::string& png) {
  REQUIRE(png.size() > 1000);
  CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(png.substr(12, 4) == "IHDR");
  CHECK(big_endian(png, 16) >= 640);
  CHECK(big_endian(png, 20) >= 480);
  CHECK(png.substr(png.size() - 8, 4) == "IEND");
}
