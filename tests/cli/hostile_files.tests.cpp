#include "tests/cli/hostile_files.h"

using namespace std::string_literals;

namespace {

/// A tag of a TIFF with one value.
struct Tag {
  unsigned tag;
  std::uint64_t value;
};

/// A classic TIFF of 236 bytes with one directory.
std::string tiff(std::vector<Tag> tags) {
  std::ranges::sort(tags, {}, &Tag::tag);
  std::string bytes = "II*" + std::string(1, '\0') + little_endian(8, 4);
  bytes += little_endian(tags.size(), 2);
  constexpr int unsigned_long = 4;
  for (const Tag& tag : tags)
    bytes += little_endian(tag.tag, 2) + little_endian(unsigned_long, 2) + little_endian(1, 4) +
             little_endian(tag.value, 4);
  bytes.resize(236);
  return bytes;
}

/// Grey, at offset 150 with 80 bytes of data.
std::string grey_tiff(std::uint64_t cols, std::uint64_t rows, unsigned bits, unsigned compression,
                      std::vector<Tag> more) {
  more.insert(more.end(), {{256, cols}, {257, rows}, {258, bits}, {259, compression}, {262, 1}});
  return tiff(std::move(more));
}

constexpr unsigned uncompressed = 1, lzw = 5, deflate = 8;
const std::vector<Tag> one_strip{{273, 150}, {279, 80}};

std::vector<Tag> tiles_of(std::uint64_t width, std::uint64_t length) {
  return {{322, width}, {323, length}, {324, 150}, {325, 80}};
}

/// An attribute of an OpenEXR header.
std::string attribute(const std::string& name, const std::string& type, const std::string& value) {
  return name + '\0' + type + '\0' + little_endian(value.size(), 4) + value;
}

/// An OpenEXR header of one float channel with its first pixel at 0, without any line.
std::string openexr(std::uint64_t last_col, std::uint64_t last_row, int compression,
                    const std::string& more = "", std::uint64_t version = 2) {
  constexpr int float_type = 2;
  const std::string window =
      std::string(8, '\0') + little_endian(last_col, 4) + little_endian(last_row, 4);
  const std::string channel = "Z" + std::string(1, '\0') + little_endian(float_type, 4) +
                              std::string(4, '\0') + little_endian(1, 4) + little_endian(1, 4);
  const std::string one = "\0\0\x80\x3f"s;
  return "\x76\x2f\x31\x01" + little_endian(version, 4) +
         attribute("channels", "chlist", channel + '\0') +
         attribute("compression", "compression", std::string(1, static_cast<char>(compression))) +
         attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window) +
         attribute("lineOrder", "lineOrder", "\0"s) + attribute("pixelAspectRatio", "float", one) +
         attribute("screenWindowCenter", "v2f", std::string(8, '\0')) +
         attribute("screenWindowWidth", "float", one) + more + '\0';
}

/// The beginning of a Gwyddion file of four gigabytes: one channel, whose numbers fill the rest.
std::string gwyddion(std::uint64_t cols, std::uint64_t rows) {
  constexpr std::uint64_t size = std::uint64_t{4} << 30;
  const auto text = [](const std::string& characters) { return characters + '\0'; };
  // An object reaches to the end of the file; `before` are the bytes that stand before it.
  const auto object = [&](const std::string& before, const std::string& type) {
    const std::string named = before + text(type);
    return named + little_endian(size - named.size() - 4, 4);
  };
  std::string bytes = object("GWYP", "GwyContainer");
  bytes = object(bytes + text("/0/data") + 'o', "GwyDataField");
  bytes +=
      text("xres") + 'i' + little_endian(cols, 4) + text("yres") + 'i' + little_endian(rows, 4);
  // The numbers begin at a multiple of their size.
  const std::string data = text("data") + 'D';
  const std::string flag = text("") + 'b' + '\1';
  const std::uint64_t behind = bytes.size() + flag.size() + data.size() + 4;
  bytes += std::string((8 - behind % 8) % 8, 'x') + flag + data;
  return bytes + little_endian((size - bytes.size() - 4) / 8, 4);
}

}  // namespace

TEST_CASE("a TIFF of 236 bytes that declares 40 GB is refused at once", "[cli][hostile]") {
  const Scratch folder;
  const auto check = [&](const std::string& bytes) {
    folder.write("bomb.tif", bytes);
    check_cheaply_refused(folder, "bomb.tif");
  };
  check(grey_tiff(100000, 100000, 32, uncompressed, one_strip));
  CHECK(std::filesystem::file_size(folder / "bomb.tif") == 236);
  check(grey_tiff(100000, 100000, 32, deflate, one_strip));
  check(grey_tiff(0xFFFFFFFF, 0xFFFFFFFF, 64, lzw, one_strip));
  // Within the limit of pixels, not within what 80 bytes can hold.
  for (const unsigned compression : {uncompressed, lzw, deflate, 50000u}) {
    check(grey_tiff(1 << 14, 1 << 14, 32, compression, one_strip));
    check(grey_tiff(1 << 28, 1, 32, compression, one_strip));
    check(grey_tiff(8, 8, 32, compression, tiles_of(1 << 14, 1 << 14)));
    check(grey_tiff(1 << 14, 1 << 14, 32, compression, tiles_of(16, 16)));
  }
  // A table of a strip for each row.
  check(grey_tiff(1, 1 << 28, 8, deflate, {{273, 150}, {278, 1}, {279, 80}}));
}

