#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <sstream>

#include "tests/cli/gratings.h"
#include "tests/cli/pictures.h"
#include "tests/cli/pixels.h"
#include "tests/cli/refusal.h"
#include "tests/cli/sidecars.h"
#include "tests/cli/tables.h"

namespace {

using Json = nlohmann::json;

const std::string wavelengths = " --lambda 380:780:5nm --sigma 16.25um --tolerance 1e-8";
const std::string square =
    "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "f 1/1 2/2 3/3 4/4\n";

Json probed(const Scratch& folder, const std::string& command) {
  const Outcome outcome = folder.shedlight(command);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

std::string digits(const Json& value) {
  return value.dump();
}

/// An axis takes no more digits than these; 1e-12 deg are far below what a colour shows.
std::string decimals(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(12) << value;
  return text.str();
}

}  // namespace

TEST_CASE("a pixel has the colour that sweep and colour find at its directions",
          "[cli][render][oracle]") {
  const Scratch folder;
  make_grating(folder);
  const std::string scene = "render g.gsf" + wavelengths +
                            " --light 40deg,20deg --rotate 10deg,-15deg,5deg --size 48 "
                            "--camera perspective --exposure 0.7";
  folder.prepare(scene + " -o p.png");
  const Pixels picture = pixels_of(folder.read("p.png"));
  std::size_t lit = 0;
  for (const auto& [col, row] : {std::pair{24, 24}, {30, 20}, {36, 12}, {20, 31}}) {
    const std::string pixel = std::to_string(col) + "," + std::to_string(row);
    INFO("pixel " << pixel);
    const Json shown = probed(folder, scene + " --probe " + pixel);
    if (shown["shows"] != "lit") continue;
    ++lit;
    const double theta_r = shown["theta_r_deg"];
    folder.prepare("sweep g.gsf" + wavelengths + " --theta-i " + digits(shown["theta_i_deg"]) +
                   "deg --phi-i " + digits(shown["phi_i_deg"]) + "deg --phi-r " +
                   digits(shown["phi_r_deg"]) + "deg --theta-r " + decimals(theta_r) +
                   "deg -o R.csv");
    folder.shedlight("colour R.csv --exposure 0.7 -o c.csv");
    const std::vector<Cells> table = table_of(folder.read("c.csv"));
    REQUIRE(table.size() == 2);
    CHECK(std::abs(value_of(table[1][0]) - theta_r) <= 1e-9);
    for (std::size_t i = 0; i < 3; ++i) {
      // Both within 1e-8 of the amplitude; a colour is a mean of its squares.
      const double expected = value_of(table[1][i + 1]), found = shown["xyz"][i];
      CHECK(std::abs(found - expected) <= 1e-5 * std::abs(expected) + 1e-9);
      const int code = picture.at(static_cast<std::size_t>(col), static_cast<std::size_t>(row))[i];
      CHECK(code == shown["rgb"][i].get<int>());
      CHECK(std::abs(code - 255 * value_of(table[1][i + 4])) <= 1);
    }
  }
  CHECK(lit >= 3);
}

TEST_CASE("a picture has the size asked for and says how it was made", "[cli][render]") {
  const Scratch folder;
  make_grating(folder);
  folder.write("s.obj", square);
  const std::string command = "render g.gsf" + wavelengths +
                              " --shape s.obj --light 10deg,0deg --rotate 0deg,20deg,0deg --size "
                              "24,16 --background 0,0,1 ";
  folder.prepare(command + "-o p.png");
  const Pixels picture = pixels_of(folder.read("p.png"));
  CHECK((picture.cols == 24 && picture.rows == 16));
  CHECK(picture.at(0, 0) == std::array<int, 3>{0, 0, 255});
  CHECK(picture.at(12, 8) != std::array<int, 3>{0, 0, 255});
  const Json sidecar = sidecar_of(folder, "p.png");
  CHECK(sidecar["command"] == "render");
  CHECK(sidecar["scene_files"][0]["sha256"] == sha256sum(folder, "s.obj"));
  CHECK(sidecar["parameters"]["exposure_by"].get<std::string>().starts_with("auto"));
  CHECK(sidecar["parameters"]["blend"] == 1);
  // The exposure found gives the same picture.
  folder.prepare(command + "--exposure " + digits(sidecar["parameters"]["exposure"]) +
                 " -o given.png");
  CHECK(folder.read("given.png") == folder.read("p.png"));
  for (const std::string threads : {"1", "3"}) {
    folder.prepare(command + "--threads " + threads + " -o t.png");
    CHECK(folder.read("t.png") == folder.read("p.png"));
  }
}

TEST_CASE("a picture from a volume is the picture from the heights", "[cli][render][oracle]") {
  const Scratch folder;
  folder.prepare("synth blazed --period 1600nm --height 250nm --size 6.4um --pixels 64 -o g.gsf");
  folder.prepare("bake g.gsf --sigma 1.5um --colour-tolerance 2e-2 -o v.npy");
  const std::string scene =
      " --light 40deg,20deg --rotate 10deg,-15deg,5deg --size 48 --exposure 20";
  folder.prepare("render g.gsf --sigma 1.5um" + scene + " -o heights.png");
  folder.prepare("render v.npy" + scene + " -o volume.png");
  const Pixels heights = pixels_of(folder.read("heights.png")),
               volume = pixels_of(folder.read("volume.png"));
  REQUIRE(heights.codes.size() == volume.codes.size());
  int worst = 0, largest = 0;
  for (std::size_t i = 0; i < heights.codes.size(); ++i) {
    worst = std::max(worst, std::abs(heights.codes[i] - volume.codes[i]));
    largest = std::max<int>(largest, heights.codes[i]);
  }
  // 2 % of linear light are 0.8 % of a code, 2 of 255, and a rounding.
  CHECK(worst <= 3);
  CHECK(largest > 200);
  // The same pixel, looked up alone.
  const std::string probe = scene + " --probe 30,20";
  const Json baked = probed(folder, "render v.npy" + probe),
             exact = probed(folder, "render g.gsf --sigma 1.5um" + probe);
  REQUIRE(exact["shows"] == "lit");
  CHECK(baked["theta_r_deg"] == exact["theta_r_deg"]);
  CHECK(baked["rgb"] == Json(volume.at(30, 20)));
  CHECK(exact["rgb"] == Json(heights.at(30, 20)));
}

TEST_CASE("without a share of diffraction a diffuse colour is left, by the cosine of the light",
          "[cli][render]") {
  const Scratch folder;
  make_grating(folder);
  folder.write("s.obj", square);
  const std::string command = "render g.gsf" + wavelengths +
                              " --shape s.obj --light 60deg,90deg --size 9 --exposure 1 --blend 0 ";
  // Half of linear 0.2140 (code 0.5) is 0.1070, encoded 0.3613; half of 1 is 0.7354.
  folder.prepare(command + "--diffuse 0.5,1,0 -o p.png");
  const std::array<int, 3> expected{92, 188, 0};
  CHECK(pixels_of(folder.read("p.png")).at(4, 4) == expected);
  // A texture of one colour is that colour.
  folder.prepare("render g.gsf" + wavelengths +
                 " --light 0deg,0deg --size 1 --exposure 1 --blend 0 --diffuse 0.5,1,0 "
                 "-o texture.png");
  folder.prepare(command + "--texture texture.png -o p.png");
  CHECK(pixels_of(folder.read("p.png")).at(4, 4) == expected);
  CHECK(sidecar_of(folder, "p.png")["scene_files"][1]["file"] == "texture.png");
}

TEST_CASE("a probe says why a pixel shows nothing", "[cli][render]") {
  const Scratch folder;
  make_grating(folder);
  const std::string command = "render g.gsf" + wavelengths + " --size 33 ";
  CHECK(probed(folder, command + "--light 10deg,0deg --probe 0,0")["shows"] == "background");
  CHECK(probed(folder, command + "--light 120deg,0deg --probe 16,16")["shows"] == "unlit");
  const Json undirected =
      probed(folder, command + "--light 10deg,0deg --along 0,0,1 --probe 16,16");
  CHECK(undirected["shows"] == "no direction of the grating");
  // At the centre the normal is the viewing axis; the light is 30 deg from it, turned by -90.
  const Json lit = probed(folder, command +
                                      "--light 30deg,90deg --orientation 90deg "
                                      "--probe 16,16");
  CHECK(lit["shows"] == "lit");
  CHECK(std::abs(lit["theta_i_deg"].get<double>() - 30) <= 1e-9);
  CHECK(std::abs(lit["phi_i_deg"].get<double>()) <= 1e-9);
  CHECK(std::abs(lit["theta_r_deg"].get<double>()) <= 1e-9);
}

TEST_CASE("scenes that have no meaning are refused", "[cli][render][refusal]") {
  const Scratch folder;
  make_grating(folder);
  folder.write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("bad.obj", "v 0 0 nan\n");
  folder.write("s.obj", square);
  folder.write("field.txt", "1 0 0\n");
  folder.write("t.png", "no picture");
  const std::string command = "render g.gsf --light 10deg,0deg -o older.csv ";
  check_refused(folder, command + "--shape bare.obj", 3, {"bare.obj", "--along"});
  check_refused(folder, command + "--shape bad.obj", 3, {"bad.obj", "line 1", "nan"});
  check_refused(folder, command + "--shape none.obj", 3, {"none.obj"});
  check_refused(folder, command + "--shape cube", 2, {"--shape", "cube", "FILE.obj"});
  check_refused(folder, command + "--shape s.obj --direction-field field.txt", 3,
                {"field.txt", "1 vectors", "4 vertices"});
  check_refused(folder, command + "--direction-field field.txt", 2, {"--direction-field"});
  check_refused(folder, command + "--texture t.png", 3, {"t.png"});
  check_refused(folder, command + "--blend 0.5", 2, {"--blend", "--diffuse"});
  check_refused(folder, command + "--blend 2", 2, {"--blend", "0 to 1"});
  check_refused(folder, command + "--diffuse 1,2,0", 2, {"--diffuse", "2"});
  check_refused(folder, command + "--size 0", 2, {"--size"});
  check_refused(folder, command + "--size 16384", 2, {"16777216"});
  check_refused(folder, command + "--along 0,0,0", 2, {"--along"});
  check_refused(folder, command + "--rotate 1deg,2deg", 2, {"--rotate", "AX,AY,AZ"});
  for (const std::string exposure : {"0", "-1", "nan", "two"})
    check_refused(folder, command + "--exposure " + exposure, 2, {"--exposure", exposure});
  check_refused(folder, command + "--light 180deg,0deg", 2, {"--light"});
  check_refused(folder, "render g.gsf --light 10,0 -o older.csv", 2, {"--light", "no unit"});
  check_refused(folder, "render g.gsf -o older.csv", 2, {"--light"});
  check_refused(folder, "render g.gsf --light 1deg,0deg", 2, {"--output"});
  check_refused(folder, "render g.gsf --light 1deg,0deg --probe 512,0", 2, {"--probe", "512"});
  check_refused(folder, "render g.gsf --light 1deg,0deg --probe 1,1 --exposure auto", 2, {"auto"});
  for (const std::string input : {"g.gsf", "s.obj"})
    check_refused(folder, "render g.gsf --light 1deg,0deg --shape s.obj -o " + input, 2, {input});
}
