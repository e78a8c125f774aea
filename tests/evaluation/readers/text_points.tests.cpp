#include "evaluation/readers/text_reader.h"
#include "tests/support/foreign_files.h"
#include "tests/support/text_heights.h"

namespace {

using brdf::Length;
using evaluation::HeightChoice;
using evaluation::MissingHeights;

}  // namespace

TEST_CASE("points saved by Gwyddion are put on their grid", "[text][golden]") {
  const std::vector<double> written = foreign_numbers("heights.csv");
  HeightChoice choice;
  choice.scale.pixel = {Length::um(0.1 / 3), Length::um(0.22)};
  choice.scale.height_unit = Length::um(1e6);
  const auto read = evaluation::read_heights(foreign_file("gwyddion_points.xyz"), choice);
  REQUIRE(read.field.cols() == 7);
  REQUIRE(read.field.rows() == 5);
  // Five digits.
  for (std::size_t i = 0; i < written.size(); ++i)
    CHECK(read.field.heights_um().data()[i] == Approx(written[i] * 1e6).epsilon(5e-5));
  // With a line of units above it the file says all.
  const auto whole =
      read_bytes("x [m]\ty [m]\tz [m]\n" + foreign_bytes("gwyddion_points.xyz")).field;
  CHECK(whole.dx_um() == Approx(0.1 / 3).epsilon(1e-4));
  CHECK(whole.dy_um() == Approx(0.22).epsilon(1e-4));
  CHECK((whole.heights_um() == read.field.heights_um()).all());
}

TEST_CASE("points are put on their grid in any order", "[text][points]") {
  const auto expected = array(2, 3, {1, 2, 3, 4, 5, 6});
  const std::string names = "x [um], y [um], z [nm]\n";
  const std::string points[] = {
      "0,0,1\n2,0,2\n4,0,3\n0,5,4\n2,5,5\n4,5,6\n",         // by rows
      "0,0,1\n0,5,4\n2,0,2\n2,5,5\n4,0,3\n4,5,6\n",         // by columns
      "4,5,6\n0.1,0,1\n1.9,5,5\n4,0,3\n2,0.4,2\n0,5,4\n"};  // in no order, a little off
  for (const std::string& rows : points) {
    const auto read = read_bytes(names + rows).field;
    CHECK((read.heights_um() == expected * 1e-3).all());
    CHECK(read.dx_um() == Approx(2));
    CHECK(read.dy_um() == Approx(5));
  }
  check_heights(points[0], expected);
}

TEST_CASE("the names of the columns give their units", "[text][points]") {
  const std::string rows = "0 0 1\n2 0 2\n0 5 3\n2 5 4\n";
  for (const std::string names : {"x [nm] y [nm] z [um]", "# X(nm)  Y(nm)  Z(um)", "x_nm;y_nm;z_um",
                                  "x/nm\ty/nm\tz/um", "% x [nm], y [nm], z [um]"}) {
    INFO(names);
    const auto read = read_bytes(names + "\n" + rows).field;
    CHECK(read.dx_um() == Approx(0.002));
    CHECK(read.max_um() == Approx(4));
  }
  CHECK_THAT(refusal_of("x,y,z\n" + rows), Catch::Contains("--width or --pixel"));
  CHECK_THAT(refusal_of("x [nm], y [nm], z [V]\n" + rows), Catch::Contains("\"V\" is no length"));
  CHECK_THAT(refusal_of("x,y,z\n0 0\n1 1\n", plain()),
             Catch::Contains("2 columns below the names"));
}

TEST_CASE("nodes without a point are missing", "[text][points]") {
  const std::string text = "x y z\n0 0 1\n1 0 2\n2 0 3\n0 1 4\n2 1 6\n";
  CHECK_THAT(refusal_of(text, plain()), Catch::Contains("1 of 6 pixels"));
  check_heights(text, array(2, 3, {1, 2, 3, 4, 16.0 / 5, 6}), plain(MissingHeights::neighbours));
  CHECK_THAT(refusal_of("x y z\n0 0 1\n1 1 1\n2 2 1\n3 3 1\n", plain()),
             Catch::Contains("4 points on a grid of 4 x 4"));
}

TEST_CASE("points that lie on no grid are refused with the first", "[text][points]") {
  const auto refused = [](const std::string& rows) {
    return refusal_of("x y z\n" + rows, plain());
  };
  CHECK_THAT(refused("0 0 1\n1.3 0 2\n0 1 3\n1 1 4\n2 0 1\n2 1 1\n"),
             Catch::Contains("point 2 at x = 1.3, y = 0"));
  CHECK_THAT(refused("0 0 1\n1 0 2\n0 1 3\n1 1 4\n1 1 4\n"),
             Catch::Contains("point 5 at x = 1, y = 1 is there twice"));
  CHECK_THAT(refused("0 0 1\n1 0 2\n2 0 3\n"), Catch::Contains("at least 2 x 2"));
  CHECK_THAT(refused("0 0 1\nnan 0 2\n2 0 3\n"), Catch::Contains("point 2"));
}

TEST_CASE("three columns are told apart, or refused", "[text][points]") {
  // Up to three rows, or with a header of Gwyddion, a matrix.
  check_heights("0 0 1\n1 0 2\n0 1 3\n", array(3, 3, {0, 0, 1, 1, 0, 2, 0, 1, 3}));
  const std::string rows = "0 0 1\n1 0 2\n0 1 3\n1 1 4\n";
  CHECK(heights("# Value units: um\n" + rows).rows() == 4);
  CHECK(heights(rows).rows() == 2);
  CHECK_THAT(refusal_of("5 1 1\n1 0 2\n0 3 3\n1 1 4\n", plain()),
             Catch::Contains("three columns") && Catch::Contains("# Value units"));
  CHECK_THAT(refusal_of("0 0 1\n1 0 2\n0 1 3\n1 1 4\n0 2 5\n", plain()),
             Catch::Contains("three columns that do not fill a grid"));
}
