#include "evaluation/readers/gwy_reader.h"

#include <cmath>
#include <limits>

#include "tests/support/damaged_files.h"
#include "tests/support/foreign_files.h"
#include "tests/support/is_error.h"
#include "tests/support/real_data.h"
#include "tests/support/temporary_folder.h"

namespace {

using brdf::Errc;
using brdf::Length;
using evaluation::HeightChoice;
using evaluation::MissingHeights;

HeightChoice channel(const std::string& wish) {
  HeightChoice choice;
  choice.channel = wish;
  return choice;
}

// A container byte by byte.

template <class Number>
std::string bytes_of(Number number) {
  return std::string(reinterpret_cast<const char*>(&number), sizeof number);
}

std::string text(const std::string& characters) {
  return characters + '\0';
}

std::string object(const std::string& type, const std::string& items) {
  return text(type) + bytes_of(static_cast<std::uint32_t>(items.size())) + items;
}

std::string unit(const std::string& key, const std::string& name) {
  return text(key) + 'o' + object("GwySIUnit", text("unitstr") + 's' + text(name));
}

std::string field(std::int32_t cols, std::int32_t rows, const std::vector<double>& heights,
                  const std::string& z_unit = "m", double width = 2e-6) {
  std::string numbers;
  for (const double height : heights) numbers += bytes_of(height);
  return object("GwyDataField", text("xres") + 'i' + bytes_of(cols) + text("yres") + 'i' +
                                    bytes_of(rows) + text("xreal") + 'd' + bytes_of(width) +
                                    text("yreal") + 'd' + bytes_of(3e-6) + unit("si_unit_xy", "m") +
                                    unit("si_unit_z", z_unit) + text("data") + 'D' +
                                    bytes_of(static_cast<std::uint32_t>(heights.size())) + numbers);
}

std::string file(const std::string& items) {
  return "GWYP" + object("GwyContainer", items);
}

std::string channel_item(int number, const std::string& field) {
  return text("/" + std::to_string(number) + "/data") + 'o' + field;
}

}  // namespace

TEST_CASE("a channel saved by Gwyddion is read to the last bit", "[gwy][golden]") {
  const std::vector<double> written = foreign_numbers("heights.csv");
  REQUIRE(written.size() == 35);
  const auto read =
      evaluation::read_heights(foreign_file("gwyddion_channels.gwy"), channel("Topography"));
  REQUIRE(read.field.cols() == 7);
  REQUIRE(read.field.rows() == 5);
  const double metre_um = 1e6;
  for (int i = 0; i < 35; ++i) {
    INFO(i);
    CHECK(read.field.heights_um().data()[i] == written[static_cast<std::size_t>(i)] * metre_um);
  }
  // 0.7e-6 / 3 m of 7 pixels, 1.1e-6 m of 5.
  CHECK(read.field.dx_um() == Approx(0.1 / 3).epsilon(1e-15));
  CHECK(read.field.dy_um() == Approx(0.22).epsilon(1e-15));
  // The largest height is 3.24e-7 m.
  CHECK(read.field.height_step_um() == Approx(0.324 * std::pow(2, -52)).epsilon(1e-12));
  CHECK(read.channel == "Topography");
  CHECK(read.filled == 0);
}

TEST_CASE("channels are chosen by title or number", "[gwy]") {
  const auto path = foreign_file("gwyddion_channels.gwy");
  const std::string list = "1 \"Topography\" (m), 2 \"Amplitude\" (V), 3 \"Topography back\" (m)";
  CHECK_ERROR(evaluation::read_heights(path, {}), Errc::bad_input, list);
  CHECK_ERROR(evaluation::read_heights(path, channel("4")), Errc::invalid_argument, list);
  CHECK_ERROR(evaluation::read_heights(path, channel("0")), Errc::invalid_argument, list);
  CHECK_ERROR(evaluation::read_heights(path, channel("Phase")), Errc::invalid_argument, list);
  CHECK(evaluation::read_heights(path, channel("3")).channel == "Topography back");
  const auto back = evaluation::read_heights(path, channel("Topography back"));
  CHECK(back.field.heights_um()(0, 0) == Approx(2.0 / 3 * 0.1).epsilon(1e-15));
  REQUIRE(back.channels.size() == 3);
  CHECK(back.channels[1].unit == "V");
}

TEST_CASE("a channel that is no length needs a unit", "[gwy]") {
  const auto path = foreign_file("gwyddion_channels.gwy");
  HeightChoice choice = channel("Amplitude");
  CHECK_ERROR(evaluation::read_heights(path, choice), Errc::bad_input, "\"V\" is no length");
  choice.scale.height_unit = Length::nm(10);
  // The first is -1e6 / 3 * 1e-7 V.
  CHECK(evaluation::read_heights(path, choice).field.heights_um()(0, 0) ==
        Approx(-1e-3 / 3).epsilon(1e-14));
}

