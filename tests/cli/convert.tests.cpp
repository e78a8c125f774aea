#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/colour_maps.h"
#include "tests/cli/gratings.h"
#include "tests/cli/height_files.h"
#include "tests/cli/refusal.h"

using nlohmann::json;

namespace {

/// A folder with scan.gsf: heights with no short decimal, pixels that are not square.
void make_scan(const Scratch& folder) {
  Gsf gsf{.cols = 5,
          .rows = 3,
          .lines =
              "XReal = 1e-6\nYReal = 1.5e-6\nXYUnits = m\nZUnits = m\n"
              "Title = Topography\n"};
  for (int i = 0; i < 15; ++i) gsf.heights.push_back(static_cast<float>(std::sin(i) * 1e-7));
  folder.write("scan.gsf", gsf_bytes(gsf));
}

/// The numbers behind the header of an NPY of version 1 with "<f8", checked with its shape.
std::vector<double> npy_numbers(const std::string& bytes, const std::string& shape) {
  REQUIRE(bytes.size() > 10);
  const std::size_t begin =
      10u + static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
  const std::string header = bytes.substr(10, begin - 10);
  CHECK_THAT(header, Catch::Contains("'descr': '<f8', 'fortran_order': False, 'shape': " + shape));
  std::vector<double> numbers((bytes.size() - begin) / sizeof(double));
  std::memcpy(numbers.data(), bytes.data() + begin, numbers.size() * sizeof(double));
  return numbers;
}

json info(const Scratch& folder, const std::string& arguments) {
  const Outcome outcome = folder.shedlight("info " + arguments + " --json");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return json::parse(outcome.out);
}

}  // namespace

TEST_CASE("heights read back the same from NPY and text", "[cli][convert][invariant]") {
  const Scratch folder;
  make_scan(folder);
  const std::string npy_scale = " --pixel 0.2um,0.5um --height-unit 1um";
  folder.prepare("convert scan.gsf -o direct.npy");
  const std::string direct = folder.read("direct.npy");
  CHECK(npy_numbers(direct, "(3, 5)").size() == 15);
  folder.prepare("convert scan.gsf -o scan.txt");
  folder.prepare("convert scan.txt -o from_text.npy");
  folder.prepare("convert direct.npy -o from_npy.txt" + npy_scale);
  folder.prepare("convert from_npy.txt -o from_both.npy");
  // Not compared inside CHECK: it would print the bytes.
  const bool text_is_same = folder.read("from_text.npy") == direct;
  const bool both_are_same = folder.read("from_both.npy") == direct;
  CHECK(text_is_same);
  CHECK(both_are_same);
  // A picture of GSF holds 32 bits of metres.
  folder.prepare("convert scan.txt -o again.gsf");
  CHECK(read_gsf(folder.read("again.gsf")).heights == read_gsf(folder.read("scan.gsf")).heights);
}

TEST_CASE("an NPY of heights is in micrometres and has its axes beside it", "[cli][convert]") {
  const Scratch folder;
  make_scan(folder);
  folder.prepare("convert scan.gsf -o h.npy");
  const auto heights = npy_numbers(folder.read("h.npy"), "(3, 5)");
  const auto metres = read_gsf(folder.read("scan.gsf")).heights;
  REQUIRE(heights.size() == metres.size());
  for (std::size_t i = 0; i < heights.size(); ++i) CHECK(heights[i] == metres[i] * 1e6);
  const auto x = npy_numbers(folder.read("h.x_um.npy"), "(5, )");
  const auto y = npy_numbers(folder.read("h.y_um.npy"), "(3, )");
  REQUIRE(x.size() == 5);
  REQUIRE(y.size() == 3);
  CHECK(x[0] == Approx(-0.4));
  CHECK(x[2] == 0);
  CHECK(y[2] == Approx(0.5));
  const json sidecar = json::parse(folder.read("h.npy.json"));
  CHECK(sidecar.at("command") == "convert");
  CHECK(sidecar.at("parameters").at("height_unit") == "um");
  CHECK(sidecar.at("parameters").at("pixel_um").at(1).get<double>() == Approx(0.5));
  CHECK(sidecar.at("axes").at("x_um").at("file") == "h.x_um.npy");
}

TEST_CASE("a text of heights has the header of Gwyddion", "[cli][convert]") {
  const Scratch folder;
  make_scan(folder);
  folder.prepare("convert scan.gsf --level mean -o h.txt");
  const std::string text = folder.read("h.txt");
  CHECK_THAT(text, Catch::Contains("# Width: 1") && Catch::Contains("# Value units: µm\n"));
  const json read = info(folder, "h.txt");
  CHECK(read.at("height_mean_um").get<double>() == Approx(0).margin(1e-16));
  CHECK(read.at("size_um").at(1).get<double>() == Approx(1.5));
  CHECK(read.at("unit_um") == 1);
}

