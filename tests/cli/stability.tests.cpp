#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/refusal.h"

TEST_CASE("the stability table is printed, written and drawn, and nothing in it fails",
          "[cli][stability]") {
  const Scratch folder;
  const Outcome outcome = folder.shedlight("stability -o s.csv --plot s.png --json");
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  const auto rows = nlohmann::json::parse(outcome.out);
  const std::string csv = folder.read("s.csv");
  CHECK(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')) == rows.size() + 1);
  CHECK_THAT(csv, Catch::StartsWith("subject,range,unit,worst,where,limit,reason,"));
  std::size_t refused = 0;
  for (const auto& row : rows) {
    INFO(row.dump());
    if (row["verdict"] == "refused as it should be") {
      ++refused;
      CHECK(row["first_refusal"] != "");
      continue;
    }
    CHECK(row["verdict"] == "ok");
    CHECK(row["worst"].get<double>() <= row["limit"].get<double>());
  }
  CHECK(refused >= 1);  // the direct sum over 1e18 copies
  CHECK_THAT(folder.read("s.png"), Catch::StartsWith("\x89PNG"));
  CHECK(nlohmann::json::parse(folder.read("s.csv.json"))["command"] == "stability");
}

TEST_CASE("a picture over the table is refused", "[cli][stability]") {
  const Scratch folder;
  check_refused(folder, "stability -o older.csv --plot ./older.csv", 2, {"older.csv"});
  check_refused(folder, "stability -o new.csv --plot new.csv", 2, {"new.csv"});
}
