// What advise finds in a surface, and how it says so.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "brdf/units.h"
#include "tests/cli/advice.h"
#include "tests/cli/height_files.h"
#include "tests/cli/refusal.h"
#include "tests/cli/sidecars.h"
#include "tests/support/real_data.h"

using brdf::pi;
using nlohmann::json;

namespace {

/// Heights [um] by a function of column and row in pixels of 0.1 um.
template <class Function>
void write_heights(const Scratch& folder, int cols, int rows, Function height_um) {
  Gsf gsf{.cols = cols,
          .rows = rows,
          .lines = "XReal = " + std::to_string(0.1 * cols) +
                   "\nYReal = " + std::to_string(0.1 * rows) + "\nXYUnits = um\nZUnits = um\n"};
  for (int row = 0; row < rows; ++row)
    for (int col = 0; col < cols; ++col)
      gsf.heights.push_back(static_cast<float>(height_um(col, row)));
  folder.write("g.gsf", gsf_bytes(gsf));
}

}  // namespace

TEST_CASE("a blaze in coarse pixels is undersampled", "[cli][advise]") {
  const Scratch folder;
  make(folder, "blazed --period 2500nm --height 200nm --size 65um --pixels 260,26");
  const json coarse = advise(folder, "g.gsf --theta-i 75deg");
  CHECK(verdict(coarse, "sampling") == "undersampled");
  // lambda / (2 pixel) = 0.76: theta_r up to asin(0.76 - sin 75 deg) = -11.9 deg.
  CHECK(coarse.at("sampling").at("safe_angles").at("value").at(1) == -12.0);
  CHECK_THAT(coarse.at("command").get<std::string>(), Catch::Contains("--theta-r -89:-12:"));
  CHECK(verdict(advise(folder, "g.gsf --theta-i 75deg --theta-r -85:-15:1deg"), "sampling") ==
        "sampled");
  const json none = advise(folder, "g.gsf --theta-i 75deg --theta-r 0:80:1deg");
  CHECK(verdict(none, "sampling") == "undersampled");
  CHECK(none.at("sampling").at("safe_angles").at("value").is_null());
}

TEST_CASE("the steps of 8 bits cannot bear a fine tolerance", "[cli][advise]") {
  const Scratch folder;
  folder.write("scan.png", png_bytes({.cols = 64, .rows = 16, .code = [](auto, auto col, int) {
                                        return static_cast<unsigned>(
                                            127.5 + 127 * std::cos(2 * pi * col / 8.0));
                                      }}));
  const std::string scene =
      "scan.png --width 6.4um --height-range 255nm --theta-i 0deg --lambda 500nm --tolerance ";
  const json advice = advise(folder, scene + "1e-9");
  CHECK(verdict(advice, "heights") == "too_coarse");
  // k |w| step / 2 = 2 pi / 0.5 x 2 x 0.001 / 2
  CHECK(value(advice, "heights", "phase_error") == Approx(4 * pi * 1e-3).epsilon(1e-9));
  CHECK_THAT(advice.at("command").get<std::string>(), Catch::Contains("--tolerance 0.01"));
  CHECK(verdict(advise(folder, scene + "0.013"), "heights") == "fine_enough");
  CHECK(verdict(advise(folder, scene + "0.012"), "heights") == "too_coarse");
}

TEST_CASE("a tilted grating is told to be levelled, and its period found", "[cli][advise]") {
  const Scratch folder;
  const auto tilted = [](double slope) {
    return [slope](int col, int row) {
      const double x = 0.1 * col, y = 0.1 * row;
      return 0.05 * std::cos(2 * pi * x / 2) + slope * (x + 0.5 * y);
    };
  };
  write_heights(folder, 300, 200, tilted(0.03));
  const json advice = advise(folder, "g.gsf --theta-i 20deg");
  CHECK(verdict(advice, "tilt") == "tilted");
  CHECK(value(advice, "tilt", "mirror_shift") ==
        Approx(2 * std::atan(0.03 * std::sqrt(1.25)) * 180 / pi).epsilon(1e-3));
  REQUIRE(periods(advice).size() == 1);
  CHECK(periods(advice)[0].at("period_um").get<double>() == Approx(2).epsilon(1e-3));
  CHECK_THAT(advice.at("command").get<std::string>(), Catch::Contains("--level plane"));
  CHECK(verdict(advise(folder, "g.gsf --theta-i 20deg --level plane"), "tilt") == "level");
  write_heights(folder, 300, 200, tilted(1e-4));
  CHECK(verdict(advise(folder, "g.gsf --theta-i 20deg"), "tilt") == "level");
}

