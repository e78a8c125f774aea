#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/cli/height_files.h"
#include "tests/cli/refusal.h"

namespace {

using nlohmann::json;

const std::string grating = " --period 2500nm --height 600nm";
const std::string patch = " --size 6.4um,4.8um --pixels 64,48 -o g.gsf";
constexpr double height_m = 600e-9;

ReadGsf made(const Scratch& folder, const std::string& options) {
  folder.prepare("synth " + options + patch);
  return read_gsf(folder.read("g.gsf"));
}

double bump(double t) {
  return (1 + std::cos(2 * 3.14159265358979323846 * t)) / 2;
}

/// Checks all heights against height_m times a formula of x and y in micrometres.
void check_surface(const std::string& options,
                   const std::function<double(double, double)>& formula) {
  INFO(options);
  const Scratch folder;
  const ReadGsf gsf = made(folder, options);
  REQUIRE(gsf.heights.size() == 64 * 48);
  for (int row = 0; row < 48; ++row)
    for (int col = 0; col < 64; ++col)
      // Heights are stored as floats.
      REQUIRE(gsf.heights[static_cast<std::size_t>(row * 64 + col)] ==
              Approx(height_m * formula((col - 31.5) * 0.1, (row - 23.5) * 0.1))
                  .margin(1e-7 * height_m));
}

}  // namespace

TEST_CASE("turned, crossed and second gratings follow their formulas", "[cli][synth]") {
  const double half = 0.5, root = std::sqrt(3) / 2;
  check_surface("sinusoid --direction 30deg" + grating,
                [=](double x, double y) { return bump((x * root + y * half) / 2.5); });
  check_surface("sinusoid --crossed-period 1.5um" + grating,
                [](double x, double y) { return bump(x / 2.5) * bump(y / 1.5); });
  check_surface(
      "sinusoid --crossed-period 1.5um --crossed-angle 60deg" + grating,
      [=](double x, double y) { return bump(x / 2.5) * bump((x * half + y * root) / 1.5); });
  check_surface("fingers --crossed-period 1.5um" + grating,
                [](double x, double y) { return bump(x / 2.5) * bump(y / 1.5); });
  check_surface("sinusoid --second-period 1.5um" + grating,
                [](double x, double y) { return bump(x / (y > 0 ? 1.5 : 2.5)); });
  // Three quarters of 48 rows: all but those below y = -1.2 um.
  check_surface(
      "sinusoid --direction 90deg --second-period 2um --second-direction 0deg "
      "--second-share 0.75" +
          grating,
      [](double x, double y) { return y > -1.2 ? bump(x / 2) : bump(y / 2.5); });
}

TEST_CASE("averaged lamellar heights have the duty as mean", "[cli][synth]") {
  const Scratch folder;
  // 2 periods on 61 pixels.
  folder.prepare("synth lamellar --duty 0.3 --edges averaged" + grating +
                 " --size 5um,1um --pixels 61,1 -o g.gsf");
  double sum = 0;
  for (const double height : read_gsf(folder.read("g.gsf")).heights) sum += height;
  // Floats: 6e-8 of each height.
  CHECK(sum / 61 == Approx(0.3 * height_m).epsilon(1e-7));
}

TEST_CASE("noise is the same numbers everywhere", "[cli][synth]") {
  const Scratch folder;
  const ReadGsf gsf = made(folder, "flat --noise 3nm");
  // normal_numbers.csv: seed 1, part 4.
  const double numbers[] = {0.4914563341938514, -0.5681600457223494, -0.8503948428554172,
                            -1.450445268808052, 0.6096638745137844};
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(gsf.heights[i] == Approx(3e-9 * numbers[i]).epsilon(1e-7));  // floats
  CHECK(gsf.heights[999] == Approx(3e-9 * 0.9771136418703032).epsilon(1e-7));
}

TEST_CASE("the same seed makes the same file, another seed another", "[cli][synth]") {
  const Scratch folder;
  const std::string disorder =
      "fingers --crossed-period 1.5um --jitter 200nm --noise 2nm" + grating;
  const std::vector<double> unsaid = made(folder, disorder).heights;
  CHECK(made(folder, disorder + " --seed 1").heights == unsaid);
  CHECK(made(folder, disorder + " --jitter-kind position").heights == unsaid);
  CHECK(made(folder, disorder + " --seed 2").heights != unsaid);
  CHECK(made(folder, disorder + " --jitter-kind spacing").heights != unsaid);
}

