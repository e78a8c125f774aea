#include <cmath>

#include "evaluation/writers/gsf_writer.h"
#include "tests/support/damaged_files.h"
#include "tests/support/foreign_files.h"

namespace {

using brdf::Length;

brdf::HeightField ramp() {
  brdf::HeightArray heights(2, 3);
  heights << 0, 0.25, 0.5, 0.75, 1, 1.25;
  return {heights, Length::um(0.5), Length::um(2), Length::nm(1)};
}

std::string replaced(std::string bytes, const std::string& from, const std::string& to) {
  return bytes.replace(bytes.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("a field saved by Gwyddion has its title and its heights", "[gsf][golden]") {
  const evaluation::RawHeights raw = decoded(foreign_file("gwyddion.gsf"));
  const brdf::HeightArray single = foreign_values("heights.csv").unaryExpr([](double height) {
    return static_cast<double>(static_cast<float>(height));
  });
  check_same_bits(raw.values, single);
  CHECK(raw.channel == "Topography");
}

TEST_CASE("a title of several lines is written as one", "[gsf]") {
  const auto read =
      read_bytes(evaluation::to_gsf(ramp(), std::string("top\nXReal = 9\0\r\nYReal = 9", 25)));
  CHECK(read.channel == "top XReal = 9   YReal = 9");
  CHECK(read.field.dx_um() == Approx(0.5));
  CHECK(read.field.dy_um() == Approx(2));
}

TEST_CASE("a long title is cut between two characters", "[gsf]") {
  std::string title = "x";
  while (title.size() < 70'000) title += "\xE3\x81\xB8";
  CHECK(read_bytes(evaluation::to_gsf(ramp(), title)).channel == title.substr(0, 1000));
  CHECK(read_bytes(evaluation::to_gsf(ramp(), "xx" + title)).channel ==
        "xx" + title.substr(0, 997));
}

TEST_CASE("heights of a field that are no lengths take a unit from the user", "[gsf]") {
  // The padding behind the header stays the same: "V " for "m".
  const std::string bytes =
      replaced(evaluation::to_gsf(ramp(), "title"), "ZUnits = m\n", "ZUnits =V \n");
  CHECK_THAT(refusal_of(bytes), Catch::Contains("\"V\" is no length; give --height-unit"));
  evaluation::HeightChoice choice;
  choice.scale.height_unit = Length::nm(10);
  // 1.25e-6 V, to the precision of float.
  CHECK(read_bytes(bytes, choice).field.max_um() == Approx(1.25e-8).epsilon(1e-7));
}
