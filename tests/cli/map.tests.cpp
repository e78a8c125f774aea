#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <sstream>
#include <vector>

#include "tests/cli/gratings.h"
#include "tests/cli/pictures.h"
#include "tests/cli/refusal.h"
#include "tests/cli/sidecars.h"
#include "tests/cli/tables.h"

namespace {

const std::string wavelengths = " --lambda 380:780:5nm";

/// Numbers behind the header of an NPY file of doubles.
std::vector<double> numbers_of(const std::string& npy) {
  const std::size_t head =
      10 + static_cast<unsigned char>(npy.at(8)) + 256u * static_cast<unsigned char>(npy.at(9));
  std::vector<double> numbers((npy.size() - head) / sizeof(double));
  std::memcpy(numbers.data(), npy.data() + head, numbers.size() * sizeof(double));
  return numbers;
}

/// An axis takes no more digits than these; 1e-12 deg are far below what a colour shows.
std::string decimals(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(12) << value;
  return text.str();
}

/// Largest difference of the luminances of two maps.
double worst_y(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double worst = 0;
  for (std::size_t i = 1; i < a.size(); i += 3)
    worst = std::abs(a[i] - b[i]) <= worst ? worst : std::abs(a[i] - b[i]);
  return worst;
}

}  // namespace

TEST_CASE("a pixel of a map has the colour that sweep and colour find there",
          "[cli][map][oracle]") {
  const Scratch folder;
  make_small(folder);
  folder.prepare("map g.gsf --theta-i 20deg --size 33 --tolerance 1e-9" + wavelengths +
                 " -o m.png");
  const auto map = numbers_of(folder.read("m.npy"));
  REQUIRE(map.size() == 33 * 33 * 3);
  CHECK(map[0] == 0);  // a corner, outside the disk
  for (const int column : {3, 16, 20, 29}) {
    const double theta = std::asin((2.0 * column + 1) / 33 - 1) * 180 / 3.14159265358979323846;
    folder.prepare("sweep g.gsf --theta-i 20deg --tolerance 1e-9 --theta-r " + decimals(theta) +
                   "deg" + wavelengths + " -o R.csv");
    folder.prepare("colour R.csv -o c.csv");
    const auto table = table_of(folder.read("c.csv"));
    REQUIRE(table.size() == 2);
    for (std::size_t i = 0; i < 3; ++i) {
      const double expected = value_of(table[1][1 + i]),
                   found = map[(16 * 33 + static_cast<std::size_t>(column)) * 3 + i];
      CAPTURE(column, i);
      // Both amplitudes are within 1e-9 of the flat patch's.
      CHECK(std::abs(found - expected) <= 1e-7 * std::abs(expected) + 1e-8);
    }
  }
}

TEST_CASE("a sheet holds the maps of its lights, with the same bytes for any threads",
          "[cli][map]") {
  const Scratch folder;
  make_small(folder);
  const std::string map = "map g.gsf --phi-i 30deg --size 24 --exposure 5 ";
  folder.prepare(map + "--theta-i 0deg,50deg -o both.png");
  folder.prepare(map + "--theta-i 0deg -o first.png");
  folder.prepare(map + "--theta-i 50deg -o second.png");
  auto joined = numbers_of(folder.read("first.npy"));
  const auto second = numbers_of(folder.read("second.npy"));
  joined.insert(joined.end(), second.begin(), second.end());
  // The plans of one and of two lights differ within the tolerance of 1e-5.
  CHECK(worst_y(numbers_of(folder.read("both.npy")), joined) <= 1e-4);
  CHECK(second != numbers_of(folder.read("first.npy")));
  for (const std::string threads : {"1", "3"}) {
    folder.prepare(map + "--theta-i 0deg,50deg --threads " + threads + " -o t.png");
    CHECK(folder.read("t.npy") == folder.read("both.npy"));
    CHECK(folder.read("t.png") == folder.read("both.png"));
  }
  const auto sidecar = sidecar_of(folder, "both.png");
  CHECK(sidecar["command"] == "map");
  CHECK(sidecar["parameters"]["exposure"] == 5);
  CHECK(sidecar["parameters"]["theta_i_deg"].size() == 2);
  CHECK(sidecar["linear_xyz"]["sha256"] == sha256sum(folder, "both.npy"));
  CHECK(sidecar["error"]["audit"]["worst_error"].get<double>() <= 1e-5);
}

