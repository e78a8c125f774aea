// The figures that the sources' repository records, reproduced by --preset thesis.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "brdf/grating_equation.h"
#include "tests/cli/program.h"
#include "tests/cli/tables.h"

using brdf::Angle;
using brdf::Length;
using nlohmann::json;

namespace {

const std::string blaze =
    "synth blazed --period 2500nm --height 150nm --size 65um --pixels 650 -o g.gsf";

}  // namespace

TEST_CASE("the grating equation on the angle grid gives the recorded mean and spread",
          "[thesis][oracle]") {
  std::vector<double> periods_nm;
  for (int lambda_nm = 380; lambda_nm <= 780; ++lambda_nm) {
    const Length wavelength = Length::nm(lambda_nm);
    const auto exact = brdf::viewing_angle(1, Length::nm(2500), wavelength, Angle::deg(75));
    REQUIRE(exact);
    const Angle on_grid = Angle::deg(std::round(exact->deg() * 100) / 100);
    const auto period = brdf::period_from_angle(1, wavelength, Angle::deg(75), on_grid);
    REQUIRE(period);
    periods_nm.push_back(period->nm());
  }
  double mean = 0, squares = 0;
  for (const double period : periods_nm) mean += period / static_cast<double>(periods_nm.size());
  for (const double period : periods_nm) squares += (period - mean) * (period - mean);
  const double deviation = std::sqrt(squares / static_cast<double>(periods_nm.size() - 1));
  // To the digits given; 401 sums of 2500 round to 1e-10.
  CHECK(mean == Approx(2499.9974453586824).margin(1e-9).epsilon(0));
  CHECK(deviation == Approx(0.37726655).margin(5e-9).epsilon(0));
}

TEST_CASE("the thesis preset reproduces the recorded period of the blazed grating",
          "[cli][thesis][golden]") {
  const Scratch folder;
  folder.prepare(blaze);
  folder.prepare(
      "sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.01deg --lambda 380:780:1nm "
      "--preset thesis -o R.csv");
  const Outcome outcome = folder.shedlight("period R.csv --order 1 --json");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const json result = json::parse(outcome.out);
  CHECK(result.at("source_mean_nm").get<double>() == Approx(2499.997).margin(0.01).epsilon(0));
  CHECK(result.at("source_std_nm").get<double>() == Approx(0.377).margin(0.01).epsilon(0));
  CHECK(result.at("wavelengths_with_peak") == 401);
}

TEST_CASE("the matrix of the thesis preset equals the direct periodic sum",
          "[cli][thesis][oracle]") {
  const Scratch folder;
  folder.prepare(blaze);
  // 100 cells over the whole of the recorded sweep.
  const std::string sweep =
      "sweep g.gsf --theta-i 75deg --theta-r -55:-41.5:1.5deg "
      "--lambda 380:740:40nm --preset thesis";
  folder.prepare(sweep + " -o taylor.csv");
  folder.prepare(sweep + " --method direct -o direct.csv");
  const std::vector<Cells> taylor = table_of(folder.read("taylor.csv"));
  const std::vector<Cells> direct = table_of(folder.read("direct.csv"));
  REQUIRE(taylor.size() == 11);
  REQUIRE(direct.size() == 11);
  for (std::size_t row = 1; row < 11; ++row)
    for (std::size_t column = 1; column < 11; ++column) {
      const double a = std::sqrt(value_of(taylor[row][column]));
      const double b = std::sqrt(value_of(direct[row][column]));
      INFO(direct[row][0] << " nm, " << direct[0][column] << " deg");
      // The window's tail beyond 4 sigma_f: 1e-3 of the flat patch's peak.
      CHECK(a == Approx(b).margin(1e-3).epsilon(0));
    }
}

TEST_CASE("what is given beside the thesis preset stays as given", "[cli][thesis]") {
  const Scratch folder;
  folder.prepare(blaze);
  folder.prepare(
      "sweep g.gsf --theta-i 75deg --theta-r -50deg --lambda 500nm --preset thesis "
      "--sigma 10um --window-radius 5 --quantity relative --level none -o R.csv");
  const json p = json::parse(folder.read("R.csv.json")).at("parameters");
  CHECK(p.at("preset") == "thesis");
  CHECK(p.at("sigma_um").get<double>() == Approx(10));
  CHECK(p.at("window_radius_sigma_f") == 5.0);
  CHECK(p.at("quantity") == "relative");
  CHECK(p.at("level") == "none");
}