TEST_CASE("a large file that begins as a TIFF is not read whole to be refused", "[cli][hostile]") {
  const Scratch folder;
  for (const unsigned compression : {uncompressed, lzw, deflate}) {
    folder.write("long.tif", grey_tiff(1 << 20, 1 << 20, 32, compression, one_strip));
    stretch(folder, "long.tif");
    check_cheaply_refused(folder, "long.tif");
    // Now the bytes would suffice, but the strip has not as many.
    folder.write("long.tif", grey_tiff(1 << 14, 1 << 14, 32, compression, one_strip));
    stretch(folder, "long.tif");
    check_cheaply_refused(folder, "long.tif");
  }
}

TEST_CASE("an SDF that declares 10^9 x 10^9 pixels is refused at once", "[cli][hostile]") {
  const Scratch folder;
  const auto sdf = [](const std::string& cols, const std::string& rows) {
    return "aISO-1.0\nNumPoints = " + cols + "\nNumProfiles = " + rows +
           "\nXscale = 1e-6\nYscale = 1e-6\nZscale = 1e-6\nCompression = 0\nDataType = 7\n"
           "CheckType = 0\n*\n1 2 3 4\n*\n";
  };
  for (const std::string& bytes :
       {sdf("1000000000", "1000000000"), sdf("4294967296", "4294967296"), sdf("16384", "16384"),
        "bISO-2.0" + std::string(34, ' ') + std::string(8, '\xFF') + std::string(40, '?')}) {
    folder.write("bomb.sdf", bytes);
    check_cheaply_refused(folder, "bomb.sdf");
    stretch(folder, "bomb.sdf");
    check_cheaply_refused(folder, "bomb.sdf");
  }
}

TEST_CASE("an OpenEXR file that declares more than it holds is refused at once", "[cli][hostile]") {
  const Scratch folder;
  const auto check = [&](const std::string& bytes) {
    folder.write("bomb.exr", bytes);
    check_cheaply_refused(folder, "bomb.exr");
  };
  constexpr int none = 0, zip = 3, dwaa = 8;
  for (const int compression : {none, zip, dwaa}) {
    check(openexr(99999, 99999, compression));
    check(openexr(0x7FFFFFFE, 0x7FFFFFFE, compression));
    check(openexr((1 << 14) - 1, (1 << 14) - 1, compression));
    check(openexr((1 << 28) - 1, 0, compression));
    check(openexr(0, (1 << 28) - 1, compression));
  }
  check(openexr(0xFFFFFFFF, 5, none));
  // Attributes longer than the file: a text, which the library would fill with zeros, and a list.
  for (const char* type : {"string", "chlist", "preview", "stringvector", "unknown"})
    check(openexr(3, 3, none, "more\0"s + type + '\0' + little_endian(0x7FFFFFF0, 4)));
  constexpr std::uint64_t tiled = 0x202;
  const auto tiles = [](std::uint64_t width, std::uint64_t length) {
    return attribute("tiles", "tiledesc",
                     little_endian(width, 4) + little_endian(length, 4) + "\0"s);
  };
  check(openexr(7, 7, zip, tiles(1 << 14, 1 << 14), tiled));
  check(openexr(7, 7, zip, tiles(0x7FFFFFFF, 0x7FFFFFFF), tiled));
  check(openexr((1 << 14) - 1, (1 << 14) - 1, dwaa, tiles(1, 1), tiled));
  check(openexr(7, 7, zip, tiles(0, 0), tiled));
}

TEST_CASE("a large file that begins as OpenEXR is not read whole to be refused", "[cli][hostile]") {
  const Scratch folder;
  for (const std::string& bytes :
       {openexr(99999, 99999, 0), openexr((1 << 14) - 1, (1 << 14) - 1, 0),
        openexr((1 << 28) - 1, 0, 0), openexr(0, (1 << 28) - 1, 0)}) {
    folder.write("long.exr", bytes);
    stretch(folder, "long.exr");
    check_cheaply_refused(folder, "long.exr");
  }
}

TEST_CASE("a Gwyddion file is not read whole to be refused", "[cli][hostile]") {
  const Scratch folder;
  const auto check = [&](const std::string& bytes, const std::string& part) {
    folder.write("long.gwy", bytes);
    stretch(folder, "long.gwy");
    CHECK_THAT(check_cheaply_refused(folder, "long.gwy"), Catch::Contains(part));
  };
  check(gwyddion(1 << 15, 1 << 14), "32768 x 16384 pixels, must be from 1 to 268435456");
  check(gwyddion(1 << 14, 1 << 14), "16384 x 16384 pixels need 268435456");
  check("GWYP" + std::string(300'000, 'x'), "a text is longer than 65536 bytes");
  check("GWYP" + std::string(100'000, 'x'), "a name has 100000 bytes");
}
