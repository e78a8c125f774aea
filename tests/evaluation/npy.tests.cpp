#include "evaluation/npy.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <limits>

#include "evaluation/sha256.h"
#include "tests/support/is_error.h"
#include "tests/support/temporary_folder.h"

namespace {

using brdf::Errc;
using evaluation::NpyType;
using evaluation::read_npy;

constexpr std::size_t limit = 1 << 20;

std::string npy(std::string header, const std::string& data) {
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 255);
  bytes += static_cast<char>(header.size() >> 8);
  return bytes + header + data;
}

std::string bytes_of(const std::vector<double>& numbers) {
  return std::string(evaluation::npy_bytes(numbers));
}

std::string header_of(const std::string& shape, const std::string& descr = "<f8") {
  return "{'descr': '" + descr + "', 'fortran_order': False, 'shape': " + shape + ", }";
}

}  // namespace

TEST_CASE("the header is the one that NumPy writes", "[npy][golden]") {
  // numpy.save of a 2 x 3 array of float64, NumPy 1.24: 118 bytes of header behind the prefix
  // of 10.
  const std::string expected = std::string("\x93NUMPY\x01\x00\x76\x00", 10) +
                               "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }" +
                               std::string(58, ' ') + "\n";
  CHECK(evaluation::npy_header({NpyType::real, {2, 3}}) == expected);
  CHECK(evaluation::npy_header({NpyType::complex_value, {7}}).find("'<c16'") != std::string::npos);
  CHECK(evaluation::npy_header({NpyType::single, {7}}).find("'<f4'") != std::string::npos);
  CHECK(evaluation::npy_header({NpyType::real, {7}}).find("(7, )") != std::string::npos);
}

TEST_CASE("what is written reads back the same, with the hash of the file", "[npy][invariant]") {
  const std::vector<std::complex<double>> numbers{{1, -2}, {0.1, 1e-300}, {-0.0, 3},
                                                  {4, 5},  {6, 7},        {8, 9}};
  const std::string bytes = evaluation::npy_header({NpyType::complex_value, {2, 1, 3}}) +
                            std::string(evaluation::npy_bytes(numbers));
  const TemporaryFolder folder;
  const auto path = folder.write("file.npy", bytes);
  const auto read = read_npy(path, limit);
  CHECK(read.shape.type == NpyType::complex_value);
  CHECK(read.shape.extents == std::vector<std::size_t>{2, 1, 3});
  REQUIRE(read.numbers.size() == 12);
  CHECK(std::memcmp(read.numbers.data(), numbers.data(), 12 * sizeof(double)) == 0);
  CHECK(read.sha256 == evaluation::sha256_hex(bytes));
}

TEST_CASE("numbers of 4 bytes are read as they are, from any place, and as nothing else",
          "[npy][invariant]") {
  using Limits = std::numeric_limits<float>;
  const std::vector<float> numbers{
      1, -0.0f, 0.1f, Limits::max(), Limits::denorm_min(), 1e-3f, Limits::lowest()};
  const std::string bytes =
      evaluation::npy_header({NpyType::single, {7}}) + std::string(evaluation::npy_bytes(numbers));
  const TemporaryFolder folder;
  const auto path = folder.write("file.npy", bytes);
  const evaluation::NpyReader reader(path);
  CHECK(reader.shape().type == NpyType::single);
  CHECK(reader.shape().extents == std::vector<std::size_t>{7});
  REQUIRE(reader.size() == 7);
  CHECK(reader.sha256() == evaluation::sha256_hex(bytes));
  std::vector<float> all(7), some(3);
  reader.read(0, std::span(all));
  CHECK(std::memcmp(all.data(), numbers.data(), 7 * sizeof(float)) == 0);
  reader.read(4, std::span(some));
  CHECK(std::memcmp(some.data(), numbers.data() + 4, 3 * sizeof(float)) == 0);
  std::vector<double> doubles(3);
  CHECK_ERROR(reader.read(0, std::span(doubles)), Errc::bad_input, "numbers of 4 bytes, not 8");
  CHECK_ERROR(reader.read(5, std::span(some)), Errc::bad_input, "cannot be read");
  reader.read(0, std::span(all));  // and is good again behind it
  CHECK(all == numbers);
}

TEST_CASE("numbers of 4 bytes that are none, or numbers of 8 bytes, are not read as floats",
          "[npy]") {
  const auto refused = [](const std::string& bytes, const char* part) {
    const TemporaryFolder folder;
    const auto path = folder.write("file.npy", bytes);
    const evaluation::NpyReader reader(path);
    std::vector<float> numbers(3);
    CHECK_ERROR(reader.read(0, std::span(numbers)), Errc::bad_input, part);
  };
  using Limits = std::numeric_limits<float>;
  for (const float none : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()})
    refused(npy(header_of("(3, )", "<f4"),
                std::string(evaluation::npy_bytes(std::vector<float>{1, 2, none}))),
            "number 2 is not finite");
  refused(npy(header_of("(3, )"), bytes_of({1, 2, 3})), "numbers of 8 bytes, not 4");
}

TEST_CASE("files that are no such array are refused before memory is taken", "[npy]") {
  const std::string six = bytes_of({1, 2, 3, 4, 5, 6});
  const auto refused = [](const std::string& bytes, const char* part, Errc code = Errc::bad_input) {
    CAPTURE(part);
    const TemporaryFolder folder;
    const auto path = folder.write("file.npy", bytes);
    CHECK_ERROR(read_npy(path, limit), code, part);
  };
  refused("", "not NPY");
  refused("GIF89a and so on, long enough", "not NPY");
  refused(std::string("\x93NUMPY\x02\x00\x10\x00\x00\x00", 12), "cut off");
  refused(std::string("\x93NUMPY\x02\x00\x00\x00\x00\xFF", 12), "at most 32768");
  refused(std::string("\x93NUMPY\x04\x00\x10\x00", 10), "not NPY");
  refused(npy(header_of("(2, 3)"), six).substr(0, 40), "cut off");
  refused(npy(header_of("(2, 3)", "<f2"), six), "'<f2'");
  refused(npy(header_of("(2, 3)", "<f4"), six), "does not match");
  refused(npy(header_of("(2, 6)", "<f4"), six), "numbers of 4 bytes");
  refused(npy(header_of("(2, 3)", ">f8"), six), "'>f8'");
  refused(npy("{'fortran_order': False, 'shape': (2, 3), }", six), "missing");
  refused(npy("{'descr': '<f8', 'fortran_order': True, 'shape': (2, 3), }", six), "C order");
  refused(npy("{'descr': '<f8', 'fortran_order': False, }", six), "shape");
  refused(npy(header_of("(2, -3)"), six), "whole numbers");
  refused(npy(header_of("(2, x)"), six), "whole numbers");
  refused(npy(header_of("[2, 3]"), six), "whole numbers");
  refused(npy(header_of("(2, 4)"), six), "does not match");
  refused(npy(header_of("(2, 3)"), six.substr(1)), "does not match");
  refused(npy(header_of("(4294967296, 4294967296)"), six), "does not match");
  refused(npy(header_of("(99999999999999999999, 2)"), six), "whole numbers");
  refused(npy(header_of("(1, 200000)"), std::string(1600000, '\0')), "at most", Errc::over_limit);
  refused(npy(header_of("(2, )"), bytes_of({1, std::numeric_limits<double>::quiet_NaN()})),
          "number 1 is not finite");
  CHECK_ERROR(read_npy("/nonexistent.npy", limit), Errc::bad_input, "no such file");
}
