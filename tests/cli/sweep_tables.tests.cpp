#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"
#include "tests/cli/sidecars.h"
#include "tests/cli/tables.h"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string scene = "sweep g.gsf" + small_scene + " --quantity power ";

/// A folder with g.gsf and t.npy of it.
void make_tables(const Scratch& folder, const std::string& options = "") {
  make_grating(folder);
  folder.prepare("precompute g.gsf --terms 40 -o t.npy" + options);
}

/// The largest difference of two responses, and of the axes before them.
double largest_difference(const std::string& csv, const std::string& other) {
  const auto a = table_of(csv), b = table_of(other);
  REQUIRE(a.size() == b.size());
  CHECK(a.at(0) == b.at(0));
  double largest = 0;
  for (std::size_t row = 1; row < a.size(); ++row)
    for (std::size_t cell = 0; cell < a[row].size(); ++cell) {
      const double difference = std::abs(value_of(a[row][cell]) - value_of(b[row].at(cell)));
      if (!(difference <= largest)) largest = difference;
    }
  return largest;
}

void set(const Scratch& folder, const std::string& place, const json& value) {
  json sidecar = sidecar_of(folder, "t.npy");
  sidecar[json::json_pointer(place)] = value;
  folder.write("t.npy.json", sidecar.dump());
}

}  // namespace

TEST_CASE("a response from tables is the response without them, byte for byte",
          "[cli][tables][invariant]") {
  const Scratch folder;
  make_tables(folder);
  for (const std::string method :
       {"--method taylor", "--method taylor --terms 30", "--method taylor --tolerance 1e-9",
        "--method taylor --window-radius 5 --phi-i 30deg", "--method pq --replicas 3,1",
        "--method pq --terms 40 --replicas 5,2"}) {
    CAPTURE(method);
    folder.prepare(scene + method + " -o R.csv");
    const std::string csv = folder.read("R.csv");
    json expected = sidecar_of(folder, "R.csv");
    folder.prepare(scene + method + " --tables t.npy -o R.csv");
    const bool same = folder.read("R.csv") == csv;
    CHECK(same);
    // The sidecar says which tables, and is the same in everything else.
    expected["parameters"]["tables"] = {{"file", "t.npy"}, {"sha256", sha256sum(folder, "t.npy")}};
    CHECK(sidecar_of(folder, "R.csv") == expected);
  }
}

TEST_CASE("tables of reduced and levelled heights serve sweeps of the same",
          "[cli][tables][invariant]") {
  const Scratch folder;
  folder.prepare(
      "synth blazed --period 2500nm --height 600nm --size 65um,1um --pixels 520,4 -o "
      "g.gsf");
  const std::string heights = " --reduce 2 --level plane ";
  folder.prepare("precompute g.gsf --terms 40 -o t.npy" + heights);
  folder.prepare(scene + heights + "--method taylor -o R.csv");
  folder.prepare(scene + heights + "--tables t.npy -o S.csv");
  CHECK(folder.read("R.csv") == folder.read("S.csv"));
  // The preset levels by itself, and its tables must be levelled likewise.
  folder.prepare("precompute g.gsf --terms 40 --level mean -o t.npy");
  folder.prepare(scene + "--preset thesis -o R.csv");
  folder.prepare(scene + "--preset thesis --tables t.npy -o S.csv");
  CHECK(folder.read("R.csv") == folder.read("S.csv"));
}

TEST_CASE("a response from normalised tables differs by no more than is stated",
          "[cli][tables][invariant]") {
  const Scratch folder;
  make_tables(folder, " --normalise extrema");
  for (const std::string method : {"--method taylor", "--method pq --replicas 3,1"}) {
    CAPTURE(method);
    folder.prepare(scene + method + " -o R.csv");
    folder.prepare(scene + method + " --tables t.npy -o S.csv");
    const auto bound = [&](const std::string& file) {
      return sidecar_of(folder, file).at("error").at("amplitude_bound").get<double>();
    };
    const double added = bound("S.csv") - bound("R.csv");
    CHECK(added > 0);
    CHECK(added <= 1e-9);  // 3e-12 for this depth of 6 rad: far below the tolerance
    const double difference = largest_difference(folder.read("R.csv"), folder.read("S.csv"));
    CHECK(difference > 0);
    CHECK(difference <= 2.01 * added);  // of abs(a)^2 with abs(a) <= 1
  }
}