TEST_CASE("the sidecar of a surface holds everything that was given", "[cli][synth]") {
  const Scratch folder;
  const auto parameters = [&](const std::string& options) {
    made(folder, options);
    return json::parse(folder.read("g.gsf.json")).at("parameters");
  };
  CHECK(parameters("lamellar --duty 0.25 --direction 10deg --crossed-period 3um "
                   "--crossed-angle 70deg --jitter 50nm --jitter-kind spacing --seed 9 "
                   "--noise 2nm --second-period 2um --second-direction 20deg --second-share 0.25" +
                   grating) == json{{"profile", "lamellar"},
                                    {"width_um", 6.4},
                                    {"height_um", 4.8},
                                    {"pixels", {64, 48}},
                                    {"period_nm", 2500.0},
                                    {"peak_to_valley_nm", 600.0},
                                    {"duty", 0.25},
                                    {"direction_deg", 10.0},
                                    {"crossed_period_nm", 3000.0},
                                    {"crossed_angle_deg", 70.0},
                                    {"jitter_nm", 50.0},
                                    {"jitter_kind", "spacing"},
                                    {"second_period_nm", 2000.0},
                                    {"second_direction_deg", 20.0},
                                    {"second_share", 0.25},
                                    {"noise_nm", 2.0},
                                    {"edges", "sampled"},
                                    {"seed", 9},
                                    {"generator", "mt19937_64, AS241"}});
  // What was not given stands there as resolved, and what there is none of does not.
  CHECK(parameters("blazed --edges averaged --jitter 50nm" + grating) ==
        json{{"profile", "blazed"},
             {"width_um", 6.4},
             {"height_um", 4.8},
             {"pixels", {64, 48}},
             {"period_nm", 2500.0},
             {"peak_to_valley_nm", 600.0},
             {"falls_towards", "+x"},
             {"direction_deg", 0.0},
             {"jitter_nm", 50.0},
             {"jitter_kind", "position"},
             {"edges", "averaged"},
             {"seed", 1},
             {"generator", "mt19937_64, AS241"}});
  CHECK(parameters("flat") ==
        json{{"profile", "flat"}, {"width_um", 6.4}, {"height_um", 4.8}, {"pixels", {64, 48}}});
}

TEST_CASE("an option of surfaces that has no meaning is refused", "[cli][synth]") {
  const Scratch folder;
  const std::string file = " --size 6.4um --pixels 64 -o older.csv";
  const auto refused = [&](const std::string& command, const std::vector<std::string>& named) {
    check_refused(folder, "synth " + command + file, 2, named);
  };
  for (const std::string option :
       {"--direction 1deg", "--crossed-period 1um", "--crossed-angle 80deg", "--jitter 1nm",
        "--jitter-kind spacing", "--second-period 1um", "--second-direction 1deg",
        "--second-share 0.5", "--edges sampled"})
    refused("flat " + option, {option.substr(0, option.find(' ')), "flat"});
  refused("flat --seed 3", {"--seed", "--jitter", "--noise"});
  refused("blazed --seed 3" + grating, {"--seed", "--jitter", "--noise"});
  refused("blazed --jitter-kind spacing" + grating, {"--jitter-kind", "--jitter"});
  refused("blazed --crossed-angle 80deg" + grating, {"--crossed-angle", "--crossed-period"});
  refused("blazed --second-direction 80deg" + grating, {"--second-direction", "--second-period"});
  refused("blazed --second-share 0.3" + grating, {"--second-share", "--second-period"});
  refused("fingers" + grating, {"fingers", "--crossed-period"});
  refused("fingers --crossed-period 1um --crossed-angle 80deg" + grating,
          {"--crossed-angle", "fingers"});
  refused("fingers --crossed-period 1um --duty 0.3" + grating, {"--duty", "fingers"});
  for (const std::string pattern :
       {"blazed --direction 10deg", "blazed --crossed-period 1um", "fingers --crossed-period 1um",
        "blazed --second-period 1um --second-direction 10deg"})
    refused(pattern + " --edges averaged" + grating, {"edges averaged", "along x"});
}

TEST_CASE("values that no surface has are refused", "[cli][synth]") {
  const Scratch folder;
  const std::string file = " --size 64um --pixels 64 -o older.csv";
  const auto refused = [&](const std::string& options, const std::vector<std::string>& named) {
    check_refused(folder, "synth blazed " + options + grating + file, 2, named);
  };
  refused("--jitter 625nm", {"jitter", "0.625 um", "a quarter of the period 2.5 um"});
  // One pair of lines in 600 crosses at this jitter; there are 2400.
  check_refused(folder, "synth blazed --jitter 0.6um --size 6mm --pixels 64 -o older.csv" + grating,
                2, {"jitter", "0.6 um", "cross", "seed"});
  refused("--jitter 300nm --crossed-period 1um", {"jitter", "0.3 um", "1 um"});
  refused("--jitter 300nm --second-period 1um", {"second grating", "jitter", "0.3 um", "1 um"});
  refused("--jitter 5%", {"--jitter", "5%"});
  refused("--jitter 5nm --jitter-kind both", {"--jitter-kind", "both", "position", "spacing"});
  for (const std::string seed : {"-1", "2.5", "2147483648", "one"})
    refused("--jitter 5nm --seed " + seed, {"--seed"});
  refused("--noise 5", {"--noise", "5", "nm"});
  refused("--edges soft", {"--edges", "soft", "sampled", "averaged"});
  refused("--direction 5", {"--direction", "5", "deg"});
  refused("--crossed-period 0um", {"crossed period 0 um"});
  for (const std::string angle : {"0", "180", "200"})
    refused("--crossed-period 1um --crossed-angle " + angle + "deg",
            {"crossed angle " + angle + " deg", "180"});
  for (const std::string share : {"0", "1", "1.5"})
    refused("--second-period 1um --second-share " + share, {"second share " + share});
}
