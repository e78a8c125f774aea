#include "tests/cli/height_files.h"

#include <png.h>

#include <bit>
#include <stdexcept>

namespace {

int channels(Png::Colour colour) {
  switch (colour) {
    case Png::Colour::grey:
    case Png::Colour::palette:
      return 1;
    case Png::Colour::grey_alpha:
      return 2;
    case Png::Colour::rgb:
      return 3;
    case Png::Colour::rgba:
      return 4;
  }
  return 0;
}

int libpng_colour(Png::Colour colour) {
  switch (colour) {
    case Png::Colour::grey:
      return PNG_COLOR_TYPE_GRAY;
    case Png::Colour::palette:
      return PNG_COLOR_TYPE_PALETTE;
    case Png::Colour::grey_alpha:
      return PNG_COLOR_TYPE_GRAY_ALPHA;
    case Png::Colour::rgb:
      return PNG_COLOR_TYPE_RGB;
    case Png::Colour::rgba:
      return PNG_COLOR_TYPE_RGB_ALPHA;
  }
  return 0;
}

/// One row, a byte for each code of up to 8 bits, two for 16.
std::vector<std::uint8_t> row_bytes(const Png& png, std::uint32_t row) {
  std::vector<std::uint8_t> bytes;
  for (std::uint32_t col = 0; col < png.cols; ++col)
    for (int channel = 0; channel < channels(png.colour); ++channel) {
      const unsigned code = png.code(row, col, channel);
      if (png.bits == 16) bytes.push_back(static_cast<std::uint8_t>(code >> 8));
      bytes.push_back(static_cast<std::uint8_t>(code & 0xFF));
    }
  return bytes;
}

void append(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))
      ->append(reinterpret_cast<const char*>(bytes), count);
}

}  // namespace

std::string png_bytes(const Png& png) {
  std::string bytes;
  // libpng's own handlers abort on an error: a test that asks for an impossible file is wrong.
  png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(writer);
  png_set_write_fn(writer, &bytes, append, nullptr);
  png_set_IHDR(writer, info, png.cols, png.rows, png.bits, libpng_colour(png.colour),
               png.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  std::vector<png_color> palette;
  for (const unsigned grey : png.palette) {
    const auto value = static_cast<png_byte>(grey);
    palette.push_back({value, value, value});
  }
  if (!palette.empty())
    png_set_PLTE(writer, info, palette.data(), static_cast<int>(palette.size()));
  if (!png.palette_alphas.empty())
    png_set_tRNS(writer, info, png.palette_alphas.data(),
                 static_cast<int>(png.palette_alphas.size()), nullptr);
  png_color_16 transparent{};
  transparent.gray = static_cast<png_uint_16>(png.transparent_grey);
  if (png.transparent_grey >= 0) png_set_tRNS(writer, info, nullptr, 0, &transparent);
  png_write_info(writer, info);
  png_set_packing(writer);
  std::vector<std::vector<std::uint8_t>> rows;
  std::vector<png_bytep> starts;
  for (std::uint32_t row = 0; row < png.rows; ++row) rows.push_back(row_bytes(png, row));
  for (std::vector<std::uint8_t>& row : rows) starts.push_back(row.data());
  png_write_image(writer, starts.data());
  png_write_end(writer, info);
  png_destroy_write_struct(&writer, &info);
  return bytes;
}

std::string gsf_bytes(const Gsf& gsf) {
  std::string bytes = "Gwyddion Simple Field 1.0\n";
  bytes += gsf.resolution.empty() ? "XRes = " + std::to_string(gsf.cols) +
                                        "\nYRes = " + std::to_string(gsf.rows) + "\n"
                                  : gsf.resolution;
  bytes += gsf.lines;
  bytes.append(4 - bytes.size() % 4, '\0');
  const auto count = static_cast<std::size_t>(gsf.cols) * static_cast<std::size_t>(gsf.rows);
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = std::bit_cast<std::uint32_t>(i < gsf.heights.size() ? gsf.heights[i] : 0.0f);
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(bits >> shift & 0xFF);
  }
  return bytes;
}

ReadGsf read_gsf(const std::string& bytes) {
  const std::size_t end = bytes.find('\0');
  if (end == std::string::npos) throw std::runtime_error("no end of the GSF header");
  ReadGsf gsf{bytes.substr(0, end), {}};
  for (std::size_t at = (end / 4 + 1) * 4; at + 4 <= bytes.size(); at += 4) {
    std::uint32_t bits = 0;
    for (std::size_t i = 4; i-- > 0;) bits = bits << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    gsf.heights.push_back(std::bit_cast<float>(bits));
  }
  return gsf;
}
