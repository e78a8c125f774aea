#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "gratings.h"
#include "program.h"
#include "refusal.h"

namespace {

using nlohmann::json;

const std::string in_plane =
    "sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.1deg --lambda 400:700:20nm --quantity power ";

json error_of(const Scratch& folder, const std::string& output) {
  return json::parse(folder.read(output + ".json")).at("error");
}

}  // namespace

TEST_CASE("by default a sweep keeps 1e-6 and audits 32 of its cells", "[cli][method]") {
  const Scratch folder;
  make_grating(folder);
  folder.prepare(in_plane + "-o R.csv");
  const json error = error_of(folder, "R.csv");
  CHECK(error.at("audit").at("cells") == 32);
  CHECK(error.at("audit").at("worst_error").get<double>() <= 1e-6);
  CHECK(error.at("amplitude_bound").get<double>() <= 1e-6);
  folder.prepare(in_plane + "--audit 5 -o R.csv");
  CHECK(error_of(folder, "R.csv").at("audit").at("cells") == 5);
  folder.prepare(in_plane + "--audit 0 -o R.csv");
  CHECK(error_of(folder, "R.csv").at("audit").at("cells") == 0);
}

TEST_CASE("auto and chebyshev equal the direct sum within the tolerance", "[cli][method]") {
  const Scratch folder;
  make_grating(folder);
  const std::string surface = GENERATE(as<std::string>(), "--surface isolated",
                                       "--surface periodic", "--surface replicated --replicas 3,1");
  const std::string azimuth = GENERATE(as<std::string>(), "--phi-i 0deg", "--phi-i 90deg",
                                       "--phi-i 30deg", "--phi-i 10deg --phi-r 200deg");
  CAPTURE(surface, azimuth);
  folder.prepare(in_plane + surface + " " + azimuth + " --method direct -o D.csv");
  for (const std::string method : {"auto", "chebyshev"})
    for (const std::string tolerance : {"1e-3", "1e-6", "1e-9", "1e-12"}) {
      folder.prepare(in_plane + surface + " " + azimuth + " --method " + method + " --tolerance " +
                     tolerance + " -o R.csv");
      // abs(a)^2 with abs(a) <= 1 differs by at most twice the error of a, and its square.
      const Outcome outcome =
          folder.shedlight("validate R.csv D.csv --max-error 2.01" + tolerance.substr(1));
      CAPTURE(method, tolerance, outcome.out);
      CHECK(outcome.exit_code == 0);
    }
}

TEST_CASE("a bound above what is tolerable warns once, and is refused where strict",
          "[cli][method]") {
  const Scratch folder;
  make_grating(folder);
  const std::string command = in_plane + "--sigma 16.25um --method taylor --terms 2 -o R.csv";
  const Outcome outcome = folder.shedlight(command);
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.err, Catch::Contains("error bound"));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(error_of(folder, "R.csv").at("audit").at("worst_error").get<double>() > 1e-2);
  CHECK(folder.shedlight(command + " --strict").exit_code == 5);
}

TEST_CASE("replicas ask for the replicated surface, and for no other", "[cli][method]") {
  const Scratch folder;
  make_grating(folder);
  folder.prepare(in_plane + "--replicas 4,2 -o R.csv");
  const json p = json::parse(folder.read("R.csv.json")).at("parameters");
  CHECK(p.at("surface") == "replicated");
  CHECK(p.at("replicas") == json({4, 2}));
  check_refused(folder, in_plane + "--replicas 4 --surface periodic -o older.csv", 2,
                {"--replicas", "periodic"});
  check_refused(folder, in_plane + "--replicas 0 -o older.csv", 2, {"--replicas", "0"});
  check_refused(folder, in_plane + "--replicas 4 --method taylor -o older.csv", 2,
                {"replicated", "direct"});
}

TEST_CASE("explain prints the plan and runs nothing", "[cli][method]") {
  const Scratch folder;
  make_grating(folder);
  const auto before = folder.contents();
  for (const std::string method : {"auto", "chebyshev", "taylor", "pq", "direct"}) {
    CAPTURE(method);
    const Outcome people = folder.shedlight(in_plane + "--explain -o R.csv --method " + method);
    CHECK(people.exit_code == 0);
    CHECK_THAT(people.out, Catch::Contains("path") && Catch::Contains("bytes"));
    const Outcome outcome = folder.shedlight(in_plane + "--explain --json --method " + method);
    CHECK(outcome.exit_code == 0);
    const json plan = json::parse(outcome.out);
    CHECK(plan.at("queries") == 151 * 16);
    if (method == "chebyshev") {
      CHECK(plan.at("terms").get<int>() > 3);
      const double bound = plan.at("error").at("series").get<double>() +
                           plan.at("error").at("kernel").get<double>() +
                           plan.at("error").at("storage").get<double>() +
                           plan.at("error").at("rounding").get<double>();
      CHECK(bound > 0);
      CHECK(bound <= 1e-6);
    }
  }
  CHECK(folder.contents() == before);
}

TEST_CASE("terms or a window radius choose the Taylor series", "[cli][method]") {
  const Scratch folder;
  make_grating(folder);
  for (const std::string knob : {"--terms 30", "--window-radius 5"}) {
    folder.prepare(in_plane + knob + " -o R.csv");
    CHECK(json::parse(folder.read("R.csv.json")).at("parameters").at("method") == "taylor");
  }
}
