#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"
#include "tests/cli/tables.h"

namespace {

using nlohmann::json;

const std::string sweep = "sweep g.gsf" + small_scene + " ";
const std::string bands = "--orders-only --period 2500nm ";

}  // namespace

TEST_CASE("under --orders-only the cells near the orders keep their bytes, the others are 0",
          "[cli][orders_only]") {
  const Scratch folder;
  make_grating(folder);
  const std::string method =
      GENERATE(as<std::string>(), "auto", "chebyshev", "direct", "taylor --surface periodic");
  CAPTURE(method);
  folder.prepare(sweep + "--method " + method + " -o full.csv");
  const Outcome outcome = folder.shedlight(sweep + bands + "--method " + method + " -o R.csv");
  REQUIRE(outcome.exit_code == 0);
  const auto full = table_of(folder.read("full.csv")), some = table_of(folder.read("R.csv"));
  std::size_t zeros = 0, cells = 0;
  REQUIRE(some.size() == full.size());
  for (std::size_t row = 1; row < some.size(); ++row)
    for (std::size_t column = 1; column < some[row].size(); ++column) {
      ++cells;
      if (some[row][column] == "0")
        ++zeros;
      else
        CHECK(some[row][column] == full[row][column]);
    }
  const json orders = json::parse(folder.read("R.csv.json")).at("parameters").at("orders_only");
  CHECK(orders.at("cells_evaluated") == cells - zeros);
  CHECK(orders.at("share_evaluated").get<double>() ==
        Approx(static_cast<double>(cells - zeros) / static_cast<double>(cells)));
  CHECK(zeros > cells / 4);
  CHECK(zeros < cells);
  CHECK_THAT(outcome.err, Catch::Contains(std::to_string(cells - zeros) + " of " +
                                          std::to_string(cells) + " cells"));
}

TEST_CASE("under --orders-only the period is the same", "[cli][orders_only]") {
  const Scratch folder;
  make_grating(folder);
  const auto period = [&](const std::string& options) {
    folder.prepare(sweep + options + "-o R.csv");
    return json::parse(folder.shedlight("period R.csv --by peaks --json").out)
        .at("period_nm")
        .get<double>();
  };
  // The peaks are the same cells and their neighbours.
  CHECK(period("") == period(bands));
}

TEST_CASE("a lattice and an azimuth are taken as given", "[cli][orders_only]") {
  const Scratch folder;
  make_grating(folder);
  folder.prepare(sweep +
                 "--orders-only --period 2500nm,800nm --period-azimuth 0deg --band-radius 3 "
                 "-o R.csv");
  const json orders = json::parse(folder.read("R.csv.json")).at("parameters").at("orders_only");
  CHECK(orders.at("period_um") == 2.5);
  CHECK(orders.at("period_across_um") == 0.8);
  CHECK(orders.at("azimuth_deg") == 0.0);
  CHECK(orders.at("band_radius") == 3.0);
  // 3 sigma_f = 3 / (2 pi 16.25 um)
  CHECK(orders.at("halfwidth_per_um").get<double>() == Approx(0.0293825).epsilon(1e-5));
}

TEST_CASE("bands that mean nothing are refused", "[cli][orders_only][refusal]") {
  const Scratch folder;
  make_grating(folder);
  const std::string out = sweep + "-o older.csv ";
  check_refused(folder, out + "--orders-only", 2, {"--orders-only", "--period"});
  check_refused(folder, out + "--period 2500nm", 2, {"--period", "--orders-only"});
  check_refused(folder, out + "--band-radius 3", 2, {"--band-radius", "--orders-only"});
  check_refused(folder, out + "--period-azimuth 3deg", 2, {"--period-azimuth", "--orders-only"});
  check_refused(folder, out + "--orders-only --period 0nm", 2, {"period 0"});
  check_refused(folder, out + "--orders-only --period 2500", 2, {"--period", "unit"});
  check_refused(folder, out + bands + "--band-radius 0", 2, {"band radius 0"});
}