TEST_CASE("masked pixels are missing", "[gwy]") {
  const auto path = foreign_file("gwyddion_mask.gwy");
  CHECK_ERROR(evaluation::read_heights(path, {}), Errc::bad_input, "2 of 35 pixels");
  CHECK_ERROR(evaluation::read_heights(path, {}), Errc::bad_input, "row 2, column 3");
  HeightChoice choice;
  choice.missing = MissingHeights::neighbours;
  const auto read = evaluation::read_heights(path, choice);
  CHECK(read.filled == 2);
  CHECK(read.channel == "Topography");
  const std::vector<double> written = foreign_numbers("heights.csv");
  for (int i = 0; i < 35; ++i)
    if (i != 2 * 7 + 3 && i != 34)
      CHECK(read.field.heights_um().data()[i] == written[static_cast<std::size_t>(i)] * 1e6);
  // The corner has three neighbours.
  CHECK(read.field.heights_um()(4, 6) ==
        Approx((written[26] + written[27] + written[33]) / 3 * 1e6).epsilon(1e-14));
}

TEST_CASE("a file of another library without units is refused until they are given",
          "[gwy][real]") {
  const auto folder = real_data();
  if (!folder) return;
  const auto path = *folder / "lattice_nounit.gwy";
  HeightChoice choice;
  CHECK_ERROR(evaluation::read_heights(path, choice), Errc::bad_input, "--width or --pixel");
  choice.scale.width = Length::um(5);
  CHECK_ERROR(evaluation::read_heights(path, choice), Errc::bad_input, "--height-unit");
  choice.scale.height_unit = Length::um(1);
  const auto read = evaluation::read_heights(path, choice);
  CHECK(read.field.cols() == 128);
  CHECK(read.field.rows() == 128);
  CHECK(read.channel == "Test");
}

TEST_CASE("items that are not heights are stepped over", "[gwy]") {
  const std::string other = text("a") + 'b' + '\1' + text("b") + 'c' + 'x' + text("c") + 'q' +
                            std::string(8, '\1') + text("d") + 'C' + bytes_of(3u) + "abc" +
                            text("e") + 'S' + bytes_of(2u) + text("one") + text("two") + text("f") +
                            'O' + bytes_of(1u) + object("Thing", "xyz") + text("/x/data") + 's' +
                            text("no number") + text("/0/data") + 's' + text("no field");
  const auto read = read_bytes(file(other + channel_item(7, field(2, 1, {1e-9, 2e-9})) + other));
  CHECK(read.field.heights_um()(0, 1) == 2e-9 * 1e6);
  CHECK(read.field.dx_um() == Approx(1).epsilon(1e-15));
  CHECK(read.field.dy_um() == Approx(3).epsilon(1e-15));
}

TEST_CASE("the only channel with a length is taken", "[gwy]") {
  const std::string volts = field(1, 1, {5}, "V");
  CHECK(read_bytes(file(channel_item(0, volts) + channel_item(1, field(1, 1, {1e-6}))))
            .field.max_um() == Approx(1));
  CHECK_THAT(refusal_of(file(channel_item(0, volts) + channel_item(1, volts))),
             Catch::Contains("0 of 2 channels hold lengths"));
  CHECK_THAT(refusal_of(file("")), Catch::Contains("no channel"));
}

TEST_CASE("a container that cannot be right is refused", "[gwy]") {
  const std::string good = field(2, 1, {1e-9, 2e-9});
  const auto refused = [](const std::string& items) { return refusal_of(file(items)); };
  CHECK(refused(channel_item(0, good)) == "");
  CHECK_THAT(refused(channel_item(0, field(3, 1, {1, 2}))), Catch::Contains("3 x 1 pixels"));
  CHECK_THAT(refused(channel_item(0, field(-2, -1, {1, 2}))), Catch::Contains("-2 x -1"));
  CHECK_THAT(refused(channel_item(0, field(0, 0, {}))), Catch::Contains("0 x 0"));
  CHECK_THAT(refused(channel_item(0, field(2147483647, 2147483647, {1}))),
             Catch::Contains("--max-pixels"));
  CHECK_THAT(refused(channel_item(0, field(2, 1, {1, 2}, "m", 0))), Catch::Contains("must be > 0"));
  CHECK_THAT(refused(channel_item(0, field(2, 1, {1, 2}, "m", NAN))),
             Catch::Contains("must be > 0"));
  CHECK_THAT(refused(channel_item(0, good) + text("/0/mask") + 'o' + field(1, 2, {0, 0})),
             Catch::Contains("the mask has 1 x 2"));
  CHECK_THAT(refused(text("x") + 'z' + channel_item(0, good)), Catch::Contains("unknown type 'z'"));
  CHECK_THAT(refused(channel_item(0, good) + text("x") + 'D' + bytes_of(0xFFFFFFFFu)),
             Catch::Contains("34359738360 bytes"));
  CHECK_THAT(refused(channel_item(0, good) + text("x") + 'O' + bytes_of(0xFFFFFFFFu)),
             Catch::Contains("truncated or damaged"));
  // A size that reaches beyond the object by a byte, by which the file is longer.
  CHECK_THAT(refused(channel_item(0, good) + text("x") + 'd' + std::string(7, '\0')),
             Catch::Contains("8 bytes are said to follow where 7 are left"));
  CHECK_THAT(refusal_of(file(channel_item(0, good)) + "tail"), Catch::Contains("follow"));
  CHECK_THAT(refusal_of("GWYP" + object("GwyGraph", "")), Catch::Contains("no GwyContainer"));
  CHECK_THAT(refused(channel_item(0, field(1, 1, {INFINITY}))), Catch::Contains("finite"));
  CHECK_THAT(refused(channel_item(0, field(1, 1, {NAN}))), Catch::Contains("1 of 1 pixels"));
}

