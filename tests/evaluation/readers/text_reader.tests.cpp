#include "evaluation/readers/text_reader.h"

#include <chrono>
#include <cmath>
#include <fstream>

#include "evaluation/readers/text_encoding.h"
#include "tests/support/foreign_files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text_heights.h"

namespace {

using brdf::Length;
using evaluation::HeightChoice;
using evaluation::MissingHeights;

std::string utf16(const std::string& ascii, bool big_endian) {
  std::string bytes = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : ascii) {
    if (big_endian) bytes += '\0';
    bytes += c;
    if (!big_endian) bytes += '\0';
  }
  return bytes;
}

}  // namespace

TEST_CASE("a matrix saved by Gwyddion is read to its last digit", "[text][golden]") {
  const std::vector<double> written = foreign_numbers("heights.csv");
  const auto read = evaluation::read_heights(foreign_file("gwyddion_matrix.txt"), {});
  REQUIRE(read.field.cols() == 7);
  REQUIRE(read.field.rows() == 5);
  for (std::size_t i = 0; i < written.size(); ++i) {
    INFO(i);
    // It writes 16 digits: half a unit of the last, and the rounding of two products.
    CHECK(std::abs(read.field.heights_um().data()[i] - written[i] * 1e6) <=
          std::abs(written[i]) * 1e6 * 6e-16);
  }
  // Gwyddion rounds the sides to hundredths.
  CHECK(read.field.width_um() == Approx(0.23));
  CHECK(read.field.height_um() == Approx(1.10));
  CHECK(read.channel == "Topography");
  // Sixteen digits of 3.24e-7 m.
  CHECK(read.field.height_step_um() == Approx(1e-16).epsilon(1e-6));
}

TEST_CASE("cells are parted by what the first line has", "[text]") {
  const auto expected = array(2, 2, {1, -2.5, 3e-1, 4});
  for (const std::string text :
       {"1 -2.5\n3e-1 4\n", "  1   -2.5 \n\n 3E-001\t +4  \n", "1\t-2.5\n0.3\t4", "1,-2.5\n.3,4\n",
        "1, -2.5 ,\n.3, 4.,\n", "1;-2.5\r\n0.30;4\r\n\r\n", "1\t-2.5\t\n0.3\t4\n"})
    check_heights(text, expected);
}

TEST_CASE("text of any usual encoding is read", "[text]") {
  const auto expected = array(2, 2, {1, 2, 3, 4});
  const std::string text = "1\t2\r\n3\t4\r\n";
  check_heights("\xEF\xBB\xBF" + text, expected);
  check_heights(utf16(text, false), expected);
  check_heights(utf16(text, true), expected);
  CHECK_THAT(refusal_of(utf16(text, false) + "x", plain()), Catch::Contains("not a number"));
  CHECK_THAT(refusal_of("\xEF\xBB\xBF# Breite: 2,5 \xC2\xB5m\n" + text, plain()),
             Catch::Contains("line 1") && Catch::Contains("decimal comma"));
  // A surrogate pair in a title, and half of one.
  const std::pair<std::string, std::string> titles[] = {
      {std::string("\x3D\xD8\x00\xDE", 4), "\xF0\x9F\x98\x80"},
      {std::string("\x3D\xD8", 2), "\xEF\xBF\xBD"},
      {std::string("\xF6\x00\x78\x30", 4), "\xC3\xB6\xE3\x81\xB8"}};
  for (const auto& [wide, narrow] : titles) {
    const auto read = read_bytes(
        utf16("# Channel: ", false) + wide + utf16("\n" + text, false).substr(2), plain());
    CHECK(read.channel == narrow);
    CHECK((read.field.heights_um() == expected).all());
  }
}

TEST_CASE("a text of many pieces is read as one", "[text]") {
  const int rows = 30'000;
  brdf::HeightArray expected(rows, 2);
  std::string text;
  for (int row = 0; row < rows; ++row) {
    expected.row(row) << row, -row / 8.0;
    text += std::to_string(row) + "\t" + std::to_string(-row / 8.0) + "\r\n";
  }
  for (const std::string& bytes : {text, utf16(text, false), utf16(text, true)})
    CHECK((heights(bytes) == expected).all());
}

TEST_CASE("no character is cut between two pieces", "[text]") {
  const std::string narrow = "\xF0\x9F\x98\x80", wide("\x3D\xD8\x00\xDE", 4);
  for (const std::string before : {"", "x"}) {
    std::string expected = before, bytes = utf16(before, false);
    for (int i = 0; i < 100'000; ++i) {
      expected += narrow;
      bytes += wide;
    }
    const evaluation::FileSource source("file", bytes + "y");  // half a unit
    evaluation::detail::Utf8Pieces pieces(source);
    std::string text;
    int count = 0;
    for (std::string_view piece = pieces.next(); !piece.empty(); piece = pieces.next(), ++count)
      text += piece;
    CHECK(count > 3);
    const bool is_same = text == expected + "\xEF\xBF\xBD";
    CHECK(is_same);
  }
}

