// Scans measured by others, which are not part of this repository.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>

#include "tests/cli/program.h"

using nlohmann::json;

namespace {

/// The folder of the scans; where there is none, says visibly that the test was skipped, and in CI
/// fails.
std::optional<std::string> scans() {
  const char* folder = std::getenv("SHEDLIGHT_REAL_DATA");
  if (folder != nullptr && *folder != '\0') return std::filesystem::absolute(folder).string();
  const char* ci = std::getenv("CI");
  if (ci != nullptr && *ci != '\0')
    FAIL("SHEDLIGHT_REAL_DATA is not set; CI must have the real scans");
  WARN("skipped: SHEDLIGHT_REAL_DATA is not set");
  return std::nullopt;
}

}  // namespace

TEST_CASE("the thesis preset reproduces the recorded period of Elaphe",
          "[cli][thesis][golden][real]") {
  const std::optional<std::string> data = scans();
  if (!data) return;
  const Scratch folder;
  folder.prepare("sweep " + *data +
                 "/elaphe_65um.png --pixel 48.828125nm --height-range 434.7nm --reduce 2 "
                 "--theta-i 75deg --theta-r -41:-15:0.01deg --lambda 380:780:1nm "
                 "--preset thesis --terms 21 -o R.csv");
  const Outcome outcome =
      folder.shedlight("period R.csv --order 1 --period-range 1.1:1.3um --json");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const json result = json::parse(outcome.out);
  CHECK(result.at("source_mean_nm").get<double>() == Approx(1144.26).margin(0.1).epsilon(0));
  CHECK(result.at("source_std_nm").get<double>() == Approx(0.40).margin(0.05).epsilon(0));
}

TEST_CASE("the real scans say their size, and ask for what they do not say", "[cli][real]") {
  const std::optional<std::string> data = scans();
  if (!data) return;
  const Scratch folder;
  const Outcome turned = folder.shedlight("info " + *data + "/turned_9um_nonsquare.gsf --json");
  INFO(turned.err);
  REQUIRE(turned.exit_code == 0);
  const json pixel = json::parse(turned.out).at("pixel_um");
  CHECK(pixel.at(0).get<double>() == Approx(0.127657).epsilon(1e-5));
  CHECK(pixel.at(1).get<double>() == Approx(0.314582).epsilon(1e-5));

  const Outcome unscaled = folder.shedlight("info " + *data + "/xenopeltis_65um.png");
  CHECK(unscaled.exit_code == 3);
  CHECK_THAT(unscaled.err, Catch::Contains("--width"));

  const Outcome scaled = folder.shedlight("info " + *data +
                                          "/elaphe_65um.png --pixel 48.828125nm "
                                          "--height-range 434.7nm --json");
  REQUIRE(scaled.exit_code == 0);
  CHECK(json::parse(scaled.out).at("size_um").at(0).get<double>() == Approx(65.0390625));
}
