// The figures that the sources' repository records, reproduced by --preset thesis.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "tests/cli/program.h"
#include "tests/cli/tables.h"

using nlohmann::json;

namespace {

const std::string blaze =
    "synth blazed --period 2500nm --height 150nm --size 65um --pixels 650 -o g.gsf";

}  // namespace

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