TEST_CASE("the sweep that is recommended runs as it is", "[cli][advise]") {
  const Scratch folder;
  make(folder, "blazed --period 2500nm --height 200nm --size 65um,0.25um --pixels 650,1");
  for (const std::string options : {"--sigma 16um", "--sigma 0.5um", "--replicas 2,1"}) {
    const json advice = advise(
        folder, "g.gsf --theta-i 75deg --lambda 500:502:1nm --theta-r -60:-50:1deg " + options);
    const std::string command = advice.at("command").get<std::string>();
    INFO(command);
    REQUIRE(command.rfind("shedlight ", 0) == 0);
    const Outcome outcome = folder.shedlight(command.substr(10));
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err == "");
  }
}

TEST_CASE("the scene of the JSON is that of a sweep's sidecar", "[cli][advise]") {
  const Scratch folder;
  make(folder, "flat --size 9um --pixels 9");
  const std::string scene =
      "g.gsf --theta-i 30deg --phi-i 20deg --theta-r -10:10:5deg --lambda 500:510:5nm";
  const json found = advise(folder, scene).at("scene");
  folder.prepare("sweep " + scene + " -o R.csv");
  const json expected = sidecar_of(folder, "R.csv").at("parameters");
  for (const char* key : {"theta_i_deg", "phi_i_deg", "phi_r_deg", "theta_r_deg", "lambda_nm"})
    CHECK(found.at(key) == expected.at(key));
}

TEST_CASE("the page fits a screen and says what the JSON says", "[cli][advise]") {
  const Scratch folder;
  make(folder, GENERATE(as<std::string>(), "blazed --period 1.15um --height 200nm",
                        "lamellar --period 1.15um --height 200nm", "flat") +
                   patch);
  for (const std::string scene : {"--theta-i 75deg", "--theta-i 0deg --sigma 1um",
                                  "--theta-i 0deg --phi-i 33deg --replicas 2"}) {
    const Outcome outcome = folder.shedlight("advise g.gsf " + scene);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err == "");
    std::istringstream lines(outcome.out);
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
      INFO(line);
      CHECK(line.size() <= 100);
    }
    CHECK(count <= 40);
    const json advice = advise(folder, "g.gsf " + scene);
    for (const char* section : {"sampling", "heights", "tilt", "spectrum", "window", "optics",
                                "scalar", "orders", "steps", "method"})
      CHECK_THAT(outcome.out,
                 Catch::Contains(advice.at(section).at("sentence").get<std::string>()));
  }
}

TEST_CASE("every number of the advice has its reason", "[cli][advise]") {
  const Scratch folder;
  make(folder, wide_sinusoid);
  const json advice = advise(folder, "g.gsf --theta-i 30deg");
  int findings = 0;
  for (const auto& [name, section] : advice.items()) {
    if (!section.contains("verdict")) continue;
    for (const auto& [key, finding] : section.items()) {
      if (!finding.is_object()) continue;
      INFO(name << " " << key);
      CHECK(finding.contains("value"));
      CHECK(finding.contains("unit"));
      CHECK(finding.at("reason").get<std::string>() != "");
      ++findings;
    }
  }
  CHECK(findings > 30);
}