TEST_CASE("a line without an end is refused before much of it is read", "[text][limit]") {
  const TemporaryFolder folder;
  const auto path = folder.write("long.txt", "1 2\n");
  std::filesystem::resize_file(path, std::uintmax_t{1} << 32);
  check_cheap([&] {
    CHECK_THAT(refusal_in([&] { evaluation::read_heights(path, plain()); }),
               Catch::Contains("line 2: more than 2097152 bytes"));
  });
}

TEST_CASE("a text with too many rows takes no memory for them", "[text][limit]") {
  // Rows of 64 bytes.
  std::string row, rows;
  while (row.size() < 62) row += "1 ";
  while (rows.size() < 1 << 20) rows += row + "1\n";
  const TemporaryFolder folder;
  const auto path = folder.write("long.txt", "");
  {
    std::ofstream file(path, std::ios::binary);
    for (int i = 0; i < 100; ++i) file << rows;
  }
  HeightChoice choice = plain();
  choice.max_pixels = 1000;
  check_cheap([&] {
    CHECK_THAT(refusal_in([&] { evaluation::read_heights(path, choice); }),
               Catch::Contains("32 x 1638400 pixels"));
  });
}

TEST_CASE("cells that are not there take no memory", "[text][limit]") {
  const std::string wide = "1" + std::string(2'000'000, ';') + "\n2\n";
  check_cheap([&] {
    CHECK_THAT(refusal_of(wide, plain()),
               Catch::Contains("2000004 bytes cannot hold 2000000 x 2 numbers"));
  });
}

TEST_CASE("a file that is written to while it is read is refused", "[text][source]") {
  const TemporaryFolder folder;
  const auto path = folder.write("scan.txt", "1 2\n3 4\n");
  const evaluation::FileSource source(path);
  folder.write("scan.txt", "5 6\n7 8\n");
  std::filesystem::last_write_time(
      path, std::filesystem::file_time_type::clock::now() + std::chrono::hours(1));
  CHECK_THAT(refusal_in([&] { evaluation::read_heights(source, plain()); }),
             Catch::Contains("has changed while it was read"));
}

TEST_CASE("the lines of Gwyddion are known in its languages", "[text]") {
  const std::vector<std::array<std::string, 4>> words = {
      {"Channel:", "Width:", "Height:", "Value units:"},
      {"Kanál:", "Šířka:", "Výška:", "Jednotky hodnot:"},
      {"Kanal:", "Breite:", "Höhe:", "Einheiten:"},
      {"Canal:", "Anchura:", "Altura:", "Value units:"},
      {"Canal\xC2\xA0:", "Largeur\xC2\xA0:", "Hauteur\xC2\xA0:", "Unités\xC2\xA0:"},
      {"Canale:", "Larghezza:", "Altezza:", "unità valore:"},
      {"チャネル：", "幅:", "高さ：", "値の単位:"},
      {"채널:", "폭:", "높이:", "값 단위:"},
      {"Canal:", "Largura:", "Altura:", "Unidades de valor:"},
      {"Канал:", "Ширина:", "Высота:", "Единицы измерения:"}};
  for (const auto& [channel, width, height, unit] : words) {
    INFO(width);
    const auto read = read_bytes("# " + channel + " top\n# " + width + " 10.00 µm\n# " + height +
                                 "   5.00 µm\n# " + unit + " nm\n1 2\n3 4\n");
    CHECK(read.channel == "top");
    CHECK(read.field.width_um() == Approx(10));
    CHECK(read.field.height_um() == Approx(5));
    CHECK(read.field.max_um() == Approx(0.004));
  }
}

TEST_CASE("words that are not known leave the scale to the user", "[text]") {
  const std::string text = "# Bredde: 10 um\n# Enheter: nm\n1 2\n3 4\n";
  CHECK_THAT(refusal_of(text), Catch::Contains("--width or --pixel"));
  HeightChoice choice;
  choice.scale.width = Length::um(1);
  CHECK_THAT(refusal_of(text, choice), Catch::Contains("--height-unit"));
  check_heights(text, array(2, 2, {1, 2, 3, 4}));
  CHECK_THAT(refusal_of("# Width: 1 um\n# Height: 1 um\n# Value units: V\n1 2\n"),
             Catch::Contains("\"V\" is no length"));
  CHECK_THAT(refusal_of("# Width: 0 um\n1 2\n"), Catch::Contains("must be > 0"));
}

