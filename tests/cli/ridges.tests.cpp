#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/pictures.h"
#include "tests/cli/refusal.h"
#include "tests/cli/sidecars.h"
#include "tests/cli/tables.h"

using nlohmann::json;

namespace {

const std::string light = " --theta-i 75deg --sigma 16.25um ";

/// Lobes of a window of 16.25 um at the given f [1/um] with their strengths, as CSV, written here
/// by the grating equation.
std::string response_with(const std::vector<std::pair<double, double>>& lobes) {
  constexpr double pi = 3.14159265358979323846;
  std::string csv = "lambda_nm";
  for (int i = -600; i <= -200; ++i) csv.append(",").append(std::to_string(i / 10.0));
  for (int lambda = 500; lambda <= 600; lambda += 10) {
    csv.append("\n").append(std::to_string(lambda));
    for (int i = -600; i <= -200; ++i) {
      const double f = (std::sin(75 * pi / 180) + std::sin(i / 10.0 * pi / 180)) / lambda * 1e3;
      double value = 1e-3;
      for (const auto& [at, strength] : lobes)
        value += strength * std::exp(-std::pow(2 * pi * 16.25 * (f - at), 2));
      csv.append(",").append(std::to_string(value));
    }
  }
  return csv + "\n";
}

}  // namespace

TEST_CASE("ridges are listed with period, order, strength and span", "[cli][ridges]") {
  const Scratch folder;
  folder.write("R.csv", response_with({{0.5, 1}, {0.55, 0.5}}));
  const Outcome outcome =
      folder.shedlight("ridges R.csv" + light + "-o ridges.csv --plot ridges.png");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  const std::vector<std::string> lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 3);  // two ridges, and the jumps of the brightest angle
  CHECK_THAT(lines[0], Catch::Contains("order +1") && Catch::Contains("towards the light") &&
                           Catch::Contains("100.0 %") && Catch::Contains("500 to 600 nm"));
  CHECK_THAT(lines[1], Catch::Contains("1818.") && Catch::Contains("x window"));
  check_picture(folder.read("ridges.png"));

  const std::vector<Cells> table = table_of(folder.read("ridges.csv"));
  REQUIRE(table.size() == 3);
  CHECK(table[0].front() == "number");
  for (const Cells& row : table) CHECK(row.size() == 15);
  // Cells 0.1 deg apart, interpolated linearly: hundredths of a nanometre.
  CHECK(value_of(table[1][3]) == Approx(2000).margin(0.2));
  CHECK(value_of(table[2][3]) == Approx(1000 / 0.55).margin(0.2));
  CHECK(table[1][1] == "1");
  CHECK(table[1][13] == "500-600");
  CHECK(table[1][7] == "1");
  // A point of the axis lies up to sigma_f / 12 beside the maximum: exp(-1 / 144).
  CHECK(value_of(table[2][7]) == Approx(0.5).epsilon(0.01));

  for (const std::string file : {"ridges.csv", "ridges.png"}) {
    const json sidecar = sidecar_of(folder, file);
    CHECK(sidecar.at("command") == "ridges");
    CHECK(sidecar.at("parameters").at("least_contrast") == 10);
    CHECK_FALSE(sidecar.at("parameters").contains("order"));
  }
}

TEST_CASE("ridges as JSON, with an order that is given", "[cli][ridges]") {
  const Scratch folder;
  folder.write("R.csv", response_with({{0.5, 1}, {0.55, 0.5}}));
  const Outcome outcome = folder.shedlight("ridges R.csv" + light + "--order 2 --json");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const json result = json::parse(outcome.out);
  REQUIRE(result.at("ridges").size() == 2);
  const json& first = result.at("ridges").at(0);
  CHECK(first.at("number") == 1);
  CHECK(first.at("order") == 2);
  CHECK(first.at("period_nm").get<double>() == Approx(4000).margin(0.4));
  CHECK(first.at("spans_nm") == json::parse("[[500,600]]"));
  CHECK(first.at("present") == 1);
  CHECK(result.at("brightest_track").at(0).at("jumps") == 0);
}

TEST_CASE("the response of a grating has its order as a ridge", "[cli][ridges]") {
  const Scratch folder;
  make_response(folder);
  const Outcome outcome = folder.shedlight("ridges R.csv --json");  // all else from the sidecar
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const json ridges = json::parse(outcome.out).at("ridges");
  REQUIRE(ridges.size() == 1);
  // A hundredth of the lobe's width, 0.016 1/um at 0.4: what the slope of the efficiency moves.
  CHECK(ridges.at(0).at("period_nm").get<double>() == Approx(2500).margin(1));
}

TEST_CASE("without a ridge nothing is written and the exit code is 5", "[cli][ridges][refusal]") {
  const Scratch folder;
  folder.write("flat.csv", response_with({}));
  folder.write("R.csv", response_with({{0.5, 1}}));
  const std::string output = "-o older.csv --plot ridges.png";
  check_refused(folder, "ridges flat.csv" + light + output, 5, {"flat.csv", "background", "10"});
  check_refused(folder, "ridges R.csv" + light + "--period-range 1:1.5um " + output, 5, {"R.csv"});
  folder.write("two.csv", "lambda_nm,-50,-49,-48\n500,1,2,1\n510,1,2,1\n");
  check_refused(folder, "ridges two.csv" + light + output, 5, {"two.csv", "2", "3"});
}

TEST_CASE("ridges that have no meaning are refused", "[cli][ridges][refusal]") {
  const Scratch folder;
  folder.write("R.csv", response_with({{0.5, 1}}));
  const std::string command = "ridges R.csv" + light + "-o older.csv ";
  check_refused(folder, command + "--order 0", 2, {"order 0"});
  check_refused(folder, command + "--contrast 1", 2, {"contrast 1", "> 1"});
  check_refused(folder, command + "--contrast nan", 2, {"--contrast", "nan"});
  check_refused(folder, command + "--period-guess 0um", 2, {"0"});
  check_refused(folder, command + "--refine grid", 2, {"--refine"});
  check_refused(folder, command + "--plot older.csv", 2, {"--plot", "older.csv"});
  check_refused(folder, "ridges R.csv" + light + "-o R.csv", 2, {"R.csv"});
  check_refused(folder, "ridges R.csv -o older.csv", 3, {"R.csv", "--theta-i"});
}