TEST_CASE("a scene without meaning is refused", "[cli][advise][refusal]") {
  const Scratch folder;
  make(folder, "flat --size 9um --pixels 9");
  check_refused(folder, "advise g.gsf --theta-i 90deg", 2, {"incidence", "90"});
  check_refused(folder, "advise g.gsf --theta-i 30deg --tolerance 0", 2, {"tolerance", "0"});
  check_refused(folder, "advise g.gsf --theta-i 30deg --tolerance nan", 2, {"--tolerance"});
  check_refused(folder, "advise g.gsf --theta-i 30deg --resolution 0deg", 2, {"resolution"});
  check_refused(folder, "advise g.gsf --theta-i 30deg --resolution 90deg", 2, {"resolution"});
  check_refused(folder, "advise g.gsf --theta-i 30deg --sigma 0um", 2, {"sigma"});
  check_refused(folder, "advise g.gsf --theta-i 30deg --lambda 0nm", 2, {"wavelength"});
  check_refused(folder, "advise g.gsf --theta-i 30deg --replicas 2 --surface isolated", 2,
                {"--replicas"});
  check_refused(folder, "advise g.gsf --theta-i 30deg --memory-limit 1kB", 6, {"g.gsf", "advice"});
  check_refused(folder, "advise nowhere.gsf --theta-i 30deg", 3, {"nowhere.gsf"});
}

TEST_CASE("snake skins need diffraction, and their ridges are found", "[cli][advise][real]") {
  const auto data = real_data();
  if (!data) return;
  const Scratch folder;
  const json elaphe =
      advise(folder, (*data / "elaphe_65um.png").string() +
                         " --pixel 48.828125nm --height-range 434.7nm --theta-i 75deg");
  const json xenopeltis = advise(folder, (*data / "xenopeltis_65um.png").string() +
                                             " --width 65um --height-range 818.69nm --theta-i 75deg"
                                             " --phi-i 90deg");
  for (const json& advice : {elaphe, xenopeltis}) {
    CHECK(verdict(advice, "optics") == "diffraction");
    CHECK(verdict(advice, "spectrum") == "periodic");
    CHECK(verdict(advice, "heights") == "too_coarse");
    CHECK(verdict(advice, "orders") == "in_view");
    CHECK(verdict(advice, "tilt") == "level");
  }
  for (const json& period : periods(elaphe)) {
    CHECK(period.at("period_um").get<double>() == Approx(1.07).margin(0.13));
    CHECK(std::abs(period.at("azimuth_deg").get<double>()) < 5);
  }
  for (const json& period : periods(xenopeltis)) {
    CHECK(period.at("period_um").get<double>() == Approx(1.5).margin(0.1));
    CHECK(std::abs(period.at("azimuth_deg").get<double>()) > 75);
  }
}

TEST_CASE("a scan that is tilted and turned is told so", "[cli][advise][real]") {
  const auto data = real_data();
  if (!data) return;
  const Scratch folder;
  const json advice =
      advise(folder, (*data / "grating_317nm.gsf").string() + " --theta-i 30deg --phi-i 45.5deg");
  CHECK(verdict(advice, "tilt") == "tilted");
  REQUIRE(periods(advice).size() == 1);
  CHECK(periods(advice)[0].at("period_um").get<double>() == Approx(0.31659).margin(4e-4));
  CHECK(periods(advice)[0].at("azimuth_deg").get<double>() == Approx(45.5).margin(0.3));
  CHECK(verdict(advice, "scalar") == "invalid");
  const json turned =
      advise(folder, (*data / "turned_9um_nonsquare.gsf").string() + " --theta-i 30deg");
  REQUIRE(periods(turned).size() == 1);
  CHECK(periods(turned)[0].at("period_um").get<double>() == Approx(9.13).margin(0.2));
}

TEST_CASE("a rough scan has no period but a speckle", "[cli][advise][real]") {
  const auto data = real_data();
  if (!data) return;
  const Scratch folder;
  const std::string rough = (*data / "rough_matrix.txt").string();
  const json advice = advise(folder, rough + " --theta-i 30deg");
  CHECK(verdict(advice, "spectrum") == "no_period");
  CHECK(verdict(advice, "orders") == "no_period");
  CHECK(periods(advice).empty());
  // 10 um in all: a grain of speckle is about lambda / 8 um wide, 4 deg.
  CHECK(verdict(advice, "optics") == "diffraction");
  const json blurred = advise(folder, rough + " --theta-i 30deg --resolution 20deg");
  CHECK(verdict(blurred, "optics") != "mirror");
  CHECK(blurred.at("optics").at("decided_by").at("value") != "resolved");
}
