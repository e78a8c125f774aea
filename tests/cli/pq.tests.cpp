#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"

namespace {

using nlohmann::json;

const std::string sweep =
    "sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.1deg --lambda 400:700:100nm --quantity power ";

double worst_error(const Scratch& folder) {
  return json::parse(folder.read("R.csv.json")).at("error").at("audit").at("worst_error");
}

}  // namespace

TEST_CASE("pq equals the direct sum over the copies, exactly read", "[cli][pq][oracle]") {
  const Scratch folder;
  make_grating(folder);
  const std::string replicas = GENERATE(as<std::string>(), "1,1", "3,1", "40,2");
  folder.prepare(sweep + "--method direct --replicas " + replicas + " -o D.csv");
  folder.prepare(sweep + "--method pq --tolerance 1e-9 --replicas " + replicas + " -o R.csv");
  // abs(a)^2 differs by at most twice the error of a.
  const Outcome outcome = folder.shedlight("validate R.csv D.csv --max-error 2e-9");
  INFO(outcome.out);
  CHECK(outcome.exit_code == 0);
  const json p = json::parse(folder.read("R.csv.json")).at("parameters");
  CHECK(p.at("surface") == "replicated");
  CHECK(p.at("interpolation") == "exact");
}

TEST_CASE("pq between the bins is off, says so, and its bound holds", "[cli][pq]") {
  const Scratch folder;
  make_grating(folder);
  double worst = 1;
  for (const std::string interpolation : {"nearest", "linear", "sinc"}) {
    CAPTURE(interpolation);
    const std::string command = sweep + "--method pq --interpolation " + interpolation +
                                " --audit 400 --replicas 1 -o R.csv";
    const Outcome outcome = folder.shedlight(command);
    CHECK(outcome.exit_code == 0);
    check_warned(outcome, {"g.gsf", "error bound"});
    const json error = json::parse(folder.read("R.csv.json")).at("error");
    const double found = worst_error(folder);
    CHECK(found <= error.at("amplitude_bound").get<double>());
    CHECK(found > 1e-3);
    CHECK(found < worst);  // each is better than the one before
    worst = found;
    CHECK(folder.shedlight(command + " --strict").exit_code == 5);
  }
}

TEST_CASE("an interpolation goes with pq alone, and pq with copies alone", "[cli][pq][refusal]") {
  const Scratch folder;
  make_grating(folder);
  const std::string out = sweep + "-o older.csv ";
  check_refused(folder, out + "--method auto --interpolation sinc", 2, {"--interpolation", "pq"});
  check_refused(folder, out + "--method taylor --interpolation sinc", 2, {"--interpolation", "pq"});
  check_refused(folder, out + "--method pq --interpolation magic", 2,
                {"magic", "nearest", "exact"});
  check_refused(folder, out + "--method pq --surface isolated", 2, {"pq", "isolated"});
  check_refused(folder, out + "--method pq --window-radius 4", 2, {"--window-radius", "taylor"});
}

TEST_CASE("an interpolation, or terms with copies, choose pq", "[cli][pq]") {
  const Scratch folder;
  make_grating(folder);
  for (const std::string knob :
       {"--interpolation exact", "--terms 30 --replicas 2", "--terms 30 --surface replicated"}) {
    folder.prepare(sweep + knob + " -o R.csv");
    CHECK(json::parse(folder.read("R.csv.json")).at("parameters").at("method") == "pq");
  }
}
