#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/cli/height_files.h"
#include "tests/cli/refusal.h"

namespace {

constexpr double period_um = 2.5, height_m = 600e-9;
constexpr int columns = 64, rows = 3;

double fraction(double t) {
  return t - std::floor(t);
}

/// Checks a profile against its formula over t = x / period, x from the middle of the patch.
void check_profile(const std::string& profile, const std::function<double(double)>& formula) {
  INFO(profile);
  const Scratch folder;
  // Pixels of 0.1 um put no sample on a jump: t = 0.02 + 0.04 n.
  folder.prepare("synth " + profile + " --size 6.4um,0.6um --pixels 64,3 -o g.gsf");
  const ReadGsf gsf = read_gsf(folder.read("g.gsf"));
  REQUIRE(gsf.heights.size() == columns * rows);
  for (int row = 0; row < rows; ++row)
    for (int col = 0; col < columns; ++col) {
      const double t = (col - (columns - 1) / 2.0) * 0.1 / period_um;
      // Heights are stored as floats.
      CHECK(gsf.heights[static_cast<std::size_t>(row * columns + col)] ==
            Approx(height_m * formula(t)).margin(1e-7 * height_m));
    }
}

const std::string grating = " --period 2500nm --height 600nm";

}  // namespace

TEST_CASE("every profile follows its formula from phase 0 in the middle", "[cli][synth]") {
  check_profile("sinusoid" + grating,
                [](double t) { return (1 + std::cos(2 * 3.14159265358979323846 * t)) / 2; });
  check_profile("blazed" + grating, [](double t) { return 1 - fraction(t); });
  check_profile("blazed --facing +x" + grating, [](double t) { return 1 - fraction(t); });
  check_profile("blazed --facing -x" + grating, [](double t) { return fraction(t); });
  check_profile("triangle" + grating, [](double t) { return std::abs(1 - 2 * fraction(t)); });
  check_profile("lamellar" + grating, [](double t) { return fraction(t) < 0.5 ? 1.0 : 0.0; });
  check_profile("lamellar --duty 0.25" + grating,
                [](double t) { return fraction(t) < 0.25 ? 1.0 : 0.0; });
  check_profile("flat", [](double) { return 0.0; });
}

TEST_CASE("a synthetic file says its size in metres", "[cli][synth]") {
  const Scratch folder;
  folder.prepare("synth flat --size 6.4um,0.6um --pixels 64,3 -o g.gsf");
  const std::string header = read_gsf(folder.read("g.gsf")).header;
  CHECK_THAT(header, Catch::StartsWith("Gwyddion Simple Field 1.0\n") &&
                         Catch::Contains("XRes = 64\n") && Catch::Contains("YRes = 3\n") &&
                         Catch::Contains("XYUnits = m\n") && Catch::Contains("ZUnits = m\n"));
  const nlohmann::json info = nlohmann::json::parse(folder.shedlight("info g.gsf --json").out);
  CHECK(info.at("size_um").at(0).get<double>() == Approx(6.4).epsilon(1e-12));
  CHECK(info.at("size_um").at(1).get<double>() == Approx(0.6).epsilon(1e-12));
}

TEST_CASE("an option that does not fit the profile is refused", "[cli][synth]") {
  const Scratch folder;
  const std::string patch = " --size 6.4um --pixels 64 -o older.csv";
  for (const std::string profile : {"blazed", "sinusoid", "triangle"})
    check_refused(folder, "synth " + profile + grating + patch + " --duty 0.3", 2,
                  {"--duty", profile});
  for (const std::string profile : {"lamellar", "sinusoid", "triangle"})
    check_refused(folder, "synth " + profile + grating + patch + " --facing -x", 2,
                  {"--facing", profile});
  check_refused(folder, "synth flat --period 1um" + patch, 2, {"--period", "flat"});
  check_refused(folder, "synth flat --height 1um" + patch, 2, {"--height", "flat"});
  check_refused(folder, "synth flat --duty 0.5" + patch, 2, {"--duty", "flat"});
  check_refused(folder, "synth flat --facing +x" + patch, 2, {"--facing", "flat"});
  for (const std::string profile : {"blazed", "sinusoid", "triangle", "lamellar"}) {
    check_refused(folder, "synth " + profile + " --period 1um" + patch, 2, {"--height", profile});
    check_refused(folder, "synth " + profile + " --height 1um" + patch, 2, {"--period", profile});
  }
}

TEST_CASE("values that no grating has are refused", "[cli][synth]") {
  const Scratch folder;
  const std::string patch = " --size 6.4um --pixels 64 -o older.csv";
  for (const std::string duty : {"0", "1", "1.5", "-0.5", "nan", "0.5um"})
    check_refused(folder, "synth lamellar" + grating + patch + " --duty " + duty, 2,
                  {"duty", duty});
  check_refused(folder, "synth blazed" + grating + patch + " --facing up", 2,
                {"--facing", "up", "+x", "-x"});
  check_refused(folder, "synth pyramid" + grating + patch, 2, {"pyramid", "blazed", "lamellar"});
  for (const std::string pixels : {"2.5", "64um", "64x64", "1,2,3", "99999999999", ","})
    check_refused(folder, "synth flat --size 6.4um -o older.csv --pixels " + pixels, 2,
                  {"--pixels"});
}

TEST_CASE("a grid too large to read back is not made", "[cli][synth]") {
  const Scratch folder;
  check_refused(folder, "synth flat --size 1mm --pixels 100000 -o older.csv", 2,
                {"--pixels", "100000"});
}