TEST_CASE("a field of many pieces is read from the disk, its mask too", "[gwy]") {
  constexpr int cols = 150, rows = 140;
  std::vector<double> heights(cols * rows), mask(cols * rows);
  for (int i = 0; i < cols * rows; ++i) heights[i] = 1e-9 * i;
  constexpr int masked[] = {0, 8191, 8192, 20'000};
  for (const int i : masked) {
    mask[i] = 1;
    heights[i] = 1e30;  // plays no part, in the step between heights neither
  }
  const std::string thumbnail =
      text("pixels") + 'C' + bytes_of(100'000u) + std::string(100'000, 'p');
  const TemporaryFolder folder;
  const auto path =
      folder.write("scan.gwy", file(thumbnail + channel_item(0, field(cols, rows, heights)) +
                                    text("/0/data/title") + 's' + text("top") + thumbnail +
                                    text("/0/mask") + 'o' + field(cols, rows, mask)));
  HeightChoice choice;
  choice.missing = MissingHeights::neighbours;
  const auto read = evaluation::read_heights(path, choice);
  CHECK(read.channel == "top");
  CHECK(read.filled == 4);
  int wrong = 0;
  for (int i = 0; i < cols * rows; ++i)
    if (mask[i] == 0 && read.field.heights_um().data()[i] != heights[i] * 1e6) ++wrong;
  CHECK(wrong == 0);
  CHECK(read.field.height_step_um() ==
        Approx(1e-3 * (cols * rows - 1) * std::pow(2, -52)).epsilon(1e-9));
}

TEST_CASE("a mask of another size is refused before the heights are read", "[gwy][limit]") {
  constexpr std::uint32_t side = 1 << 14;
  const std::string items = text("/0/mask") + 'o' + field(1, 1, {0}) + text("/0/data") + 'o';
  const std::string header = text("xres") + 'i' + bytes_of(side) + text("yres") + 'i' +
                             bytes_of(side) + text("data") + 'D' + bytes_of(side * side);
  const std::uint32_t numbers = 8 * side * side;  // 2 GiB
  const std::string data =
      text("GwyDataField") + bytes_of(static_cast<std::uint32_t>(header.size() + numbers)) + header;
  const TemporaryFolder folder;
  const auto path = folder.write(
      "scan.gwy", "GWYP" + text("GwyContainer") +
                      bytes_of(static_cast<std::uint32_t>(items.size() + data.size() + numbers)) +
                      items + data);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) + numbers);
  check_cheap([&] {
    CHECK_THAT(refusal_in([&] { evaluation::read_heights(path, {}); }),
               Catch::Contains("the mask has 1 x 1 pixels"));
  });
}

TEST_CASE("channels without number are refused", "[gwy][limit]") {
  std::string items;
  for (int i = 0; i < 5000; ++i) {
    items += channel_item(i, object("GwyDataField", ""));
    if (i + 1 == 4096)
      CHECK_THAT(refusal_of(file(items)), Catch::Contains("0 of 4096 channels hold lengths"));
    if (i + 1 == 4097)
      CHECK_THAT(refusal_of(file(items)), Catch::Contains("more than 4096 channels"));
  }
  CHECK_THAT(refusal_of(file(items)), Catch::Contains("more than 4096 channels"));
}

TEST_CASE("a Gwyddion file is refused wherever it was cut or damaged", "[gwy]") {
  const std::string bytes = foreign_bytes("gwyddion_mask.gwy");
  check_refused_wherever_cut(bytes, request_for("Topography"));
  HeightChoice choice = channel("Topography");
  choice.missing = MissingHeights::neighbours;
  try_every_byte_changed(bytes, choice);
}
