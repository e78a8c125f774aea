#include "evaluation/readers/sdf_reader.h"

#include <catch2/catch.hpp>
#include <cstdio>

#include "tests/support/damaged_files.h"
#include "tests/support/foreign_files.h"

namespace {

const std::string text_header =
    "aISO-1.0\nManufacID = test ; a remark = of nobody\nCreateDate = 290120260000\n"
    "ModDate = 290120260000\nNumPoints = 3\nNumProfiles = 2\nXscale = 5e-7\nYscale = 2.5e-7\n"
    "Zscale = 1e-9\nZresolution = -1\nCompression = 0\nDataType = 7\nCheckType = 0\n*\n";
const std::string text = text_header + "1 2.5 BAD\r\n-4\t5e1   6\n*\nComment = 1 2 3\n*\n";

std::string replaced(std::string bytes, const std::string& from, const std::string& to) {
  return bytes.replace(bytes.find(from), from.size(), to);
}

struct Foreign {
  std::string type, format;
  double lowest;  ///< of the type, which marks a missing pixel; no number where none does
};

}  // namespace

TEST_CASE("a text SDF of Gwyddion gives the digits it holds, in their places",
          "[readers][oracle]") {
  // Gwyddion's module sdfile-txt prints six digits of its heights.
  const brdf::HeightArray heights = foreign_values("heights.csv").unaryExpr([](double height) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.5e", height);
    double value = 0;
    std::from_chars(digits, digits + sizeof digits, value);
    return value;
  });
  const evaluation::RawHeights raw = decoded(foreign_file("gwyddion_text.sdf"));
  check_same_bits(raw.values, heights);
  CHECK(raw.format == "SDF, text, 32 bit float");
  CHECK(raw.pixel_x->um() == Approx(0.03333333).epsilon(1e-14));
  CHECK(raw.pixel_y->um() == Approx(0.22).epsilon(1e-14));
  CHECK(raw.unit->um() == 1e6);
}

TEST_CASE("a binary SDF gives every type to the last bit", "[readers][oracle]") {
  for (const Foreign& file : std::vector<Foreign>{{"uint8", "8 bit unsigned", no_height},
                                                  {"uint16", "16 bit unsigned", no_height},
                                                  {"uint32", "32 bit unsigned", no_height},
                                                  {"int8", "8 bit signed", -128},
                                                  {"int16", "16 bit signed", -32768},
                                                  {"int32", "32 bit signed", -2147483648.0},
                                                  {"float32", "32 bit float", no_height},
                                                  {"float64", "64 bit float", no_height}}) {
    INFO(file.type);
    brdf::HeightArray expected = foreign_values(file.type + ".csv");
    expected = (expected == file.lowest).select(no_height, expected);
    const evaluation::RawHeights raw = decoded(foreign_file("numpy_" + file.type + ".sdf"));
    check_same_bits(raw.values, expected);
    CHECK(expected.isNaN().any() == !std::isnan(file.lowest));
    CHECK(raw.format == "SDF, binary, " + file.format);
    CHECK(raw.pixel_x->um() == Approx(0.5).epsilon(1e-14));
    CHECK(raw.pixel_y->um() == Approx(0.25).epsilon(1e-14));
    CHECK(raw.unit->um() == Approx(1e-3).epsilon(1e-14));
  }
}

TEST_CASE("the lowest float marks a missing pixel of an SDF", "[readers]") {
  const brdf::HeightArray whole = foreign_values("float64.csv");
  std::string bytes = foreign_bytes("numpy_float64.sdf");
  // The first pixel behind the header of 81 bytes.
  const auto bits = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::lowest());
  for (std::size_t i = 0; i < 8; ++i) bytes[81 + i] = static_cast<char>(bits >> 8 * i);
  brdf::HeightArray expected = whole;
  expected(0, 0) = no_height;
  check_same_bits(decoded_bytes(bytes).values, expected);
}

TEST_CASE("a text SDF has comments, BAD pixels, any blanks and a trailer", "[readers]") {
  const brdf::HeightArray expected{{1, 2.5, no_height}, {-4, 50, 6}};
  for (const std::string& bytes : {text, replaced(text, "aISO-1.0", "aBCR-1.0"),
                                   replaced(text, "Xscale = 5e-7", "Xscale=5e-7 ; per point"),
                                   text_header + "1 2.5 BAD -4 50 6 *"}) {
    check_same_bits(decoded_bytes(bytes).values, expected);
  }
}

TEST_CASE("counts of a binary SDF are of 32 bit in version 2", "[readers]") {
  const std::string one = foreign_bytes("numpy_int16.sdf");
  const std::string two = "bISO-2.0" + one.substr(8, 34) + one.substr(42, 2) +
                          std::string(2, '\0') + one.substr(44, 2) + std::string(2, '\0') +
                          one.substr(46);
  check_same_bits(decoded_bytes(two).values, decoded(foreign_file("numpy_int16.sdf")).values);
}

TEST_CASE("an SDF cut before its last number ends is refused", "[readers]") {
  check_refused_wherever_cut(foreign_bytes("numpy_int8.sdf"));
  check_refused_wherever_cut(foreign_bytes("gwyddion_text.sdf"));
  // What stands behind the numbers may be lost: they are all there.
  check_refused_wherever_cut(text.substr(0, text.find('\n', text.find("5e1")) + 1));
  check_names(decoder_refusal(foreign_bytes("numpy_int8.sdf") + "x"), "269 bytes");
}

TEST_CASE("an SDF header that cannot be right is refused by name", "[readers]") {
  const auto check = [](const std::string& from, const std::string& to, const std::string& part) {
    check_names(decoder_refusal(replaced(text, from, to)), part);
  };
  check("NumPoints = 3", "NumPoints = 1000000000", "1000000000 x 2");
  check("NumPoints = 3", "NumPoints = 0", "0 x 2");
  check("NumPoints = 3", "NumPoints = -3", "NumPoints");
  check("NumPoints = 3", "NumPoints = 3.5", "NumPoints");
  check("NumPoints = 3\n", "", "NumPoints");
  check("NumPoints = 3", "NumPoints = 99999999999999999999", "NumPoints");
  check("NumPoints = 3", "NumPoints = 400", "bytes");
  check("NumPoints = 3", "NumPoints = 4", "after 6 numbers");
  check("NumPoints = 3", "NumPoints = 2", "after 4 numbers");
  check("Xscale = 5e-7", "Xscale = 0", "Xscale");
  check("Zscale = 1e-9", "Zscale = nan", "Zscale");
  check("Zscale = 1e-9", "Zscale = inf", "Zscale");
  check("Compression = 0", "Compression = 1", "Compression 1");
  check("CheckType = 0", "CheckType = 2", "CheckType 2");
  check("DataType = 7", "DataType = 8", "DataType 8");
  check("ModDate =", "ModDate", "ModDate 290120260000");
  check("5e1", "1." + std::string(70, '0'), "number 5 has 64");
  check("5e1", "5e1x", "number 5 is \"5e1x\"");
}
