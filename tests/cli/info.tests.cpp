#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/height_files.h"
#include "tests/cli/program.h"

using nlohmann::json;

namespace {

/// `info --json` of a picture 0.8 um wide whose full-scale code is 255 nm high.
json info(const Png& png) {
  const Scratch folder;
  folder.write("scan.png", png_bytes(png));
  const Outcome outcome =
      folder.shedlight("info scan.png --width 0.8um --height-range 255nm --json");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  return json::parse(outcome.out);
}

void check_heights_nm(const json& info, double lowest, double highest, double mean, double step) {
  INFO(info.dump(1));
  CHECK(info.at("height_min_um").get<double>() == Approx(lowest / 1e3).margin(1e-12));
  CHECK(info.at("height_max_um").get<double>() == Approx(highest / 1e3).margin(1e-12));
  CHECK(info.at("height_mean_um").get<double>() == Approx(mean / 1e3).margin(1e-12));
  CHECK(info.at("height_step_um").get<double>() == Approx(step / 1e3).margin(1e-12));
}

// 48 codes 0 to 47, so that every pixel is told from every other.
unsigned ramp(std::uint32_t row, std::uint32_t col, int) {
  return 8 * row + col;
}
// A slope along the columns alone: 1 code a pixel.
unsigned slope(std::uint32_t, std::uint32_t col, int) {
  return col;
}

}  // namespace

TEST_CASE("an 8-bit grey picture is scaled by its full-scale code", "[cli][info]") {
  const json result = info({.code = ramp});
  check_heights_nm(result, 0, 47, 23.5, 1);
  CHECK(result.at("columns") == 8);
  CHECK(result.at("rows") == 6);
  CHECK(result.at("pixel_um").at(0).get<double>() == Approx(0.1));
  CHECK(result.at("size_um").at(1).get<double>() == Approx(0.6));
  CHECK_THAT(result.at("format").get<std::string>(), Catch::Contains("8 bit"));
  // sqrt((48^2 - 1) / 12)
  CHECK(result.at("height_rms_um").get<double>() == Approx(0.013853399198990));
}

TEST_CASE("a 16-bit grey picture keeps its low bytes", "[cli][info]") {
  const json result = info({.bits = 16, .code = [](auto row, auto col, int channel) {
                              return 257 * ramp(row, col, channel) + (row == 0 && col == 0);
                            }});
  // Code 257 n of 65535 is n nanometres of 255; the first code is 1.
  check_heights_nm(result, 1.0 / 257, 47, 23.5 + 1.0 / 257 / 48, 1.0 / 257);
  CHECK_THAT(result.at("format").get<std::string>(), Catch::Contains("16 bit"));
}

TEST_CASE("grey of 1, 2 and 4 bits reaches full scale at its largest code", "[cli][info]") {
  for (const int bits : {1, 2, 4}) {
    INFO(bits);
    const unsigned top = (1u << bits) - 1;
    const json result =
        info({.bits = bits, .code = [top](auto, auto col, int) { return col < 4 ? 0 : top; }});
    check_heights_nm(result, 0, 255, 127.5, 255.0 / top);
  }
}

TEST_CASE("grey stored as colour is read as grey", "[cli][info]") {
  const auto opaque = [](int alpha) {
    return [alpha](auto row, auto col, int channel) {
      return channel == alpha ? 255u : ramp(row, col, channel);
    };
  };
  check_heights_nm(info({.colour = Png::Colour::rgb, .code = ramp}), 0, 47, 23.5, 1);
  check_heights_nm(info({.colour = Png::Colour::rgba, .code = opaque(3)}), 0, 47, 23.5, 1);
  check_heights_nm(info({.colour = Png::Colour::grey_alpha, .code = opaque(1)}), 0, 47, 23.5, 1);
  check_heights_nm(
      info({.bits = 16,
            .colour = Png::Colour::rgb,
            .code = [](auto row, auto col, int channel) { return 257 * ramp(row, col, channel); }}),
      0, 47, 23.5, 1.0 / 257);
}

TEST_CASE("a palette is read by its colours, whatever the bits of its index", "[cli][info]") {
  for (const int bits : {2, 4, 8}) {
    INFO(bits << " bits");
    // Each of the four greys is the height of 12 pixels.
    const json result = info({.bits = bits,
                              .colour = Png::Colour::palette,
                              .code = [](auto, auto col, int) { return col % 4; },
                              .palette = {200, 10, 31, 7}});
    check_heights_nm(result, 7, 200, 62, 1);
  }
}

