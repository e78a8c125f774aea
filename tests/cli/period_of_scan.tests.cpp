#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/periods.h"
#include "tests/cli/pictures.h"
#include "tests/cli/refusal.h"
#include "tests/cli/tables.h"
#include "tests/support/real_data.h"

using nlohmann::json;

namespace {

const std::string sinusoid =
    "synth sinusoid --period 1573nm --height 200nm --size 30um,6um --pixels 300,60 ";

}  // namespace

TEST_CASE("period of a height field gives period, interval, direction and light", "[cli][period]") {
  const Scratch folder;
  folder.prepare(sinusoid + "--direction 30deg -o g.gsf");
  const json result = period(folder, "g.gsf");
  REQUIRE(result.at("periods").size() == 1);
  const json& first = result["periods"][0];
  // Heights in single precision.
  CHECK(first.at("period_nm").get<double>() == Approx(1573).epsilon(1e-5));
  CHECK(first.at("interval_nm")[0].get<double>() <= first["period_nm"].get<double>());
  CHECK(first.at("interval_nm")[1].get<double>() >= first["period_nm"].get<double>());
  CHECK(first.at("azimuth_deg").get<double>() == Approx(30).margin(0.01));
  for (const char* side : {"light_left", "light_right"})
    CHECK(first.at(side).at("period_nm").get<double>() == Approx(1573).epsilon(1e-4));
  CHECK(first.at("agree") == true);
  CHECK_FALSE(result.contains("lattice"));
  const Outcome text = folder.shedlight("period g.gsf");
  CHECK_THAT(text.out, Catch::Contains("1  period 1573.0") && Catch::Contains("azimuth 30.0") &&
                           Catch::Contains("heights and light agree"));
}

TEST_CASE("a lattice is reported as two vectors", "[cli][period][long]") {
  const Scratch folder;
  folder.prepare(
      "synth sinusoid --period 2310nm --crossed-period 1870nm --height 200nm --size 40um "
      "--pixels 400 -o g.gsf");
  const json result = period(folder, "g.gsf");
  REQUIRE(result.contains("lattice"));
  std::vector<double> found;
  for (const json& index : result["lattice"])
    found.push_back(result["periods"][index.get<std::size_t>() - 1].at("period_nm").get<double>());
  std::sort(found.begin(), found.end());
  CHECK(found[0] == Approx(1870).epsilon(1e-4));
  CHECK(found[1] == Approx(2310).epsilon(1e-4));
}

TEST_CASE("period --around follows a grating from azimuth to azimuth", "[cli][period]") {
  const Scratch folder;
  folder.prepare(
      "synth sinusoid --period 1573nm --height 200nm --size 40um --pixels 400 --direction 20deg "
      "-o g.gsf");
  folder.prepare("period g.gsf --around around.csv --around-step 1deg --plot p.png");
  check_picture(folder.read("p.png"));
  CHECK(folder.holds("around.csv.json"));
  int seen = 0;
  const std::vector<Cells> table = table_of(folder.read("around.csv"));
  CHECK(table.at(0) == Cells{"azimuth_deg", "period_nm", "depth_nm"});
  for (std::size_t i = 1; i < table.size(); ++i) {
    const Cells& row = table[i];
    const double apart = value_of(row[0]) - 20;
    if (std::abs(apart) > 2) continue;
    ++seen;
    // The ray's point nearest to the line.
    CHECK(value_of(row[1]) ==
          Approx(1573 / std::cos(apart * 3.14159265358979 / 180)).epsilon(2e-3));
  }
  CHECK(seen == 5);
}

TEST_CASE("what cannot be told is refused with exit code 5 and no number", "[cli][period]") {
  const Scratch folder;
  folder.prepare("synth flat --noise 20nm --size 12.8um --pixels 128 -o rough.gsf");
  check_refused(folder, "period rough.gsf", 5, {"rough.gsf", "no period"});
  folder.prepare(
      "synth sinusoid --period 7.7um --height 200nm --size 30um --pixels 300 -o few.gsf");
  check_refused(folder, "period few.gsf --json", 5, {"few.gsf", "lines"});
  folder.prepare(
      "sweep rough.gsf --theta-i 30deg --theta-r -60:60:0.5deg --lambda 400:700:20nm "
      "--tolerance 1e-4 -o R.csv");
  check_refused(folder, "period R.csv --period-guess 2um", 5, {"R.csv"});
}

TEST_CASE("options of the other kind of file are refused by name", "[cli][period]") {
  const Scratch folder;
  folder.prepare(sinusoid + "-o g.gsf");
  check_refused(folder, "period g.gsf --order 1", 2, {"--order", "g.gsf"});
  check_refused(folder, "period g.gsf --by lobes", 2, {"--by", "g.gsf"});
  folder.prepare(
      "sweep g.gsf --theta-i 0deg --theta-r -60:-5:0.5deg --lambda 400:700:20nm -o R.csv");
  check_refused(folder, "period R.csv --plot p.png", 2, {"--plot", "R.csv"});
  check_refused(folder, "period R.csv --width 3um", 2, {"--width", "R.csv"});
  check_refused(folder, "period R.csv --by peaks --relief smooth", 2, {"--relief"});
  check_refused(folder, "period g.gsf --around a.csv --around-step 0deg", 2, {"--around-step"});
}

TEST_CASE("sweep --along auto lays the plane of incidence along the grating", "[cli][period]") {
  const Scratch folder;
  folder.prepare(sinusoid + "--direction 30deg -o g.gsf");
  const std::string scene =
      "sweep g.gsf --theta-i 0deg --theta-r -40:-10:0.5deg --lambda 400:700:50nm ";
  folder.prepare(scene + "--along auto -o auto.csv");
  const json sidecar = json::parse(folder.read("auto.csv.json"));
  CHECK(sidecar.at("parameters").at("phi_i_deg").get<double>() == Approx(30).margin(0.01));
  CHECK(sidecar.at("parameters").at("phi_r_deg") == sidecar.at("parameters").at("phi_i_deg"));
  check_refused(folder, scene + "--along auto --phi-i 3deg -o x.csv", 2, {"--along"});
  folder.prepare("synth flat --noise 20nm --size 12.8um --pixels 128 -o rough.gsf");
  check_refused(
      folder, "sweep rough.gsf --theta-i 0deg --theta-r -5deg --lambda 500nm --along auto -o x.csv",
      5, {"rough.gsf", "no period"});
}

TEST_CASE("real scans: period by heights, light from the left and from the right", "[cli][real]") {
  const auto data = real_data();
  if (!data) return;
  const Scratch folder;
  const auto first = [&](const std::string& name) {
    const Outcome outcome = folder.shedlight(Words{"period", (*data / name).string(), "--json"});
    REQUIRE(outcome.exit_code == 0);
    return json::parse(outcome.out).at("periods")[0];
  };
  const json grating = first("grating_317nm.gsf");
  CHECK(grating.at("interval_nm")[0].get<double>() <= 316.6);
  CHECK(grating.at("interval_nm")[1].get<double>() >= 316.6);
  CHECK(grating.at("azimuth_deg").get<double>() == Approx(45.5).margin(0.2));
  CHECK(grating.at("agree") == true);
}

TEST_CASE("a rough scan as text has no period", "[cli][period][real]") {
  const auto data = real_data();
  if (!data) return;
  const Scratch folder;
  const std::string file = (*data / "rough_matrix.txt").string();
  check_refused(folder, words("period") + file, 5, {"rough_matrix.txt", "no period"});
}
