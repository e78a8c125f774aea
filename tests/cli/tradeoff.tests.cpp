#include <catch2/catch.hpp>
#include <sstream>

#include "tests/cli/gratings.h"
#include "tests/cli/pictures.h"
#include "tests/cli/refusal.h"
#include "tests/cli/sidecars.h"

namespace {

const std::string quick = "tradeoff g.gsf" + small_scene + " --repeats 1";
const std::string tradeoff = quick + " --period 2500nm";

using Rows = std::vector<std::vector<std::string>>;

/// The cells of a table, its header first.
Rows cells_of(const std::string& csv) {
  Rows rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& row = rows.emplace_back(1);
    for (const char c : line)
      if (c == ',')
        row.emplace_back();
      else
        row.back() += c;
  }
  return rows;
}

std::size_t column(const Rows& rows, const std::string& name) {
  for (std::size_t i = 0; i < rows.front().size(); ++i)
    if (rows.front()[i] == name) return i;
  throw std::runtime_error("no column " + name);
}

/// The number of the row that has these cells.
std::string row_with(const Rows& rows,
                     const std::vector<std::pair<std::string, std::string>>& cells) {
  for (const auto& row : rows) {
    bool has_all = true;
    for (const auto& [name, value] : cells) has_all = has_all && row[column(rows, name)] == value;
    if (has_all) return row.front();
  }
  throw std::runtime_error("no such row");
}

}  // namespace

TEST_CASE("a trade-off writes its table, its picture and what is within the budget",
          "[cli][tradeoff]") {
  const Scratch folder;
  make_grating(folder);
  const Outcome outcome =
      folder.shedlight(tradeoff + " --surface periodic --budget-error 1e-6 -o f.csv --plot f.png");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  check_picture(folder.read("f.png"));
  const Rows rows = cells_of(folder.read("f.csv"));
  for (const std::string name : {"25 terms", "3 x 3", "Nmin/Nmax"})
    CHECK_NOTHROW(row_with(rows, {{"sources", name}}));
  const nlohmann::json sidecar = sidecar_of(folder, "f.csv");
  CHECK(sidecar["parameters"]["seed"] == 1);
  CHECK(sidecar["references"][0]["worst_error_against_direct_sum"].get<double>() <= 1e-12);
  // The row within the budget is no slower than any other that meets it.
  REQUIRE(sidecar["within_budget"].size() == 1);
  const auto chosen = sidecar["within_budget"][0].get<std::size_t>();
  CHECK_THAT(outcome.out, Catch::Contains("--like f.csv:" + std::to_string(chosen)));
  const auto number = [&](std::size_t row, const std::string& name) {
    return std::stod(rows[row][column(rows, name)]);
  };
  CHECK(number(chosen, "worst_error") <= 1e-6);
  for (std::size_t row = 1; row < rows.size(); ++row)
    if (rows[row].back().empty() && number(row, "worst_error") <= 1e-6)
      CHECK(number(chosen, "total_s") <= number(row, "total_s"));
}

TEST_CASE("sweep --like takes method and knobs of a row", "[cli][tradeoff]") {
  const Scratch folder;
  make_grating(folder);
  folder.prepare(tradeoff + " --replicas 3 -o r.csv");
  folder.prepare(tradeoff + " --surface periodic -o p.csv");
  const Rows periodic = cells_of(folder.read("p.csv")), copies = cells_of(folder.read("r.csv"));
  const std::string sweep = "sweep g.gsf" + small_scene;
  const auto check_same = [&](const std::string& like, const std::string& explicitly) {
    INFO(like << " : " << explicitly);
    folder.prepare(sweep + " --like " + like + " -o a.csv");
    folder.prepare(sweep + explicitly + " -o b.csv");
    CHECK(folder.read("a.csv") == folder.read("b.csv"));
  };
  check_same("p.csv:" + row_with(periodic, {{"sources", "25 terms"}}),
             " --method taylor --terms 25 --window-radius 4");
  check_same("p.csv:" + row_with(periodic, {{"method", "chebyshev"}, {"tolerance", "0.001"}}),
             " --method chebyshev --tolerance 1e-3 --surface periodic");
  check_same("p.csv:" + row_with(periodic, {{"sources", "Nmin/Nmax"}}) + " --period 2500nm",
             " --method taylor --terms 25 --window-radius 4 --orders-only --period 2500nm");
  check_same("r.csv:" + row_with(copies, {{"sources", "PQ linear"}, {"replicas_x", "3"}}),
             " --method pq --terms 25 --interpolation linear --replicas 3");
  folder.prepare("sweep g.gsf" + small_scene + " --like p.csv:1 -o a.csv");
  CHECK(sidecar_of(folder, "a.csv")["parameters"]["like"]["row"] == 1);
}

