#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"
#include "tests/cli/tables.h"

namespace {

using Json = nlohmann::json;

/// A response that is 1 at 0 deg, half at 10 deg, and red only at 20 deg.
std::string white_grey_red() {
  std::string csv = "lambda_nm,0,10.0,20.0\n";
  for (int nm = 380; nm <= 780; nm += 5)
    csv += std::to_string(nm) + ",1,0.5," + (nm > 640 ? "1" : "0") + "\n";
  return csv;
}

Json sidecar_of(const Scratch& folder, const std::string& file) {
  return Json::parse(folder.read(file + ".json"));
}

}  // namespace

TEST_CASE("a response becomes one colour per viewing angle", "[cli][colour]") {
  const Scratch folder;
  folder.write("R.csv", white_grey_red());
  const Outcome outcome = folder.shedlight("colour R.csv -o colours.csv");
  // Red lies outside sRGB.
  check_warned(outcome, {"R.csv", "1 of 3 colours", "srgb", "clipped"});
  CHECK(outcome.out == "");
  const std::vector<Cells> table = table_of(folder.read("colours.csv"));
  REQUIRE(table.size() == 4);
  CHECK(table[0] == Cells{"theta_r_deg", "X", "Y", "Z", "R", "G", "B"});
  for (const Cells& row : table) REQUIRE(row.size() == 7);
  CHECK(value_of(table[3][0]) == 20);
  // White of D65 and half of it: X, Y, Z of the CIE's sum, 2e-4 for the cut at 380 and 780 nm and
  // its ends; 0.5 is encoded 0.7354.
  const double white[3] = {0.95047, 1, 1.08883};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::abs(value_of(table[1][i + 1]) - white[i]) <= 2e-4);
    CHECK(std::abs(value_of(table[2][i + 1]) - white[i] / 2) <= 1e-4);
    CHECK(std::abs(value_of(table[1][i + 4]) - 1) <= 2e-4);
    CHECK(std::abs(value_of(table[2][i + 4]) - 0.73536) <= 2e-4);
  }
  CHECK(value_of(table[3][4]) > 0.2);
  CHECK(table[3][5] == "0");

  const Json sidecar = sidecar_of(folder, "colours.csv");
  CHECK(sidecar["command"] == "colour");
  const Json& p = sidecar["parameters"];
  CHECK(p["space"] == "srgb");
  CHECK(p["exposure"] == 1);
  CHECK(p["clipped"] == 1);
  CHECK(p["colours"] == 3);
  CHECK(p["illuminant"] == "D65");
  CHECK(p["first_nm"] == 380);
  CHECK(p["largest_step_nm"] == 5);
  CHECK(std::abs(p["white_xy"][0].get<double>() - 0.312721) <= 3e-5);
  CHECK(std::abs(p["white_xy"][1].get<double>() - 0.329031) <= 3e-5);
  CHECK(std::abs(p["white_xyz"][1].get<double>() - 1) <= 1e-14);
}

TEST_CASE("colours go to standard output, the count of clipped ones to standard error",
          "[cli][colour]") {
  const Scratch folder;
  folder.write("R.csv", white_grey_red());
  const Outcome outcome = folder.shedlight("colour R.csv --exposure 2");
  check_warned(outcome, {"2 of 3 colours"});  // white is too bright now
  CHECK_THAT(outcome.out, Catch::StartsWith("theta_r_deg,X,Y,Z,R,G,B\n"));
  const std::vector<Cells> once = table_of(folder.shedlight("colour R.csv").out),
                           twice = table_of(outcome.out);
  REQUIRE(once.size() == 4);
  REQUIRE(twice.size() == 4);
  // X, Y, Z are those of the response; R, G, B are exposed.
  for (std::size_t i : {1u, 2u, 3u}) CHECK(twice[2][i] == once[2][i]);
  CHECK(std::abs(value_of(twice[2][5]) - value_of(once[1][5])) <= 1e-12);
}

TEST_CASE("CIE RGB is linear and has another white", "[cli][colour]") {
  const Scratch folder;
  folder.write("R.csv", white_grey_red());
  const Outcome outcome = folder.shedlight("colour R.csv --space cie-rgb -o colours.csv");
  check_warned(outcome, {"of 3 colours", "cie-rgb"});
  const std::vector<Cells> table = table_of(folder.read("colours.csv"));
  REQUIRE(table.size() == 4);
  // White is (0.841, 1.033, 1.089), from the printed matrix over 0.17697; half of it fits.
  const double half[3] = {0.8412 / 2, 1.0334 / 2, 1.0893 / 2};
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(value_of(table[2][i + 4]) - half[i]) <= 1e-4);
  CHECK(table[1][5] == "1");
  CHECK(sidecar_of(folder, "colours.csv")["parameters"]["rgb"] == "linear");
}

