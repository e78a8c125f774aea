#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "tests/cli/colour_maps.h"
#include "tests/cli/gratings.h"
#include "tests/cli/pictures.h"
#include "tests/cli/pixels.h"
#include "tests/cli/refusal.h"
#include "tests/cli/sidecars.h"
#include "tests/cli/tables.h"

namespace {

const std::string wavelengths = " --lambda 380:780:5nm";

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
    folder.prepare("sweep g.gsf --theta-i 20deg --tolerance 1e-9 --theta-r " +
                   angle_at(place_of(column, 33)) + wavelengths + " -o R.csv");
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

TEST_CASE("rows of a map run towards larger y", "[cli][map][oracle]") {
  const Scratch folder;
  make_small(folder);
  folder.prepare("map g.gsf --theta-i 20deg --phi-i 90deg --size 33 --tolerance 1e-9" +
                 wavelengths + " -o m.png");
  const auto map = numbers_of(folder.read("m.npy"));
  REQUIRE(map.size() == 33 * 33 * 3);
  for (const int row : {4, 10, 22, 28}) {
    folder.prepare(
        "sweep g.gsf --theta-i 20deg --phi-i 90deg --phi-r 90deg --tolerance 1e-9 --theta-r " +
        angle_at(place_of(row, 33)) + wavelengths + " -o R.csv");
    folder.prepare("colour R.csv -o c.csv");
    const auto table = table_of(folder.read("c.csv"));
    REQUIRE(table.size() == 2);
    const auto y = [&](int of_row) {
      return map[(static_cast<std::size_t>(of_row) * 33 + 16) * 3 + 1];
    };
    const double expected = value_of(table[1][2]);
    CAPTURE(row);
    // Both amplitudes are within 1e-9 of the flat patch's.
    CHECK(std::abs(y(row) - expected) <= 1e-7 * expected + 1e-8);
    // The mirror direction lies at -sin 20 deg: the other way round it is another colour.
    CHECK(std::abs(y(32 - row) - expected) > 1e-2 * expected);
  }
}

TEST_CASE("a map is a picture, its colours beside it and what they were made of", "[cli][map]") {
  const Scratch folder;
  make_small(folder);
  folder.prepare("map g.gsf --theta-i 10deg,40deg,70deg --size 21 --exposure 2.5 -o m.png");
  // The grating, the picture, and their sidecars; the colours.
  CHECK(folder.contents().size() == 5);
  const std::string png = folder.read("m.png");
  CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(png.substr(png.size() - 8, 4) == "IEND");
  const Npy npy = npy_of(folder.read("m.npy"));
  CHECK_THAT(npy.header, Catch::StartsWith("{'descr': '<f8', 'fortran_order': False, "
                                           "'shape': (3, 21, 21, 3), }"));
  REQUIRE(npy.numbers.size() == 3 * 21 * 21 * 3);
  int outside = 0, inside = 0, dark_inside = 0, lit_outside = 0;
  for (int light = 0; light < 3; ++light)
    for (int row = 0; row < 21; ++row)
      for (int column = 0; column < 21; ++column) {
        const auto at = static_cast<std::size_t>(((light * 21 + row) * 21 + column) * 3);
        const bool dark =
            npy.numbers[at] == 0 && npy.numbers[at + 1] == 0 && npy.numbers[at + 2] == 0;
        const bool in = in_disk(column, row, 21);
        ++(in ? inside : outside);
        if (in && dark) ++dark_inside;
        if (!in && !dark) ++lit_outside;
      }
  CHECK(lit_outside == 0);
  CHECK(dark_inside == 0);
  CHECK(outside > 0);
  const auto sidecar = sidecar_of(folder, "m.png");
  CHECK(sidecar["input"]["sha256"] == sha256sum(folder, "g.gsf"));
  CHECK(sidecar["output"]["sha256"] == sha256sum(folder, "m.png"));
  CHECK(sidecar["linear_xyz"]["file"] == "m.npy");
  const auto& p = sidecar["parameters"];
  CHECK(p["theta_i_deg"] == nlohmann::json({10.0, 40.0, 70.0}));
  CHECK(p["size"] == 21);
  CHECK(p["exposure"] == 2.5);
  CHECK(p["exposure_by"] == "given");
  CHECK(p["mirror_lobe"] == "shown");
  CHECK(p["pixels"] == inside);
}

TEST_CASE("twice the exposure is twice the light of a code, and leaves the colours",
          "[cli][map][oracle]") {
  const Scratch folder;
  make_small(folder);
  const std::string map = "map g.gsf --method lambert --albedo 0.5 --theta-i 60deg --size 64 ";
  folder.prepare(map + "--exposure 1 -o once.png");
  folder.prepare(map + "--exposure 2 -o twice.png");
  CHECK(folder.read("once.npy") == folder.read("twice.npy"));
  // Grey of 0.25 is 1.055 0.25^(1/2.4) - 0.055 = 0.5371 in sRGB, and 0.5 is 0.7354; the white of
  // sRGB is D65 to four digits, which moves a code by less than one.
  const Code once = commonest_code(pixels_of(folder.read("once.png"))),
             twice = commonest_code(pixels_of(folder.read("twice.png")));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::abs(once[i] - 137) <= 1);
    CHECK(std::abs(twice[i] - 188) <= 1);
  }
}

