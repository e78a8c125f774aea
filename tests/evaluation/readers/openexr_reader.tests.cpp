#include "evaluation/readers/openexr_reader.h"

#include <catch2/catch.hpp>

#include "tests/support/damaged_files.h"
#include "tests/support/foreign_files.h"

namespace {

/// One channel of a file of OpenEXR's tools, and its values.
struct Foreign {
  std::string name;
  std::optional<std::string> wanted;
  std::string channel, values, format;
};

}  // namespace

TEST_CASE("OpenEXR files of its own tools give their values to the last bit", "[readers][oracle]") {
  const std::string half = "OpenEXR, 16 bit float", single = "OpenEXR, 32 bit float";
  for (const Foreign& file : std::vector<Foreign>{
           // The data window begins at (-3, 40).
           {"exrstdattr_float32.exr", {}, "Z", "float32.csv", single},
           {"exrmaketiled_zip.exr", {}, "Z", "float16.csv", single},
           {"exrmaketiled_piz.exr", "Z", "Z", "float16.csv", single},
           {"exrstdattr_channels.exr", {}, "Y", "float32.csv", single},
           {"exrstdattr_channels.exr", "R", "R", "float16.csv", half},
           {"exrstdattr_channels.exr", "1", "R", "float16.csv", half},
           {"exrstdattr_channels.exr", "code", "code", "uint32.csv", "OpenEXR, 32 bit unsigned"}}) {
    INFO(file.name << " " << file.channel);
    const evaluation::RawHeights raw = decoded(foreign_file(file.name), request_for(file.wanted));
    check_same_bits(raw.values, foreign_values(file.values));
    CHECK(raw.channel == file.channel);
    CHECK(raw.format == file.format);
    CHECK(!raw.unit);
    CHECK(!raw.pixel_x);
  }
  CHECK(evaluation::listed(decoded(foreign_file("exrstdattr_channels.exr")).channels) ==
        "1 \"R\" (no unit), 2 \"Y\" (no unit), 3 \"code\" (no unit)");
}

TEST_CASE("codes of an OpenEXR file are a unit apart, halves a thousandth", "[readers]") {
  const std::filesystem::path file = foreign_file("exrstdattr_channels.exr");
  CHECK(decoded(file, request_for("code")).step == 1);
  CHECK(decoded(file, request_for("R")).step ==
        foreign_values("float16.csv").abs().maxCoeff() / 1024);
}

TEST_CASE("lines of an OpenEXR file may come from the bottom up", "[readers]") {
  // Without compression each of the 11 lines has 8 + 4 * 17 bytes, at the end of the file.
  constexpr std::size_t rows = 11, line = 8 + 4 * 17;
  const std::string bytes = foreign_bytes("exrstdattr_float32.exr");
  const std::size_t table = bytes.size() - rows * (line + 8);
  std::string turned = bytes.substr(0, table);
  const std::string order = std::string("lineOrder") + '\0' + '\1' + std::string(3, '\0');
  turned[turned.find(order) + order.size()] = 1;
  for (std::size_t row = 0; row < rows; ++row)
    turned += bytes.substr(table + 8 * (rows - 1 - row), 8);
  for (std::size_t row = rows; row-- > 0;)
    turned += bytes.substr(table + 8 * rows + line * row, line);
  check_same_bits(decoded_bytes(turned).values, foreign_values("float32.csv"));
}

TEST_CASE("an OpenEXR file cut after any byte is refused", "[readers]") {
  for (const char* name :
       {"exrstdattr_float32.exr", "exrmaketiled_zip.exr", "exrmaketiled_piz.exr"}) {
    INFO(name);
    check_refused_wherever_cut(foreign_bytes(name));
  }
}

TEST_CASE("an OpenEXR file of another kind is refused by name", "[readers]") {
  check_names(decoder_refusal(foreign_bytes("exrmaketiled_mipmap.exr")), "several levels");
  check_names(decoder_refusal(foreign_bytes("exrmultipart_two.exr")), "several parts");
  std::string bytes = foreign_bytes("exrstdattr_float32.exr");
  bytes[5] = 0x08;
  check_names(decoder_refusal(bytes), "deep");
  bytes = foreign_bytes("exrstdattr_float32.exr");
  // The sampling of the only channel, at the end of its entry.
  bytes[bytes.find("Z") + 10] = 2;
  check_names(decoder_refusal(bytes), "not sampled at every pixel");
}

TEST_CASE("a channel of an OpenEXR file is chosen, not guessed", "[readers]") {
  const std::string bytes = foreign_bytes("exrstdattr_channels.exr");
  for (const char* channel : {"Z", "0", "4", "-1", "", "r"})
    check_names(decoder_refusal(bytes, request_for(channel)),
                "there are 1 \"R\" (no unit), 2 \"Y\" (no unit), 3 \"code\"");
  const auto renamed = [&](char from, char to) {
    std::string other = bytes;
    other[other.find(std::string(1, from) + '\0')] = to;
    return decoder_refusal(other);
  };
  CHECK(renamed('R', 'H') == "");
  // No channel of a height's usual names, and two.
  check_names(renamed('Y', 'X'), "give --channel; there are 1 \"R\" (no unit), 2 \"X\"");
  check_names(renamed('R', 'Z'), "give --channel; there are 1 \"Y\" (no unit), 2 \"Z\"");
}