TEST_CASE("the mirror lobe kept apart is left out of the picture, not of the colours",
          "[cli][map]") {
  const Scratch folder;
  make_small(folder);
  const std::string map = "map g.gsf --theta-i 30deg --size 32 --sigma 3um --exposure 5 ";
  folder.prepare(map + "-o shown.png");
  folder.prepare(map + "--mirror-lobe apart -o apart.png");
  CHECK(folder.read("shown.npy") == folder.read("apart.npy"));
  CHECK(folder.read("shown.png") != folder.read("apart.png"));
}

TEST_CASE("the map of a white diffuser is white, by the cosine of the light",
          "[cli][map][oracle]") {
  const Scratch folder;
  make_small(folder);
  folder.prepare("map g.gsf --method lambert --albedo 0.5 --theta-i 60deg --size 16 -o m.png");
  const auto map = numbers_of(folder.read("m.npy"));
  // albedo cos theta_i = 0.25, all over the disk; D65 to the digits of the tables.
  const std::size_t middle = (8 * 16 + 8) * 3;
  CHECK(map[middle] == Approx(0.25 * 0.9505).epsilon(1e-3));
  CHECK(map[middle + 1] == Approx(0.25).epsilon(1e-12));
  CHECK(map[middle + 2] == Approx(0.25 * 1.089).epsilon(1e-3));
  CHECK(map[(8 * 16 + 2) * 3 + 1] == Approx(0.25).epsilon(1e-12));
  folder.prepare(
      "map g.gsf --method microfacet --roughness 0.3 --theta-i 60deg --size 16 -o f.png");
  CHECK(numbers_of(folder.read("f.npy"))[middle + 1] > 0);
}

TEST_CASE("the bands of a grating's orders give its map within 1 % of the white",
          "[cli][map][oracle]") {
  const Scratch folder;
  folder.prepare("synth sinusoid --period 1300nm --height 150nm --size 13um --pixels 200 -o s.gsf");
  const std::string map = "map s.gsf --theta-i 30deg --size 40 --surface periodic --sigma 2um ";
  folder.prepare(map + "--lambda 380:780:1nm -o full.png");
  folder.prepare(map + "--orders-only --period 1300nm -o bands.png");
  folder.prepare(map + "-o adaptive.png");
  const auto full = numbers_of(folder.read("full.npy"));
  CHECK(worst_y(numbers_of(folder.read("bands.npy")), full) <= 1e-2);
  CHECK(worst_y(numbers_of(folder.read("adaptive.npy")), full) <= 1e-3);
  // A wrong period leaves light out: the comparison can fail.
  folder.prepare(map + "--orders-only --period 400nm --band-radius 1 -o wrong.png");
  CHECK(worst_y(numbers_of(folder.read("wrong.npy")), full) > 1e-2);
}

TEST_CASE("maps that cannot be are refused before anything is written", "[cli][map][refusal]") {
  const Scratch folder;
  make_small(folder);
  const auto refused = [&](const std::string& options, const std::vector<std::string>& parts) {
    check_refused(folder, "map g.gsf " + options, 2, parts);
  };
  refused("--theta-i 10deg --size 0 -o m.png", {"--size", "0"});
  refused("--theta-i 10deg --size 5000 -o m.png", {"--size", "5000"});
  refused("--theta-i 95deg -o m.png", {"95"});
  refused("--theta-i 10deg, -o m.png", {"--theta-i"});
  refused("--theta-i 0deg,1deg,2deg,3deg,4deg,5deg,6deg,7deg,8deg,9deg,10deg,11deg,12deg -o m.png",
          {"13 lights", "12"});
  refused("--theta-i 10deg --arcs-azimuth 3deg -o m.png", {"--arcs-azimuth", "--arcs"});
  refused("--theta-i 10deg --orders-only --period 1um --lambda 400:700:5nm -o m.png",
          {"--orders-only", "--lambda"});
  refused("--theta-i 10deg --quantity power -o m.png", {"white"});
  refused("--theta-i 10deg --method taylor -o m.png", {"--method taylor"});
  refused("--theta-i 10deg --colour-tolerance 0 -o m.png", {"--colour-tolerance"});
  refused("--theta-i 10deg --exposure 0 -o m.png", {"--exposure"});
  refused("--theta-i 10deg -o m.npy", {"m.npy"});
  refused("--theta-i 10deg -o g.gsf", {"g.gsf"});
  check_refused(folder, "map g.gsf --theta-i 10deg --memory-limit 1MB -o m.png", 6,
                {"--memory-limit"});
}