TEST_CASE("sweep --like with a coarser step samples fewer wavelengths", "[cli][tradeoff]") {
  const Scratch folder;
  make_grating(folder);
  const std::string scene = " --theta-i 75deg --theta-r -55:-40:1deg --sigma 16.25um --lambda ";
  folder.prepare("tradeoff g.gsf" + scene + "400:430:1nm --repeats 1 --surface isolated -o f.csv");
  const std::string row = row_with(cells_of(folder.read("f.csv")), {{"lambda_step_nm", "10"}});
  folder.prepare("sweep g.gsf" + scene + "400:430:1nm --like f.csv:" + row + " -o a.csv");
  folder.prepare("sweep g.gsf" + scene + "400:430:10nm --method chebyshev -o b.csv");
  CHECK(folder.read("a.csv") == folder.read("b.csv"));
}

TEST_CASE("a trade-off and --like that make no sense are refused", "[cli][tradeoff]") {
  const Scratch folder;
  make_grating(folder);
  check_refused(folder, tradeoff + " --budget-error 0 -o older.csv", 2, {"--budget-error", "0"});
  check_refused(folder, tradeoff + " --budget-time 5 -o older.csv", 2, {"--budget-time", "5"});
  check_refused(folder, "tradeoff g.gsf" + small_scene + " --repeats 0 -o older.csv", 2,
                {"--repeats", "0"});
  check_refused(folder, quick + " --period 0nm -o older.csv", 2, {"period", "0"});
  check_refused(folder, tradeoff + " --surface periodic --replicas 2 -o older.csv", 2,
                {"--replicas"});
  check_refused(folder, tradeoff + " -o older.csv --plot older.csv", 2, {"--plot", "older.csv"});
  check_refused(folder, tradeoff + " -o g.gsf", 2, {"g.gsf"});
  check_refused(folder, tradeoff + " --strict --surface isolated --budget-time 1e-9s -o older.csv",
                5, {"isolated", "1e-09 s"});
  folder.prepare(tradeoff + " --surface isolated -o f.csv");
  const std::string sweep = "sweep g.gsf" + small_scene + " -o older.csv --like ";
  check_refused(folder, sweep + "f.csv", 2, {"--like", "FILE:ROW"});
  check_refused(folder, sweep + "f.csv:0", 2, {"--like", "0"});
  check_refused(folder, sweep + "f.csv:x", 2, {"--like", "x"});
  check_refused(folder, sweep + "f.csv:9999", 2, {"f.csv", "9999"});
  check_refused(folder, sweep + "nowhere.csv:1", 3, {"nowhere.csv"});
  check_refused(folder, sweep + "g.gsf:1", 3, {"g.gsf", "line 1"});
  check_refused(folder, sweep + "f.csv:2 --method direct", 2, {"--method", "--like"});
  check_refused(folder, sweep + "f.csv:2 --tolerance 1e-3", 2, {"--tolerance", "--like"});
  check_refused(folder, sweep + "f.csv:2 --surface periodic", 2, {"--surface", "--like"});
  const std::string orders = row_with(cells_of(folder.read("f.csv")), {{"cells", "orders"}});
  check_refused(folder, sweep + "f.csv:" + orders, 2, {"f.csv: row " + orders, "--period"});
}