TEST_CASE("empty cells and nan are missing", "[text]") {
  const auto filled = plain(MissingHeights::neighbours);
  for (const std::string text :
       {"1,2,3\n4,nan,6\n7,8,17\n", "1;2;3\n4; ;6\n7;8;17\n", "1\t2\t3\n4\tNaN\t6\n7\t8\t17\n"}) {
    check_heights(text, array(3, 3, {1, 2, 3, 4, 6, 6, 7, 8, 17}), filled);
    CHECK_THAT(refusal_of(text, plain()), Catch::Contains("row 1, column 1"));
  }
  // The last cell of a row that ends with a separator.
  check_heights("1,5\n3,\n", array(2, 2, {1, 5, 3, 3}), filled);
  CHECK_THAT(refusal_of("1 inf\n2 3\n", plain()), Catch::Contains("finite"));
}

TEST_CASE("a cell that is no number is refused with its place", "[text]") {
  const auto refused = [](const std::string& text, const std::string& place,
                          const std::string& cell) {
    const std::string message = refusal_of(text, plain());
    CHECK_THAT(message, Catch::Contains(place) && Catch::Contains(cell));
    return message;
  };
  refused("1 2\n3 four\n", "line 2: column 2", "\"four\"");
  refused("# a comment\n\n1 2\n3 4x\n", "line 4: column 2", "\"4x\"");
  refused("1 2\n3 1e-400\n", "line 2: column 2", "1e-400");
  refused("1 2\n3 1e999\n", "line 2: column 2", "1e999");
  refused("1 2\n3 --4\n", "line 2: column 2", "--4");
  refused("1 2\n3 4 # note\n", "line 2: column 3", "#");
  refused(std::string("1 2\n3 \0004\n", 9), "line 2: column 2", "not a number");
  for (const std::string text :
       {"1,5\t2,5\n3,5\t4,5\n", "1,5;2,5\n3,5;4,5\n", "1,5 2,5\n3,5 4,5\n"})
    CHECK_THAT(refused(text, "line 1: column", ""), Catch::Contains("decimal commas"));
  CHECK_THAT(refused("1 2\n3 4,5\n", "line 2: column 2", "\"4,5\""),
             Catch::Contains("decimal commas"));
}

TEST_CASE("rows of different length are refused", "[text]") {
  CHECK_THAT(refusal_of("1 2\n3 4\n5\n", plain()),
             Catch::Contains("line 3: 1 cells, the first row has 2"));
  CHECK_THAT(refusal_of("1,2\n3,4,5\n", plain()), Catch::Contains("line 2: 3 cells"));
  CHECK_THAT(refusal_of("1,2,3\n1,\n", plain()), Catch::Contains("line 2: 1 cells"));
}

TEST_CASE("more numbers than allowed are refused before memory is taken", "[text][limit]") {
  HeightChoice choice = plain();
  choice.max_pixels = 5;
  CHECK_THAT(refusal_of("1 2\n3 4\n5 6\n", choice), Catch::Contains("2 x 3 pixels"));
  choice.max_pixels = 6;
  CHECK(refusal_of("1 2\n3 4\n5 6\n", choice) == "");
  // Four million rows below a first one of a hundred.
  std::string rows;
  for (int i = 0; i < 100; ++i) rows += "1 ";
  rows += '\n';
  for (int i = 0; i < 1 << 22; ++i) rows += "1\n";
  const evaluation::FileSource source("file", std::move(rows));
  check_cheap([&] {
    CHECK_THROWS_WITH(evaluation::read_heights(source, plain()),
                      Catch::Contains("100 x 4194305 pixels"));
  });
}

TEST_CASE("tables that this program writes are no heights", "[text]") {
  for (const std::string text :
       {"lambda_nm,-50,-49\n500,1,2\n", "lambda_nm,theta_r_deg,value\n500,-50,1\n",
        "theta_r_deg,X,Y,Z,R,G,B\n1,1,1,1,1,1,1\n",
        "lambda_nm,order,theta_peak_deg,value,period_nm\n", "azimuth_deg,period_nm\n0,1000\n",
        "words\n1 2\n", "3 mice\n1 2\n", "# only a comment\n", "\n\n", "{\"a\": 1}\n"}) {
    INFO(text);
    CHECK(!evaluation::detail::is_text(text));
  }
  for (const std::string text : {"1 2\n", "nan 1\n", ",1\n", "# note\n\n-1e-3\n", "% note\n.5"})
    CHECK(evaluation::detail::is_text(text));
}

TEST_CASE("damaged text is refused or read, and nothing else", "[text]") {
  try_every_byte_changed(foreign_bytes("gwyddion_matrix.txt"));
  try_every_byte_changed("x [m] y [m] z [m]\n" + foreign_bytes("gwyddion_points.xyz"));
}