TEST_CASE("an interlaced picture holds the same heights", "[cli][info]") {
  json plain = info({.cols = 19, .rows = 13, .code = ramp});
  json interlaced = info({.cols = 19, .rows = 13, .interlaced = true, .code = ramp});
  CHECK(plain.at("sha256") != interlaced.at("sha256"));
  plain.erase("sha256");
  interlaced.erase("sha256");
  CHECK(plain == interlaced);
}

TEST_CASE("the columns of a picture run along x, its rows along y", "[cli][info]") {
  // 1 nm a pixel of 100 nm: atan(0.01).
  constexpr double tilt_deg = 0.572938697683486;
  const json along_x = info({.code = slope}).at("tilt_deg");
  CHECK(along_x.at(0).get<double>() == Approx(tilt_deg));
  CHECK(along_x.at(1).get<double>() == Approx(0).margin(1e-9));
  const json along_y = info({.code = [](auto row, auto, int) { return row; }}).at("tilt_deg");
  CHECK(along_y.at(0).get<double>() == Approx(0).margin(1e-9));
  CHECK(along_y.at(1).get<double>() == Approx(tilt_deg));
}

TEST_CASE("a GSF of non-square pixels keeps both sides", "[cli][info]") {
  const Scratch folder;
  Gsf gsf{.cols = 8,
          .rows = 4,
          .lines = "XReal = 0.8\nYReal = 1.2\nXYUnits = um\nZUnits = nm\nTitle = a = b\n"};
  for (int i = 0; i < 32; ++i) gsf.heights.push_back(static_cast<float>(i));
  folder.write("scan.gsf", gsf_bytes(gsf));
  const json result = json::parse(folder.shedlight("info scan.gsf --json").out);
  CHECK(result.at("pixel_um").at(0).get<double>() == Approx(0.1));
  CHECK(result.at("pixel_um").at(1).get<double>() == Approx(0.3));
  CHECK(result.at("height_max_um").get<double>() == Approx(0.031));
  // The user's word goes before the file's.
  const json pixel =
      json::parse(folder.shedlight("info scan.gsf --json --pixel 50nm,70nm").out).at("pixel_um");
  CHECK(pixel.at(0).get<double>() == Approx(0.05));
  CHECK(pixel.at(1).get<double>() == Approx(0.07));
  const json unit = json::parse(folder.shedlight("info scan.gsf --json --height-unit 2nm").out);
  CHECK(unit.at("height_max_um").get<double>() == Approx(0.062));
}

TEST_CASE("reducing averages blocks and keeps the size", "[cli][info]") {
  const Scratch folder;
  folder.write("scan.png", png_bytes({.code = slope}));
  const json result = json::parse(
      folder.shedlight("info scan.png --width 0.8um --height-range 255nm --reduce 2 --json").out);
  CHECK(result.at("columns") == 4);
  CHECK(result.at("rows") == 3);
  CHECK(result.at("size_um").at(0).get<double>() == Approx(0.8));
  CHECK(result.at("height_min_um").get<double>() == Approx(0.0005));
  CHECK(result.at("height_max_um").get<double>() == Approx(0.0065));
}

TEST_CASE("levelling takes the mean or the plane off", "[cli][info]") {
  const Scratch folder;
  folder.write("scan.png", png_bytes({.code = slope}));
  const std::string command = "info scan.png --width 0.8um --height-range 255nm --json --level ";
  const json none = json::parse(folder.shedlight(command + "none").out);
  const json mean = json::parse(folder.shedlight(command + "mean").out);
  const json plane = json::parse(folder.shedlight(command + "plane").out);
  CHECK(none.at("height_min_um") == 0.0);
  CHECK(mean.at("height_min_um").get<double>() == Approx(-0.0035));
  CHECK(mean.at("height_max_um").get<double>() == Approx(0.0035));
  CHECK(plane.at("height_max_um").get<double>() == Approx(0).margin(1e-12));
}

TEST_CASE("info tells people what the JSON tells programs", "[cli][info]") {
  const Scratch folder;
  folder.write("scan.png", png_bytes({.code = ramp}));
  const Outcome outcome = folder.shedlight("info scan.png --width 0.8um --height-range 255nm");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  CHECK_THAT(outcome.out, Catch::Contains("scan.png") && Catch::Contains("8 bit") &&
                              Catch::Contains("8 x 6") && Catch::Contains("0.1") &&
                              Catch::Contains("0.047"));
}
