#include <png.h>

#include <cmath>

#include "tests/support/damaged_files.h"
#include "tests/support/foreign_files.h"
#include "tests/support/is_error.h"

namespace {

using brdf::Errc;
using brdf::Length;
using evaluation::HeightChoice;

/// A text chunk: key, value, PNG_TEXT_COMPRESSION_NONE (tEXt), _zTXt or PNG_ITXT_COMPRESSION_NONE.
struct Text {
  std::string key, value;
  int kind = PNG_TEXT_COMPRESSION_NONE;
};

void append(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))
      ->append(reinterpret_cast<const char*>(bytes), count);
}

struct Picture {
  png_uint_32 cols = 2, rows = 1;
  int bits = 16;
  bool is_interlaced = false;
  std::vector<Text> texts = {};
};

/// 8 or 16 bit grey: the low byte of a pixel is its column, the high byte its row.
std::string png(const Picture& picture) {
  std::string bytes;
  png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(writer);
  png_set_write_fn(writer, &bytes, append, nullptr);
  png_set_user_limits(writer, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_IHDR(writer, info, picture.cols, picture.rows, picture.bits, PNG_COLOR_TYPE_GRAY,
               picture.is_interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  for (const Text& text : picture.texts) {
    png_text chunk{};
    std::string key = text.key, value = text.value, none;
    chunk.compression = text.kind;
    chunk.key = key.data();
    chunk.text = value.data();
    chunk.text_length = value.size();
    chunk.lang = none.data();
    chunk.lang_key = none.data();
    png_set_text(writer, info, &chunk, 1);
  }
  png_write_info(writer, info);
  const std::size_t row_bytes = std::size_t{picture.cols} * static_cast<unsigned>(picture.bits) / 8;
  std::vector<png_byte> row(row_bytes);
  for (int pass = png_set_interlace_handling(writer); pass > 0; --pass)
    for (png_uint_32 r = 0; r < picture.rows; ++r) {
      if (picture.bits == 16)
        for (png_uint_32 c = 0; c < picture.cols; ++c) {
          row[2 * c] = static_cast<png_byte>(r);
          row[2 * c + 1] = static_cast<png_byte>(c);
        }
      png_write_row(writer, row.data());
    }
  png_write_end(writer, info);
  png_destroy_write_struct(&writer, &info);
  return bytes;
}

std::vector<Text> scale() {
  return {{"Gwy::XReal", "4e-6"},     {"Gwy::YReal", "3e-6"}, {"Gwy::ZMin", "-1e-7"},
          {"Gwy::ZMax", "5.5535e-6"}, {"Gwy::XYUnit", "m"},   {"Gwy::ZUnit", "m"}};
}

HeightChoice own_scale() {
  HeightChoice choice;
  choice.scale.width = Length::um(1);
  choice.scale.height_range = Length::um(65.535);
  return choice;
}

}  // namespace

TEST_CASE("a 16-bit PNG of Gwyddion holds its heights to one code", "[png][golden]") {
  const std::vector<double> written = foreign_numbers("heights.csv");
  const auto read = evaluation::read_heights(foreign_file("gwyddion_16bit.png"), {});
  REQUIRE(read.field.cols() == 7);
  REQUIRE(read.field.rows() == 5);
  const double range_um = 0.272 + 0.324;
  for (std::size_t i = 0; i < written.size(); ++i) {
    INFO(i);
    const double off = std::abs(read.field.heights_um().data()[i] - written[i] * 1e6);
    // Gwyddion dithers: a code lies up to one beside its height.
    CHECK(off <= range_um / 65535 * 1.0001);
  }
  CHECK(read.field.min_um() == Approx(-0.324).epsilon(1e-14));
  CHECK(read.field.max_um() == Approx(0.272).epsilon(1e-14));
  CHECK(read.field.dx_um() == Approx(0.1 / 3).epsilon(1e-14));
  CHECK(read.field.dy_um() == Approx(0.22).epsilon(1e-14));
  CHECK(read.field.height_step_um() == Approx(range_um / 65535).epsilon(1e-12));
  CHECK(read.channel == "Topography");
}

TEST_CASE("a 16-bit PNG of Gwyddion gives its codes to the user's own scale", "[png][golden]") {
  const auto read = evaluation::read_heights(foreign_file("gwyddion_16bit.png"), own_scale());
  const std::vector<double> codes = foreign_numbers("gwyddion_16bit_codes.csv");
  REQUIRE(codes.size() == 35);
  for (std::size_t i = 0; i < codes.size(); ++i)
    CHECK(read.field.heights_um().data()[i] ==
          Approx(codes[i] * 1e-3).epsilon(1e-14).margin(1e-14));
  CHECK(read.field.dx_um() == Approx(1.0 / 7));
}

TEST_CASE("the scale may stand in any kind of text chunk", "[png]") {
  for (const int kind :
       {PNG_TEXT_COMPRESSION_NONE, PNG_TEXT_COMPRESSION_zTXt, PNG_ITXT_COMPRESSION_NONE}) {
    INFO(kind);
    auto texts = scale();
    for (Text& text : texts) text.kind = kind;
    const auto read = read_bytes(png({.rows = 3, .texts = texts}));
    CHECK(read.field.dx_um() == Approx(2));
    CHECK(read.field.dy_um() == Approx(1));
    // A code is (5553.5 + 100) / 65535 nm.
    CHECK(read.field.heights_um()(1, 1) == Approx(-0.1 + 257 * 5.6535 / 65535));
  }
}

TEST_CASE("a unit that is no length scales nothing", "[png]") {
  auto texts = scale();
  texts[5].value = "V";
  CHECK_THAT(refusal_of(png({.texts = texts})), Catch::Contains("--height-range"));
  texts = scale();
  texts[4].value = "";
  CHECK_THAT(refusal_of(png({.texts = texts})), Catch::Contains("--width"));
}

TEST_CASE("a scale that cannot be right is refused", "[png]") {
  const auto with = [](std::size_t at, const std::string& value) {
    auto texts = scale();
    texts[at].value = value;
    return refusal_of(png({.texts = texts}));
  };
  CHECK(with(0, "4e-6") == "");
  CHECK_THAT(with(0, "wide"), Catch::Contains("Gwy::XReal") && Catch::Contains("wide"));
  CHECK_THAT(with(0, "4,5e-6"), Catch::Contains("Gwy::XReal"));
  CHECK_THAT(with(1, "0"), Catch::Contains("Gwy::YReal is 0"));
  CHECK_THAT(with(1, "-1"), Catch::Contains("must be > 0"));
  CHECK_THAT(with(2, "1"), Catch::Contains("Gwy::ZMin 1 must be <="));
  CHECK_THAT(with(3, "inf"), Catch::Contains("Gwy::ZMax"));
}

TEST_CASE("rows of an interlaced picture are where they were", "[png]") {
  for (const bool is_interlaced : {false, true}) {
    const auto read =
        read_bytes(png({.cols = 11, .rows = 9, .is_interlaced = is_interlaced}), own_scale());
    for (int row = 0; row < 9; ++row)
      for (int col = 0; col < 11; ++col)
        CHECK(read.field.heights_um()(row, col) == Approx((256 * row + col) * 1e-3));
  }
}

TEST_CASE("a PNG is refused wherever it was cut or damaged", "[png]") {
  for (const bool is_interlaced : {false, true}) {
    const std::string bytes =
        png({.cols = 5, .rows = 4, .is_interlaced = is_interlaced, .texts = scale()});
    check_refused_wherever_cut(bytes);
    try_every_byte_changed(bytes);
  }
}

TEST_CASE("a picture above the limit is refused before anything is unpacked", "[png][limit]") {
  const std::string bomb = png({.cols = 20000, .rows = 20000, .bits = 8});
  REQUIRE(bomb.size() < 1'000'000);
  check_cheap([&] {
    CHECK_THAT(refusal_of(bomb, own_scale()),
               Catch::Contains("20000 x 20000") && Catch::Contains("--max-pixels"));
  });
}

TEST_CASE("a picture below the limit that was cut off costs nothing", "[png][limit]") {
  const std::string whole = png({.cols = 16000, .rows = 16000, .bits = 8});
  for (const std::size_t size : {std::size_t{60}, whole.size() / 2, whole.size() - 1}) {
    const std::string cut = whole.substr(0, size);
    check_cheap([&] { CHECK_THAT(refusal_of(cut, own_scale()), Catch::Contains("truncated")); });
  }
}

TEST_CASE("a whole picture that says more pixels than its bytes hold costs nothing",
          "[png][limit]") {
  std::string bytes = png({});
  // 16000 columns and rows in the header.
  bytes.replace(16, 8, std::string("\x00\x00\x3E\x80\x00\x00\x3E\x80", 8));
  check_cheap([&] {
    CHECK_THAT(refusal_of(bytes, own_scale()), Catch::Contains("cannot hold 16000 x 16000"));
  });
}

TEST_CASE("texts that unpack to gigabytes are bounded", "[png][limit]") {
  std::vector<Text> texts;
  for (int i = 0; i < 200; ++i)
    texts.push_back({"note", std::string(900'000, 'x'), PNG_TEXT_COMPRESSION_zTXt});
  const std::string many = png({.texts = texts});
  texts = {{"note", std::string(100'000'000, 'x'), PNG_TEXT_COMPRESSION_zTXt}};
  const std::string one = png({.texts = texts});
  for (const std::string* bytes : {&many, &one})
    check_cheap([&] { refusal_of(*bytes, own_scale()); });
}