TEST_CASE("the colours of a sweep are those of its relative reflectance", "[cli][colour]") {
  const Scratch folder;
  make_grating(folder);
  const std::string sweep =
      "sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.5deg --lambda 380:780:5nm -o R.csv";
  folder.prepare(sweep);
  const Outcome outcome = folder.shedlight("colour R.csv -o colours.csv");
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  const std::vector<Cells> table = table_of(folder.read("colours.csv"));
  CHECK(table.size() == 32);
  CHECK(table.at(1).at(0) == "-55.0");
  for (std::size_t row = 1; row < table.size(); ++row)
    for (std::size_t i = 4; i < 7; ++i) {
      const double component = value_of(table[row].at(i));
      CHECK((component >= 0 && component <= 1));
    }
  CHECK_THAT(sidecar_of(folder, "colours.csv")["input"]["file"].get<std::string>(),
             Catch::Contains("R.csv"));
}

TEST_CASE("quantities that have no white are refused", "[cli][colour][refusal]") {
  const Scratch folder;
  make_grating(folder);
  for (const std::string quantity : {"power", "brdf", "radiance"}) {
    folder.prepare("sweep g.gsf" + small_scene + " --quantity " + quantity + " -o R.csv");
    check_refused(folder, "colour R.csv -o older.csv", 3,
                  {"R.csv", "holds " + quantity, "sweep --quantity relative"});
  }
  // A sidecar that does not say.
  make_response(folder);
  std::string sidecar = folder.read("R.csv.json");
  sidecar.replace(sidecar.find("\"quantity\""), 10, "\"other\"");
  folder.write("R.csv.json", sidecar);
  check_refused(folder, "colour R.csv -o older.csv", 3, {"R.csv", "unknown quantity"});
  std::filesystem::remove(folder / "R.csv.json");
  CHECK(folder.shedlight("colour R.csv").exit_code == 0);
}

TEST_CASE("wavelengths without a colour are refused", "[cli][colour][refusal]") {
  const Scratch folder;
  folder.write("one.csv", "lambda_nm,0,1\n550,1,1\n");
  check_refused(folder, "colour one.csv -o older.csv", 3, {"one.csv", "1 wavelength;"});
  folder.write("dark.csv", "lambda_nm,0,1\n790,1,1\n900,1,1\n");
  check_refused(folder, "colour dark.csv -o older.csv", 3, {"dark.csv", "790 to 900 nm"});
}

TEST_CASE("wavelengths that cover the visible badly are warned of", "[cli][colour]") {
  const Scratch folder;
  folder.write("R.csv", "lambda_nm,0\n410,0.5\n420,0.5\n430,0.5\n");
  const Outcome narrow = folder.shedlight("colour R.csv");
  CHECK(narrow.exit_code == 0);
  CHECK_THAT(narrow.err, Catch::StartsWith("shedlight: warning: R.csv: wavelengths from 410 to 430 "
                                           "nm"));
  folder.write("R.csv", "lambda_nm,0\n400,0.5\n500,0.5\n600,0.5\n700,0.5\n");
  check_warned(folder.shedlight("colour R.csv"), {"R.csv", "100 nm apart", "10 nm"});
  std::string csv = "lambda_nm,0\n";
  for (int nm = 400; nm <= 700; nm += 10) csv += std::to_string(nm) + ",0.5\n";
  folder.write("R.csv", csv);
  CHECK(folder.shedlight("colour R.csv").err == "");
}

TEST_CASE("options of a colour that have no meaning are refused", "[cli][colour][refusal]") {
  const Scratch folder;
  folder.write("R.csv", white_grey_red());
  const std::string command = "colour R.csv -o older.csv ";
  check_refused(folder, command + "--space adobe", 2, {"--space", "adobe", "srgb|cie-rgb"});
  for (const std::string exposure : {"0", "-1", "nan", "inf", "two", "2nm", "1e999"})
    check_refused(folder, command + "--exposure " + exposure, 2, {"--exposure", exposure});
  check_refused(folder, "colour R.csv -o R.csv", 2, {"R.csv"});
}