TEST_CASE("another kind of output is refused with those there are", "[cli][convert][refusal]") {
  const Scratch folder;
  make_scan(folder);
  for (const std::string output : {"older.csv", "h.png", "h", "gsf"})
    check_refused(folder, "convert scan.gsf -o " + output, 2, {output, ".gsf, .npy or .txt"});
  for (const std::string output : {"h.GSF", "h.Npy", "h.TXT"})
    folder.prepare("convert scan.gsf -o " + output);
  check_refused(folder, "convert scan.gsf -o scan.gsf", 2, {"scan.gsf", "is the input"});
  for (const std::string output : {"nowhere/h.gsf", "nowhere/h.npy", "nowhere/h.txt"})
    check_refused(folder, "convert scan.gsf -o " + output, 4, {output});
  std::filesystem::create_directory(folder / "n.x_um.npy");
  check_refused(folder, "convert scan.gsf -o n.npy", 4, {"n.x_um.npy"});
  check_refused(folder, "convert scan.gsf --channel 2 -o h.txt", 2, {"--channel"});
}

TEST_CASE("missing pixels are filled where that is asked for, and counted", "[cli][convert]") {
  const Scratch folder;
  folder.write("scan.csv", "1,2\n,4\n");
  const std::string scale = "scan.csv --pixel 1um --height-unit 1nm";
  check_refused(folder, "convert " + scale + " -o h.npy", 3, {"row 1, column 0", "--missing"});
  folder.prepare("convert " + scale + " --missing neighbours -o h.npy");
  CHECK(npy_numbers(folder.read("h.npy"), "(2, 2)")[2] == Approx(7e-3 / 3));
  CHECK(json::parse(folder.read("h.npy.json")).at("parameters").at("missing_filled") == 1);
  CHECK(info(folder, scale + " --missing neighbours").at("missing_filled") == 1);
  check_refused(folder, "info " + scale + " --max-pixels 3", 3, {"2 x 2 pixels", "from 1 to 3"});
}

TEST_CASE("a response goes out as NPY with its axes", "[cli][sweep][npy]") {
  const Scratch folder;
  make_response(folder);
  folder.prepare("sweep g.gsf" + small_scene + " -o R.npy");
  const auto values = npy_numbers(folder.read("R.npy"), "(4, 151)");
  const auto lambda = npy_numbers(folder.read("R.lambda_nm.npy"), "(4, )");
  const auto theta = npy_numbers(folder.read("R.theta_r_deg.npy"), "(151, )");
  CHECK(lambda == std::vector<double>{400, 500, 600, 700});
  REQUIRE(theta.size() == 151);
  CHECK(theta.front() == -55);
  CHECK(theta.back() == -40);
  // The CSV of the same sweep, which keeps all digits.
  std::istringstream csv(folder.read("R.csv"));
  std::string line;
  std::getline(csv, line);
  std::size_t next = 0;
  while (std::getline(csv, line)) {
    std::istringstream fields(line);
    std::string field;
    std::getline(fields, field, ',');
    while (std::getline(fields, field, ',')) CHECK(std::stod(field) == values.at(next++));
  }
  CHECK(next == values.size());
  const json sidecar = json::parse(folder.read("R.npy.json"));
  CHECK(sidecar.at("axes").at("theta_r_deg").at("file") == "R.theta_r_deg.npy");
}

TEST_CASE("an array of two axes is a surface, a baked volume is not", "[cli][npy]") {
  const Scratch folder;
  make_small(folder);
  folder.prepare("bake g.gsf --sigma 0.4um --colour-tolerance 5e-2 -o v.npy");
  const std::string map = " --theta-i 70deg --size 16 -o m.png";
  folder.prepare("map v.npy" + map);
  check_refused(folder, "info v.npy", 3, {"v.npy", "two axes"});
  folder.prepare("convert g.gsf -o g.npy");
  check_refused(folder, "map g.npy" + map, 3, {"g.npy", "--pixel"});
  folder.prepare("map g.npy --pixel 0.1um --height-unit 1um --sigma 0.4um" + map);
  const std::vector<double> from_npy = numbers_of(folder.read("m.npy"));
  folder.prepare("map g.gsf --sigma 0.4um" + map);
  const std::vector<double> from_gsf = numbers_of(folder.read("m.npy"));
  REQUIRE(from_npy.size() == from_gsf.size());
  // The pixel of the GSF is the side of the patch by its count: a rounding apart.
  for (std::size_t i = 0; i < from_gsf.size(); ++i)
    CHECK(from_npy[i] == Approx(from_gsf[i]).epsilon(1e-9).margin(1e-12));
}

TEST_CASE("a table that this program writes is no scan", "[cli][period]") {
  const Scratch folder;
  make_response(folder);
  folder.prepare("sweep g.gsf" + small_scene + " --layout long -o long.csv");
  for (const std::string file : {"R.csv", "long.csv"}) {
    // Taken as a response: the options of a scan mean nothing.
    check_refused(folder, "period " + file + " --width 1um", 2, {file, "a response"});
    check_refused(folder, "info " + file, 3, {file, "not a known format"});
  }
}
