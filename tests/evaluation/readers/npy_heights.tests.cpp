#include "evaluation/readers/npy_heights.h"

#include <cmath>

#include "tests/support/damaged_files.h"
#include "tests/support/foreign_files.h"

namespace {

using brdf::Length;
using evaluation::HeightChoice;

/// Heights are the numbers.
HeightChoice plain() {
  HeightChoice choice;
  choice.scale.pixel = {Length::um(1), Length::um(2)};
  choice.scale.height_unit = Length::um(1);
  return choice;
}

std::string npy(const std::string& type, const std::string& shape, const std::string& data,
                const std::string& order = "False") {
  const std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 255);
  bytes += static_cast<char>(header.size() >> 8);
  return bytes + header + data;
}

}  // namespace

TEST_CASE("arrays saved by NumPy are read to the last bit", "[npy][golden]") {
  const std::vector<double> written = foreign_numbers("heights.csv");
  const std::vector<double> codes = foreign_numbers("codes.csv");
  const auto as_float = [](double value) { return static_cast<double>(static_cast<float>(value)); };
  const auto as_it_is = [](double value) { return value; };
  struct Case {
    const char* name;
    const std::vector<double>& numbers;
    double (*stored)(double);
  };
  for (const auto& [name, numbers, stored] :
       {Case{"numpy_f8.npy", written, as_it_is}, Case{"numpy_f4.npy", written, as_float},
        Case{"numpy_big_f8.npy", written, as_it_is}, Case{"numpy_big_f4.npy", written, as_float},
        Case{"numpy_fortran.npy", written, as_it_is}, Case{"numpy_version2.npy", written, as_it_is},
        Case{"numpy_version3.npy", written, as_it_is}, Case{"numpy_i2.npy", codes, as_it_is},
        Case{"numpy_i8.npy", codes, as_it_is},
        Case{"numpy_big_u2.npy", codes, [](double value) { return value + 32768; }}}) {
    INFO(name);
    const auto read = evaluation::read_heights(foreign_file(name), plain());
    REQUIRE(read.field.rows() == 5);
    REQUIRE(read.field.cols() == 7);
    for (std::size_t i = 0; i < 35; ++i)
      CHECK(read.field.heights_um().data()[i] == stored(numbers[i]));
    CHECK(read.field.dy_um() == 2);
  }
  const auto bytes = evaluation::read_heights(foreign_file("numpy_u1.npy"), plain());
  for (int i = 0; i < 35; ++i) CHECK(bytes.field.heights_um().data()[i] == 7 * i % 256);
  CHECK(bytes.field.height_step_um() == 1);
}

TEST_CASE("an array needs its scale, whole numbers as well", "[npy]") {
  for (const char* name : {"numpy_f8.npy", "numpy_i2.npy"}) {
    INFO(name);
    HeightChoice choice;
    const std::string bytes = foreign_bytes(name);
    CHECK_THAT(refusal_of(bytes, choice), Catch::Contains("--width or --pixel"));
    choice.scale.width = Length::um(7);
    CHECK_THAT(refusal_of(bytes, choice), Catch::Contains("--height-unit"));
    choice.scale.height_range = Length::um(1);
    CHECK_THAT(refusal_of(bytes, choice), Catch::Contains("--height-range is for"));
  }
}

TEST_CASE("numbers that are none are missing", "[npy]") {
  const double row[] = {1, NAN, 3};
  const std::string bytes =
      npy("<f8", "(1, 3)", std::string(reinterpret_cast<const char*>(row), sizeof row));
  HeightChoice choice = plain();
  CHECK_THAT(refusal_of(bytes, choice), Catch::Contains("1 of 3 pixels"));
  choice.missing = evaluation::MissingHeights::neighbours;
  CHECK(read_bytes(bytes, choice).field.heights_um()(0, 1) == 2);
}

TEST_CASE("arrays that are no heights are refused", "[npy]") {
  const std::string eight(8, '\0');
  const auto refused = [](const std::string& bytes) { return refusal_of(bytes, plain()); };
  CHECK(refused(npy("<f8", "(1, 1)", eight)) == "");
  CHECK(refused(npy("<f8", "(1, 1)", eight, "True")) == "");
  for (const char* shape : {"(1, )", "(1, 1, 1)", "()"})
    CHECK_THAT(refused(npy("<f8", shape, eight)), Catch::Contains("two axes"));
  for (const char* type : {"<c8", "|b1", "<f2", "|S8", "<U2", "=f8", "f8", "|f8", "<M8[ns]"})
    CHECK_THAT(refused(npy(type, "(1, 1)", eight)),
               Catch::Contains(std::string("NPY type ") + type));
  CHECK_THAT(refused(npy("<f8", "(1, 1)", eight, "None")), Catch::Contains("fortran_order"));
  CHECK_THAT(refused(npy("<f8", "(1, 2)", eight)), Catch::Contains("truncated"));
  CHECK_THAT(refused(npy("<f8", "(1, 1)", eight + "x")), Catch::Contains("needs"));
  CHECK_THAT(refused(npy("<i8", "(1, 1)", std::string(7, '\0') + "\x40")),
             Catch::Contains("beyond 2^53"));
  CHECK_THAT(refused(npy("<f8", "(0, 1)", "")), Catch::Contains("0 pixels"));
}

TEST_CASE("an array that says more than the file holds is refused at once", "[npy][limit]") {
  // Twelve bytes: version 2, a header of 4 GB.
  const std::string twelve("\x93NUMPY\x02\x00\xFF\xFF\xFF\xFF", 12);
  for (const std::string& bytes :
       {twelve, npy("<f8", "(4294967295, 4294967295)", "x"), npy("<f8", "(16384, 16384)", "x"),
        npy("<f8", "(18446744073709551615, 2)", "x"), npy("<f8", "(99999999999999999999, 2)", "x")})
    check_cheap([&] { CHECK(refusal_of(bytes, plain()) != ""); });
}

TEST_CASE("an array is refused wherever it was cut or damaged", "[npy]") {
  for (const char* name : {"numpy_f4.npy", "numpy_version2.npy"}) {
    check_refused_wherever_cut(foreign_bytes(name));
    try_every_byte_changed(foreign_bytes(name), plain());
  }
}
