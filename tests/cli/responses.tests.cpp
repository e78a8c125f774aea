#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"

namespace {

const std::string matrix = "lambda_nm,-50,-49,-48,-47\n500,1,2,5,2\n510,1,3,6,2\n520,1,2,7,2\n";
const std::string long_table =
    "lambda_nm,theta_r_deg,value\n500,-50,1\n500,-49,2\n500,-48,1\n510,-50,1\n510,-49,3\n"
    "510,-48,1\n";

/// Every command that reads a response refuses a bad one in the same way.
void check_response_refused(const Scratch& folder, const std::string& csv,
                            const std::vector<std::string>& named) {
  folder.write("bad.csv", csv);
  folder.write("good.csv", matrix);
  for (const std::string command :
       {"peaks bad.csv --theta-i 75deg -o older.csv", "period bad.csv --theta-i 75deg",
        "plot bad.csv --theta-i 75deg -o older.csv", "colour bad.csv -o older.csv",
        "validate good.csv bad.csv --max-error 1e9"})
    check_refused(folder, command, 3, named);
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("the well-formed responses of these tests are read", "[cli][input]") {
  const Scratch folder;
  for (const std::string& csv : {matrix, long_table}) {
    folder.write("R.csv", csv);
    const Outcome outcome = folder.shedlight("peaks R.csv --theta-i 75deg");
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
  }
}

TEST_CASE("a response that is missing or empty is refused", "[cli][input]") {
  const Scratch folder;
  check_refused(folder, "peaks nowhere.csv -o older.csv", 3, {"nowhere.csv"});
  check_refused(folder, "period nowhere.csv", 3, {"nowhere.csv"});
  check_refused(folder, "plot nowhere.csv -o older.csv", 3, {"nowhere.csv"});
  check_refused(folder, "colour nowhere.csv -o older.csv", 3, {"nowhere.csv"});
  check_refused(folder, "validate nowhere.csv nowhere.csv --max-error 1", 3, {"nowhere.csv"});
  check_response_refused(folder, "", {"bad.csv", "empty"});
  check_response_refused(folder, "lambda_nm,-50,-49\n", {"bad.csv"});
  check_response_refused(folder, "lambda_nm,theta_r_deg,value\n", {"bad.csv"});
}

TEST_CASE("a cell that is no number is refused with its line and column", "[cli][input]") {
  const Scratch folder;
  for (const std::string cell : {"abc", "nan", "inf", "", "1e999", "3x", "0x1", " 3", "3 "}) {
    check_response_refused(folder, with(matrix, "510,1,3,6", "510,1," + cell + ",6"),
                           {"bad.csv", "line 3", "column 3", "\"" + cell + "\""});
    check_response_refused(folder, with(long_table, "500,-49,2", "500,-49," + cell),
                           {"bad.csv", "line 3", "column 3", "\"" + cell + "\""});
  }
  check_response_refused(folder, with(matrix, "-49", "west"), {"bad.csv", "line 1", "column 3"});
  check_response_refused(folder, with(matrix, "520", "green"), {"bad.csv", "line 4", "column 1"});
}

TEST_CASE("a row with a missing or an extra cell is refused with its line", "[cli][input]") {
  const Scratch folder;
  check_response_refused(folder, with(matrix, "510,1,3,6,2", "510,1,3,6"), {"bad.csv", "line 3"});
  check_response_refused(folder, with(matrix, "510,1,3", "510,1,1,3"), {"bad.csv", "line 3"});
  check_response_refused(folder, with(matrix, "510,1,3,6,2\n", "510,1,3,6,2\n\n"),
                         {"bad.csv", "line 4"});
  check_response_refused(folder, with(long_table, "500,-49,2", "500,-49"), {"bad.csv", "line 3"});
  check_response_refused(folder, with(long_table, "510,-49,3\n", ""), {"bad.csv", "line 6"});
  check_response_refused(folder, with(long_table, "510,-48,1\n", ""), {"bad.csv"});
}

TEST_CASE("axes that do not increase are refused with their line", "[cli][input]") {
  const Scratch folder;
  check_response_refused(folder, with(matrix, "-49", "-50"), {"bad.csv", "line 1"});
  check_response_refused(folder, with(matrix, "-49", "-51"), {"bad.csv", "line 1"});
  check_response_refused(folder, with(matrix, "510", "500"), {"bad.csv", "line 3"});
  check_response_refused(folder, with(matrix, "520", "490"), {"bad.csv", "line 4"});
  check_response_refused(folder, with(long_table, "500,-49", "500,-50"), {"bad.csv", "line 3"});
}

TEST_CASE("a response with polar angles of 90 deg or wavelengths of zero is refused",
          "[cli][input]") {
  const Scratch folder;
  check_response_refused(folder, with(matrix, "-50", "-90"), {"bad.csv", "-90"});
  check_response_refused(folder, with(matrix, "500", "0"), {"bad.csv", "0"});
}

TEST_CASE("a file that is no response is refused", "[cli][input]") {
  const Scratch folder;
  check_response_refused(folder, "lambda_nm,order,theta_peak_deg,value,period_nm\n500,1,2,3,4\n",
                         {"bad.csv", "line 1"});
  check_response_refused(folder, "wavelength,1,2\n500,1,2\n", {"bad.csv", "line 1", "lambda_nm"});
  check_response_refused(folder, "lambda_nm\n500\n", {"bad.csv", "line 1"});
  make_grating(folder);
  check_refused(folder, "peaks g.gsf --theta-i 75deg", 3, {"g.gsf"});
}

TEST_CASE("without a sidecar the option that it would give is asked for", "[cli][input]") {
  const Scratch folder;
  make_response(folder);
  std::filesystem::remove(folder / "R.csv.json");
  for (const std::string command :
       {"peaks R.csv -o older.csv", "period R.csv", "plot R.csv -o older.csv"})
    check_refused(folder, command, 3, {"R.csv", "--theta-i"});
  CHECK(folder.shedlight("period R.csv --theta-i 75deg").exit_code == 0);
}

TEST_CASE("a sidecar without the angle of incidence asks for the option", "[cli][input]") {
  const Scratch folder;
  make_response(folder);
  folder.write("R.csv.json", with(folder.read("R.csv.json"), "\"theta_i_deg\"", "\"other\""));
  check_refused(folder, "period R.csv", 3, {"R.csv", "--theta-i"});
}

TEST_CASE("a sidecar that does not belong to its response is refused", "[cli][input]") {
  const Scratch folder;
  make_response(folder);
  const std::string csv = folder.read("R.csv");
  for (const std::string command :
       {"peaks R.csv -o older.csv", "period R.csv", "plot R.csv -o older.csv",
        "period R.csv --theta-i 75deg", "colour R.csv -o older.csv"}) {
    // One other digit, or the last ones missing: the hash tells.
    for (const std::string& changed :
         {with(csv, "-55.0", "-55.1"), csv.substr(0, csv.size() - 3), csv.substr(1)}) {
      folder.write("R.csv", changed);
      check_refused(folder, command, 3, {"R.csv"});
    }
    folder.write("R.csv", with(csv, "-55.0", "-55.1"));
    check_refused(folder, command, 3, {"R.csv", "R.csv.json"});
    folder.write("R.csv", csv);
  }
}

TEST_CASE("a sidecar that cannot be understood is refused", "[cli][input]") {
  const Scratch folder;
  make_response(folder);
  const std::string sidecar = folder.read("R.csv.json");
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), std::string("{}"),
        std::string("{\"output\": 5}"), std::string("{\"output\": {\"sha256\": 5}}"),
        sidecar.substr(0, sidecar.size() / 2)}) {
    INFO(text);
    folder.write("R.csv.json", text);
    for (const std::string command : {"peaks R.csv -o older.csv", "period R.csv",
                                      "plot R.csv -o older.csv", "colour R.csv -o older.csv"})
      check_refused(folder, command, 3, {"R.csv.json"});
  }
}
