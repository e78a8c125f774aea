#include <array>
#include <catch2/catch.hpp>
#include <charconv>
#include <cmath>

#include "tests/cli/gratings.h"
#include "tests/cli/tables.h"

namespace {

/// The shortest decimal text of a double.
std::string shortest(double value) {
  std::array<char, 32> buffer{};
  const auto [end, ec] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  REQUIRE(ec == std::errc{});
  return {buffer.data(), end};
}

}  // namespace

TEST_CASE("the matrix layout has the angles in its header and a row per wavelength", "[cli][csv]") {
  const Scratch folder;
  make_response(folder);
  const std::string csv = folder.read("R.csv");
  const std::vector<Cells> table = table_of(csv);
  REQUIRE(table.size() == 5);
  CHECK(csv.back() == '\n');
  CHECK(csv.find('\r') == std::string::npos);
  CHECK(table[0][0] == "lambda_nm");
  CHECK(table[0][1] == "-55.0");
  CHECK(table[0].back() == "-40.0");
  const Cells wavelengths{"400", "500", "600", "700"};
  for (std::size_t row = 1; row < table.size(); ++row) {
    REQUIRE(table[row].size() == 152);
    CHECK(table[row][0] == wavelengths[row - 1]);
    for (std::size_t column = 1; column < table[row].size(); ++column) {
      const double value = value_of(table[row][column]);
      const bool is_response = std::isfinite(value) && value >= 0;
      CHECK(is_response);
      CHECK(table[row][column] == shortest(value));
    }
  }
}

TEST_CASE("the long layout has a row per cell with the texts of the matrix", "[cli][csv]") {
  const Scratch folder;
  make_response(folder);
  folder.prepare("sweep g.gsf" + small_scene + " --layout long -o long.csv");
  const std::vector<Cells> matrix = table_of(folder.read("R.csv"));
  const std::vector<Cells> table = table_of(folder.read("long.csv"));
  REQUIRE(table.size() == 1 + 4 * 151);
  CHECK(table[0] == Cells{"lambda_nm", "theta_r_deg", "value"});
  std::size_t line = 1;
  for (std::size_t row = 1; row < matrix.size(); ++row)
    for (std::size_t column = 1; column < matrix[row].size(); ++column)
      CHECK(table[line++] == Cells{matrix[row][0], matrix[0][column], matrix[row][column]});
}

TEST_CASE("peaks reads both layouts to the same table", "[cli][csv]") {
  const Scratch folder;
  make_response(folder);
  folder.prepare("sweep g.gsf" + small_scene + " --layout long -o long.csv");
  folder.prepare("peaks R.csv -o from_matrix.csv");
  folder.prepare("peaks long.csv -o from_long.csv");
  CHECK(folder.read("from_long.csv") == folder.read("from_matrix.csv"));
  CHECK(folder.shedlight("period long.csv --json").out ==
        folder.shedlight("period R.csv --json").out);
}

TEST_CASE("without an output the CSV goes to standard output and nowhere else", "[cli][csv]") {
  const Scratch folder;
  make_response(folder);
  const auto before = folder.contents();
  const Outcome outcome = folder.shedlight("sweep g.gsf" + small_scene);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  CHECK(outcome.out == folder.read("R.csv"));
  const Outcome peaks = folder.shedlight("peaks R.csv");
  CHECK(peaks.exit_code == 0);
  CHECK_THAT(peaks.out, Catch::StartsWith("lambda_nm,order,"));
  CHECK(folder.contents() == before);
}

TEST_CASE("with an output nothing is printed", "[cli][csv]") {
  const Scratch folder;
  make_response(folder);
  for (const std::string& command :
       {"sweep g.gsf" + small_scene + " -o A.csv", std::string("peaks R.csv -o B.csv"),
        std::string("plot R.csv -o C.png"), small_blaze}) {
    const Outcome outcome = folder.shedlight(command);
    INFO(command);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out == "");
    CHECK(outcome.err == "");
  }
}

TEST_CASE("the methods agree on the periodic surface", "[cli][csv][invariant]") {
  const Scratch folder;
  make_grating(folder);
  const std::string sweep = "sweep g.gsf" + small_scene + " --quantity power";
  folder.prepare(sweep + " --method direct --surface periodic -o direct.csv");
  folder.prepare(sweep + " --method taylor --tolerance 1e-9 -o taylor.csv");
  // abs(a)^2 with abs(a) <= 1 and an error of 1e-9 in a.
  const Outcome outcome = folder.shedlight("validate taylor.csv direct.csv --max-error 2e-9");
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 0);
}

TEST_CASE("relative reflectance is the power times the gain", "[cli][csv][invariant]") {
  const Scratch folder;
  make_grating(folder);
  const std::vector<Cells> power =
      table_of(folder.shedlight("sweep g.gsf" + small_scene + " --quantity power").out);
  const std::vector<Cells> relative = table_of(folder.shedlight("sweep g.gsf" + small_scene).out);
  REQUIRE(power.size() == relative.size());
  constexpr double deg = 3.14159265358979323846 / 180;
  for (std::size_t column = 1; column < power[0].size(); column += 10) {
    const double theta_i = 75 * deg, theta_r = value_of(power[0][column]) * deg;
    const double w = std::cos(theta_i) + std::cos(theta_r);
    const double gain = std::pow((1 + std::cos(theta_i - theta_r)) / w, 2) / std::cos(theta_r);
    for (std::size_t row = 1; row < power.size(); ++row)
      CHECK(value_of(relative[row][column]) ==
            Approx(gain * value_of(power[row][column])).epsilon(1e-10));
  }
}