TEST_CASE("the luminance of rough facets is pi times their BRDF and the cosine of the light",
          "[cli][map][oracle]") {
  const Scratch folder;
  make_small(folder);
  const std::string facets = " g.gsf --method microfacet --roughness 0.3 --theta-i 50deg ";
  folder.prepare("map" + facets + "--size 33 -o m.png");
  const auto map = numbers_of(folder.read("m.npy"));
  REQUIRE(map.size() == 33 * 33 * 3);
  for (const int column : {2, 9, 16, 30}) {
    folder.prepare("sweep" + facets + "--quantity brdf --lambda 500nm --theta-r " +
                   angle_at(place_of(column, 33)) + " -o R.csv");
    const auto table = table_of(folder.read("R.csv"));
    REQUIRE(table.size() == 2);
    const double expected = 3.14159265358979323846 * 0.64278760968653933 *  // cos 50 deg
                            value_of(table[1][1]);
    CAPTURE(column);
    // Sums of 81 wavelengths, and a table of white whose Y is 1 to rounding.
    CHECK(std::abs(map[(16 * 33 + static_cast<std::size_t>(column)) * 3 + 1] - expected) <=
          1e-12 * expected);
  }
}

TEST_CASE("a map that is refused leaves the older one", "[cli][map][refusal]") {
  const Scratch folder;
  make_small(folder);
  for (const std::string name : {"m.png", "m.npy", "m.png.json"}) folder.write(name, "older");
  check_refused(folder, "map g.gsf --theta-i 10deg,91deg -o m.png", 2, {"--theta-i", "91"});
  check_refused(folder, "map g.gsf --theta-i 10deg --method taylor -o m.png", 2, {"taylor"});
  check_refused(folder, "map g.gsf --theta-i 10deg --memory-limit 1MB -o m.png", 6,
                {"--memory-limit"});
  check_refused(folder,
                "map g.gsf --theta-i 10deg --size 2048 --lambda 380:780:1nm "
                "--method direct --time-limit 100ms -o m.png",
                6, {"--time-limit"});
}

TEST_CASE("maps that cannot be are refused before anything is written", "[cli][map][refusal]") {
  const Scratch folder;
  make_small(folder);
  const auto refused = [&](const std::string& options, const std::vector<std::string>& parts) {
    check_refused(folder, "map g.gsf " + options, 2, parts);
  };
  refused("--theta-i 10deg --size 0 -o m.png", {"--size", "0"});
  refused("--theta-i 10deg --size 5000 -o m.png", {"--size", "5000"});
  refused("--theta-i 95deg -o m.png", {"--theta-i", "95"});
  refused("--theta-i 10deg, -o m.png", {"--theta-i"});
  refused("--theta-i 0deg,1deg,2deg,3deg,4deg,5deg,6deg,7deg,8deg,9deg,10deg,11deg,12deg -o m.png",
          {"13 lights", "12"});
  refused("--theta-i 10deg --arcs-azimuth 3deg -o m.png", {"--arcs-azimuth", "--arcs"});
  refused("--theta-i 10deg --orders-only --period 1um --lambda 400:700:5nm -o m.png",
          {"--orders-only", "--lambda"});
  for (const std::string quantity : {"power", "brdf"})
    refused("--theta-i 10deg --quantity " + quantity + " -o m.png",
            {"--quantity " + quantity, "white"});
  refused("--theta-i 10deg --method taylor -o m.png", {"--method taylor"});
  refused("--theta-i 10deg --colour-tolerance 0 -o m.png", {"--colour-tolerance"});
  refused("--theta-i 10deg --exposure 0 -o m.png", {"--exposure"});
  refused("--theta-i 10deg -o m.npy", {"m.npy"});
  refused("--theta-i 10deg -o g.gsf", {"g.gsf"});
  check_refused(folder, "map g.gsf --theta-i 10deg --memory-limit 1MB -o m.png", 6,
                {"--memory-limit"});
}