TEST_CASE("tables alone mean the Taylor series", "[cli][tables]") {
  const Scratch folder;
  make_tables(folder);
  folder.prepare(scene + "--tables t.npy -o R.csv");
  CHECK(sidecar_of(folder, "R.csv").at("parameters").at("method") == "taylor");
  const Outcome outcome = folder.shedlight(scene + "--tables t.npy --explain --json");
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(json::parse(outcome.out).at("path").get<std::string>(), Catch::Contains("powers"));
}

TEST_CASE("tables are refused by a method that takes none", "[cli][tables][refusal]") {
  const Scratch folder;
  make_tables(folder);
  for (const std::string method : {"auto", "direct", "chebyshev"})
    check_refused(folder, scene + "--tables t.npy -o older.csv --method " + method, 2,
                  {"--tables", method, "taylor, pq"});
  check_refused(folder, scene + "--tables t.npy -o t.npy", 2, {"t.npy", "input"});
}

TEST_CASE("tables of fewer terms than are needed are refused with both numbers",
          "[cli][tables][refusal]") {
  const Scratch folder;
  make_grating(folder);
  folder.prepare("precompute g.gsf --terms 12 -o t.npy");
  folder.prepare(scene + "--method taylor -o R.csv");
  const int needed = sidecar_of(folder, "R.csv").at("error").at("terms");
  check_refused(folder, scene + "--tables t.npy -o older.csv", 5,
                {"12 terms", "needs " + std::to_string(needed)});
  check_refused(folder, scene + "--method pq --tables t.npy -o older.csv", 5,
                {"12 terms", "needs " + std::to_string(needed)});
  check_refused(folder, scene + "--terms 13 --tables t.npy -o older.csv", 5,
                {"12 terms", "needs 13"});
  CHECK(folder.shedlight(scene + "--terms 12 --tables t.npy").exit_code == 0);
}

TEST_CASE("tables of other heights are refused by what differs", "[cli][tables][refusal]") {
  const Scratch folder;
  make_tables(folder);
  const auto refused = [&](const std::string& options, const std::vector<std::string>& named) {
    check_refused(folder, scene + "--tables t.npy -o older.csv" + options, 3, named);
  };
  refused(" --reduce 1 --level mean", {"t.npy", "level", "\"none\"", "\"mean\""});
  refused(" --pixel 300nm", {"t.npy", "pixel_um", "0.25", "0.3"});
  refused(" --height-unit 0.5m", {"t.npy", "range_um"});
  refused(" --preset thesis", {"t.npy", "level"});
  // The same name, another grating.
  folder.prepare(
      "synth blazed --period 2500nm --height 600nm --size 65um,0.25um --pixels 261,1 -o "
      "g.gsf");
  refused("", {"t.npy", "input/sha256", sha256sum(folder, "g.gsf")});
  folder.prepare("synth flat --size 4um --pixels 8 -o g.gsf");
  folder.prepare("precompute g.gsf --terms 3 --reduce 2 -o t.npy");
  refused("", {"t.npy", "reduce is 2", "is 1"});
}

