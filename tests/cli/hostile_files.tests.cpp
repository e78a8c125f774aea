#include "tests/cli/hostile_files.h"

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
