#include "evaluation/readers/tiff_reader.h"

#include <catch2/catch.hpp>

#include "tests/support/damaged_files.h"
#include "tests/support/foreign_files.h"

namespace {

/// One of the files, and what is stored in it.
struct Foreign {
  std::string name, values, format;
  std::optional<double> full_scale = {}, step = {};
};

/// The bytes of a classic little-endian TIFF with the value of one tag changed, all its entries
/// being SHORT or LONG.
std::string with_tag(std::string bytes, unsigned tag, unsigned value) {
  const auto number = [&](std::size_t at, std::size_t size) {
    unsigned result = 0;
    for (std::size_t i = size; i-- > 0;)
      result = result << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return result;
  };
  const std::size_t directory = number(4, 4);
  for (unsigned i = 0; i < number(directory, 2); ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    if (number(entry, 2) != tag) continue;
    for (std::size_t k = 0; k < 4; ++k) bytes[entry + 8 + k] = static_cast<char>(value >> 8 * k);
    return bytes;
  }
  throw std::runtime_error("no tag " + std::to_string(tag));
}

constexpr unsigned width_tag = 256, length_tag = 257, bits_tag = 258, compression_tag = 259,
                   photometric_tag = 262, byte_counts_tag = 279, sample_format_tag = 339;

}  // namespace

TEST_CASE("TIFFs of other programs give their values to the last bit", "[readers][oracle]") {
  for (const Foreign& file : std::vector<Foreign>{
           {"tifffile_uint8.tif", "uint8.csv", "TIFF, 8 bit", 255},
           {"tifffile_uint16.tif", "uint16.csv", "TIFF, 16 bit", 65535},
           {"tifffile_uint16_big_endian.tif", "uint16.csv", "TIFF, 16 bit", 65535},
           {"tifffile_uint32.tif", "uint32.csv", "TIFF, 32 bit unsigned", {}, 1},
           {"tifffile_int8.tif", "int8.csv", "TIFF, 8 bit signed", {}, 1},
           {"tifffile_int16.tif", "int16.csv", "TIFF, 16 bit signed", {}, 1},
           {"tifffile_int32.tif", "int32.csv", "TIFF, 32 bit signed", {}, 1},
           {"tifffile_float32.tif", "float32.csv", "TIFF, 32 bit float"},
           {"tifffile_float32_edges.tif", "float32_edges.csv", "TIFF, 32 bit float"},
           {"tifffile_float32_deflate.tif", "float32.csv", "TIFF, 32 bit float"},
           {"tifffile_rgb.tif", "uint8.csv", "TIFF, 8 bit, colour with R = G = B", 255},
           {"tiffcp_uint8_packbits.tif", "uint8.csv", "TIFF, 8 bit", 255},
           {"tiffcp_uint8_tiles.tif", "uint8.csv", "TIFF, 8 bit", 255},
           {"tiffcp_uint16_lzw.tif", "uint16.csv", "TIFF, 16 bit", 65535},
           {"tiffcp_uint16_bigtiff.tif", "uint16.csv", "TIFF, 16 bit", 65535},
           {"tiffcp_float32_tiles.tif", "float32.csv", "TIFF, 32 bit float"}}) {
    INFO(file.name);
    const evaluation::RawHeights raw = decoded(foreign_file(file.name));
    check_same_bits(raw.values, foreign_values(file.values));
    CHECK(raw.format == file.format);
    CHECK(raw.full_scale == file.full_scale);
    CHECK(raw.step == file.step);
    // A resolution is of the print, not of the surface.
    CHECK(!raw.pixel_x);
    CHECK(!raw.unit);
  }
}

TEST_CASE("a TIFF of doubles keeps them, and says how fine they are", "[readers][oracle]") {
  const brdf::HeightArray expected = foreign_values("float64.csv");
  for (const char* name : {"tifffile_float64.tif", "tiffcp_float64_deflate.tif"}) {
    const evaluation::RawHeights raw = decoded(foreign_file(name));
    check_same_bits(raw.values, expected);
    CHECK(raw.step == expected.abs().maxCoeff() * std::numeric_limits<double>::epsilon());
  }
}