TEST_CASE("damaged tables are refused", "[cli][tables][refusal]") {
  const Scratch folder;
  make_tables(folder);
  const std::string command = scene + "--tables t.npy -o older.csv";
  const std::string good = folder.read("t.npy"), sidecar = folder.read("t.npy.json");
  std::string changed = good;
  changed[good.size() / 2] ^= 1;
  folder.write("t.npy", changed);
  check_refused(folder, command, 3, {"t.npy", "SHA-256", sha256sum(folder, "t.npy")});
  folder.write("t.npy", good.substr(0, good.size() - 1));
  check_refused(folder, command, 3, {"t.npy", "does not match"});
  folder.write("t.npy", good + " ");
  check_refused(folder, command, 3, {"t.npy", "does not match"});
  folder.write("t.npy", "");
  check_refused(folder, command, 3, {"t.npy", "NPY"});
  folder.write("t.npy", folder.read("g.gsf"));
  check_refused(folder, command, 3, {"t.npy", "NPY"});
  fs::remove(folder / "t.npy");
  check_refused(folder, command, 3, {"t.npy", "no such file"});
  fs::create_directory(folder / "t.npy");
  check_refused(folder, command, 3, {"t.npy", "regular file"});
  fs::remove(folder / "t.npy");
  folder.write("t.npy", good);
  fs::remove(folder / "t.npy.json");
  check_refused(folder, command, 3, {"t.npy.json", "no such file"});
  folder.write("t.npy.json", sidecar.substr(0, sidecar.size() / 2));
  check_refused(folder, command, 3, {"t.npy.json", "JSON"});
  folder.write("t.npy.json", sidecar);
  CHECK(folder.shedlight(scene + "--tables t.npy").exit_code == 0);
}

TEST_CASE("a sidecar of tables may hold anything and does no harm", "[cli][tables][refusal]") {
  struct Change {
    std::string place;
    json value;
    std::vector<std::string> named;
  };
  for (const Change& change : std::vector<Change>{
           {"/parameters/terms", "40", {"terms", "\"40\"", "2000"}},
           {"/parameters/terms", 4e18, {"terms", "4e+18", "2000"}},
           {"/parameters/terms", 4000000000, {"terms", "4000000000", "2000"}},
           {"/parameters/terms", 39, {"[40,1,131]", "[39,1,131]"}},
           {"/parameters/rows", "1", {"rows", "\"1\""}},
           {"/parameters/columns", json::array({260}), {"columns", "[260]"}},
           {"/parameters/mid_range_um", nullptr, {"mid_range_um", "null"}},
           {"/parameters/normalisation", 1, {"normalisation", "extrema"}},
           {"/parameters", "none", {"parameters"}},
           {"/input", 5, {"input"}},
           {"/output", 5, {"output"}},
           {"/extrema", 5, {"extrema", "40 terms"}},
           {"/extrema/39/im_max", "0", {"extrema/39/im_max", "\"0\""}},
           {"/extrema/1/re_max", 1e9, {"extrema/1/re_max", "260.0"}},
           {"/parameters/level", "two\nlines", {"level", "two"}},
       }) {
    CAPTURE(change.place, change.value.dump());
    const Scratch folder;
    make_tables(folder, " --normalise extrema");
    set(folder, change.place, change.value);
    std::vector<std::string> named = change.named;
    named.emplace_back("t.npy");
    check_refused(folder, scene + "--tables t.npy -o older.csv", 3, named);
  }
}

TEST_CASE("tables count towards the memory by one table", "[cli][tables][limit]") {
  const Scratch folder;
  folder.prepare("synth blazed --period 2500nm --height 600nm --size 65um --pixels 650 -o g.gsf");
  folder.prepare("precompute g.gsf --terms 8 -o t.npy");
  const auto bytes = [&](const std::string& options) {
    const Outcome outcome =
        folder.shedlight(scene + "--method taylor --terms 8 --explain --json" + options);
    REQUIRE(outcome.exit_code == 0);
    return json::parse(outcome.out).at("bytes").get<long>();
  };
  // Computing takes the samples as well.
  CHECK(bytes("") - bytes(" --tables t.npy") == 650 * 650 * 8);
  check_refused(folder, scene + "--terms 8 --tables t.npy --memory-limit 1MB -o older.csv", 6,
                {"g.gsf", "--memory-limit"});
}
