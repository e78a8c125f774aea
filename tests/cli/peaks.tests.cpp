#include <catch2/catch.hpp>
#include <cmath>

#include "tests/cli/refusal.h"
#include "tests/cli/tables.h"

namespace {

std::vector<Cells> peaks(const Scratch& folder, const std::string& options) {
  const Outcome outcome = folder.shedlight("peaks R.csv --theta-i 75deg " + options);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return table_of(outcome.out);
}

double sine(double degrees) {
  return std::sin(degrees * 3.14159265358979323846 / 180);
}

const std::string response =
    "lambda_nm,-50,-49,-48,-47,-46\n"
    "500,9,2,3,2,1\n"   // the brightest on the left edge
    "510,1,2,5,2,1\n"   // inside
    "520,1,2,3,4,8\n"   // on the right edge
    "530,1,5,2,2,1\n"   // inside, next to the edge
    "540,3,3,3,3,3\n"   // nowhere
    "550,0,0,0,0,0\n";  // dark

}  // namespace

TEST_CASE("peaks have a row per wavelength, empty where the maximum is on the edge",
          "[cli][peaks]") {
  const Scratch folder;
  folder.write("R.csv", response);
  const std::vector<Cells> table = peaks(folder, "--order 1 --refine grid");
  REQUIRE(table.size() == 7);
  CHECK(table[0] == Cells{"lambda_nm", "order", "theta_peak_deg", "value", "period_nm"});
  CHECK(table[1] == Cells{"500", "1", "", "", ""});
  CHECK(table[3] == Cells{"520", "1", "", "", ""});
  CHECK(table[5] == Cells{"540", "1", "", "", ""});
  CHECK(table[6] == Cells{"550", "1", "", "", ""});
  for (const auto& [row, lambda, theta] : {std::tuple{2, 510, -48}, std::tuple{4, 530, -49}}) {
    const Cells& cells = table[static_cast<std::size_t>(row)];
    REQUIRE(cells.size() == 5);
    CHECK(cells[0] == std::to_string(lambda));
    CHECK(value_of(cells[2]) == theta);
    CHECK(cells[3] == "5");
    // d = m lambda / (sin theta_i + sin theta_r), to rounding.
    CHECK(value_of(cells[4]) == Approx(lambda / (sine(75) + sine(theta))).epsilon(1e-13));
  }
}

TEST_CASE("a refined peak lies between the cells beside the brightest one", "[cli][peaks]") {
  const Scratch folder;
  // A Gaussian over sin theta_r centred off the grid: a parabola of the logarithms finds it.
  constexpr double centre_deg = -47.8;
  std::string csv = "lambda_nm,-50,-49,-48,-47,-46\n500";
  for (const double theta : {-50.0, -49.0, -48.0, -47.0, -46.0})
    csv += "," + std::to_string(std::exp(-std::pow((sine(theta) - sine(centre_deg)) / 0.02, 2)));
  folder.write("R.csv", csv + "\n");
  const std::vector<Cells> table = peaks(folder, "");
  // std::to_string keeps six digits of values around 0.1 to 1: 1e-5 of a step of 1 deg.
  CHECK(value_of(table[1][2]) == Approx(centre_deg).margin(1e-4));
}

TEST_CASE("a window, a guess and a range of periods narrow the search", "[cli][peaks]") {
  const Scratch folder;
  folder.write("R.csv", response);
  CHECK(peaks(folder, "--refine grid --window -50:-48deg")[4][2] == "-49");
  CHECK(peaks(folder, "--refine grid --window -49:-46deg")[4][2] == "");
  // The maximum of 530 nm gives a period of 2509 nm.
  CHECK(peaks(folder, "--refine grid --period-guess 2500nm")[4][2] == "-49");
  CHECK(peaks(folder, "--refine grid --period-range 2.3:2.8um")[4][2] == "-49");
  CHECK(peaks(folder, "--refine grid --period-range 1.1:1.3um")[4][2] == "");
}

TEST_CASE("an order on the other side of the mirror direction has no peak here", "[cli][peaks]") {
  const Scratch folder;
  folder.write("R.csv", response);
  for (const std::string order : {"-1", "-2"}) {
    const std::vector<Cells> table = peaks(folder, "--order " + order);
    for (std::size_t row = 1; row < table.size(); ++row) {
      CHECK(table[row][1] == order);
      CHECK(table[row][2] == "");
    }
  }
}

TEST_CASE("searches that have no meaning are refused", "[cli][peaks]") {
  const Scratch folder;
  folder.write("R.csv", response);
  const std::string command = "peaks R.csv --theta-i 75deg -o older.csv ";
  check_refused(folder, command + "--period-range 1.3:1.1um", 2, {"--period-range", "1.3:1.1um"});
  check_refused(folder, command + "--period-range 1.3um", 2, {"--period-range", "1.3um"});
  check_refused(folder, command + "--period-range 0:1um", 2, {"0"});
  check_refused(folder, command + "--window -40:-50deg", 2, {"--window", "-40:-50deg"});
  for (const std::string interval : {":", "-50:-40deg:", ":-40deg", "-50:deg", "-50:-45:-40deg"})
    check_refused(folder, command + "--window " + interval, 2, {"--window", interval});
  check_refused(folder, command + "--order 1.5", 2, {"--order", "1.5"});
  check_refused(folder, command + "--order one", 2, {"--order", "one"});
  check_refused(folder, command + "--order 1deg", 2, {"--order", "1deg"});
}