TEST_CASE("a TIFF of several pictures is read by number alone", "[readers]") {
  const brdf::HeightArray first = foreign_values("uint16.csv");
  const std::filesystem::path file = foreign_file("tifffile_two.tif");
  check_same_bits(decoded(file, request_for("1")).values, first);
  check_same_bits(decoded(file, request_for("2")).values, first.colwise().reverse());
  const std::string bytes = foreign_bytes("tifffile_two.tif");
  check_names(decoder_refusal(bytes), "--channel");
  for (const char* channel : {"0", "3", "-1", "1.5", "first", "", "65536", "99999999999"})
    check_names(decoder_refusal(bytes, request_for(channel)), "--channel " + std::string(channel));
}

TEST_CASE("the number that GDAL calls missing is missing", "[readers]") {
  brdf::HeightArray expected = foreign_values("int16.csv");
  const double missing = expected(3, 5);
  expected = (expected == missing).select(no_height, expected);
  check_same_bits(decoded(foreign_file("tifffile_nodata.tif")).values, expected);
}

TEST_CASE("a TIFF cut after any byte is refused", "[readers]") {
  for (const char* name :
       {"tifffile_nodata.tif", "tiffcp_uint16_lzw.tif", "tiffcp_uint8_packbits.tif",
        "tiffcp_uint8_tiles.tif", "tiffcp_uint16_bigtiff.tif"}) {
    INFO(name);
    check_refused_wherever_cut(foreign_bytes(name));
  }
}

TEST_CASE("a TIFF stored in another way is refused by name", "[readers]") {
  const std::string bytes = foreign_bytes("tiffcp_uint8_packbits.tif");
  check_names(decoder_refusal(with_tag(bytes, photometric_tag, 0)), "WhiteIsZero");
  check_names(decoder_refusal(with_tag(bytes, photometric_tag, 8)), "photometric interpretation 8");
  check_names(decoder_refusal(with_tag(bytes, photometric_tag, 2)), "1 samples a pixel");
  check_names(decoder_refusal(with_tag(bytes, 274, 3)), "orientation 3");
  check_names(decoder_refusal(with_tag(bytes, compression_tag, 7)), "compression 7");
  check_names(decoder_refusal(with_tag(bytes, bits_tag, 4)), "4 bits");
  check_names(decoder_refusal(with_tag(bytes, bits_tag, 24)), "24 bits");
  const std::string floats = foreign_bytes("tifffile_float32.tif");
  check_names(decoder_refusal(with_tag(floats, sample_format_tag, 6)), "sample format 6");
  check_names(decoder_refusal(with_tag(floats, bits_tag, 16)), "16 bits");
}

TEST_CASE("a TIFF that declares more than the file can hold is refused", "[readers]") {
  const std::string grey = foreign_bytes("tifffile_uint8.tif");
  check_names(decoder_refusal(with_tag(grey, length_tag, 1000)), "17000 bytes");
  check_names(decoder_refusal(with_tag(grey, width_tag, 0)), "zero");
  check_names(decoder_refusal(with_tag(grey, length_tag, 0xFFFFFFFF)), "TIFF");
  check_names(decoder_refusal(with_tag(grey, length_tag, 1 << 28)), "17 x 268435456 pixels");
  // Few bytes a strip: a row is not filled with zeros, nor the count replaced by a guess.
  check_names(decoder_refusal(with_tag(grey, byte_counts_tag, 17 * 10)), "StripByteCounts");
  check_names(decoder_refusal(with_tag(grey, byte_counts_tag, 0)), "StripByteCounts");
  // Compressed data of too few rows: the count of bytes says nothing of it.
  const std::string deflated = foreign_bytes("tiffcp_float64_deflate.tif");
  check_names(decoder_refusal(with_tag(with_tag(deflated, length_tag, 12), 278, 12)), "row 11");
  const std::string packed = foreign_bytes("tiffcp_uint16_lzw.tif");
  check_names(decoder_refusal(with_tag(packed, length_tag, 12)), "row 11");
  const std::string tiles = foreign_bytes("tiffcp_uint8_tiles.tif");
  check_names(decoder_refusal(with_tag(tiles, 322, 1 << 20)), "tile");
}

TEST_CASE("a coloured pixel of a TIFF is refused with its place", "[readers]") {
  std::string bytes = foreign_bytes("tifffile_rgb.tif");
  const std::size_t pixels = bytes.size() - 3 * 17 * 11;
  char& green = bytes[pixels + 3 * (17 * 4 + 6) + 1];
  green = static_cast<char>(green ^ 1);
  check_names(decoder_refusal(bytes), "row 4, column 6");
}
