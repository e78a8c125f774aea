#include <png.h>

#include <csetjmp>
#include <cstring>
#include <vector>

#include "brdf/error.h"
#include "evaluation/readers/height_formats.h"
#include "evaluation/readers/png_text.h"
#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

using brdf::Errc;
using brdf::Error;

/// Text chunks that are kept, and the most bytes of any chunk but the pixels: half of what a
/// refused file may cost.
constexpr png_uint_32 most_chunks = 32;
constexpr png_alloc_size_t most_chunk_bytes = 1 << 20;

/// Deflate makes at most this many bytes of one (RFC 1951: 258 of two bits).
constexpr std::uint64_t most_expansion = 1032;

struct Source {
  std::string_view bytes;
  std::size_t position = 0;
  char message[128] = {};
};

void read_bytes(png_structp png, png_bytep out, png_size_t count) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (source->bytes.size() - source->position < count) png_error(png, "file is truncated");
  std::memcpy(out, source->bytes.data() + source->position, count);
  source->position += count;
}

void on_error(png_structp png, png_const_charp message) {
  auto* source = static_cast<Source*>(png_get_error_ptr(png));
  std::strncpy(source->message, message, sizeof source->message - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

/// The samples of a PNG as libpng leaves them.
struct Layout {
  png_uint_32 cols = 0, rows = 0;
  int file_bits = 0;  ///< as stored; sub-byte samples are widened to 8
  int channels = 0;
  bool has_alpha = false, is_interlaced = false;
  std::size_t row_bytes = 0;

  int colours() const { return channels - (has_alpha ? 1 : 0); }
};

/// The parts of reading. No object with a destructor lives in them: libpng's errors jump out.
bool read_header(png_structp png, png_infop info, Layout& layout) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_info(png, info);
  layout.cols = png_get_image_width(png, info);
  layout.rows = png_get_image_height(png, info);
  layout.file_bits = png_get_bit_depth(png, info);
  // The bits of a palette count its entries; the colours behind them have eight.
  if (png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE) layout.file_bits = 8;
  layout.is_interlaced = png_get_interlace_type(png, info) != PNG_INTERLACE_NONE;
  // Widens palettes, sub-byte grey and transparency; keeps 16 bit.
  png_set_expand(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  layout.channels = png_get_channels(png, info);
  layout.has_alpha = (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0;
  layout.row_bytes = png_get_rowbytes(png, info);
  return true;
}

bool read_row(png_structp png, png_bytep row) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_row(png, row, nullptr);
  return true;
}

bool read_all_rows(png_structp png, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_image(png, rows);
  return true;
}

bool read_end(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_end(png, info);
  return true;
}

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw Error(Errc::bad_input, name + ": " + what);
}

/// Refuses a picture that is too large, or that the bytes of the file cannot hold, by the fixed
/// places of the header alone.
void require_possible(const FileSource& source, const HeightRequest& request) {
  constexpr std::size_t header_size = 8 + 8 + 13;
  const std::string_view head = source.head();
  if (head.size() < header_size) refuse(source.name(), "PNG: file is truncated");
  const std::uint64_t cols = stored_number<std::uint32_t>(head.data() + 16, std::endian::big);
  const std::uint64_t rows = stored_number<std::uint32_t>(head.data() + 20, std::endian::big);
  require_grid(cols, rows, request, source.name());
  // A byte for the filter of each row, and at least a bit a pixel.
  const std::uint64_t bits = static_cast<unsigned char>(head[24]);
  const std::uint64_t least = rows * (1 + cols * bits / 8) / most_expansion;
  if (source.size() < least)
    refuse(source.name(), "PNG: " + std::to_string(source.size()) + " bytes cannot hold " +
                              std::to_string(cols) + " x " + std::to_string(rows) +
                              " pixels, which need " + std::to_string(least) +
                              "; file is truncated");
}

/// Goes through the chunks without unpacking them: a file that was cut off costs nothing.
void require_whole(const FileSource& source) {
  std::string_view rest = source.bytes().substr(8);
  for (bool at_end = false; !at_end;) {
    constexpr std::uint64_t frame = 12;  // length, type, checksum
    if (rest.size() < frame) refuse(source.name(), "PNG: file is truncated");
    const std::uint64_t length = stored_number<std::uint32_t>(rest.data(), std::endian::big);
    if (rest.size() - frame < length) refuse(source.name(), "PNG: file is truncated");
    at_end = rest.substr(4, 4) == "IEND";
    rest.remove_prefix(frame + length);
  }
}

std::string place(png_uint_32 row, png_uint_32 col) {
  return "pixel at row " + std::to_string(row) + ", column " + std::to_string(col);
}

/// The grey codes of one row.
void take_row(const Layout& layout, const unsigned char* next, png_uint_32 row,
              const std::string& name, brdf::HeightArray& codes) {
  const int sample_bytes = layout.file_bits == 16 ? 2 : 1;
  const int colours = layout.colours();
  // Sub-byte codes arrive multiplied up to 0..255.
  const int scale = layout.file_bits < 8 ? 255 / ((1 << layout.file_bits) - 1) : 1;
  const int opaque = sample_bytes == 2 ? 65535 : 255;
  for (png_uint_32 col = 0; col < layout.cols; ++col) {
    int channel[4] = {};
    for (int i = 0; i < layout.channels; ++i) {
      channel[i] = sample_bytes == 2 ? next[0] << 8 | next[1] : next[0];
      next += sample_bytes;
    }
    if (colours == 3 && !(channel[0] == channel[1] && channel[1] == channel[2]))
      refuse(name, place(row, col) + " has R, G, B = " + std::to_string(channel[0]) + ", " +
                       std::to_string(channel[1]) + ", " + std::to_string(channel[2]) +
                       "; heights need grey, R = G = B");
    if (layout.has_alpha && channel[colours] != opaque)
      refuse(name, place(row, col) + " is transparent (alpha " + std::to_string(channel[colours]) +
                       " of " + std::to_string(opaque) + "), so it carries no height");
    const int code = channel[0] / scale;
    codes(row, col) = code;
  }
}

PngTexts texts_of(png_structp png, png_infop info) {
  PngTexts texts;
  png_textp all = nullptr;
  int count = 0;
  png_get_text(png, info, &all, &count);
  for (int i = 0; i < count; ++i) texts[all[i].key] = all[i].text;
  return texts;
}

}  // namespace

bool is_png(std::string_view head) {
  return head.size() >= 8 && png_sig_cmp(reinterpret_cast<png_const_bytep>(head.data()), 0, 8) == 0;
}

RawHeights decode_png(const FileSource& file, const HeightRequest& request) {
  const std::string& name = file.name();
  require_possible(file, request);
  require_whole(file);
  Source source{file.bytes()};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, on_error, on_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info) throw std::bad_alloc();
  struct Guard {
    png_structp png;
    png_infop info;
    ~Guard() { png_destroy_read_struct(&png, &info, nullptr); }
  } guard{png, info};
  png_set_read_fn(png, &source, read_bytes);
  // The project's own limit is checked; libpng's would be one million a side.
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_chunk_cache_max(png, most_chunks);
  png_set_chunk_malloc_max(png, most_chunk_bytes);
  const auto require = [&](bool done) {
    if (!done) refuse(name, std::string("PNG: ") + source.message);
  };

  Layout layout;
  require(read_header(png, info, layout));
  require_grid(layout.cols, layout.rows, request, name);
  RawHeights raw;
  raw.full_scale = layout.file_bits == 16 ? 65535 : (1 << layout.file_bits) - 1;
  raw.format = "PNG, " + std::to_string(layout.file_bits) + " bit " +
               (layout.colours() == 1 ? "grey" : "colour with R = G = B");
  raw.values.resize(layout.rows, layout.cols);
  // The passes of an interlaced picture need all rows at once.
  const std::size_t held = layout.is_interlaced ? layout.rows : 1;
  std::vector<unsigned char> samples(layout.row_bytes * held);
  std::vector<png_bytep> starts;
  for (std::size_t row = 0; row < held; ++row)
    starts.push_back(samples.data() + layout.row_bytes * row);
  if (layout.is_interlaced) require(read_all_rows(png, starts.data()));
  for (png_uint_32 row = 0; row < layout.rows; ++row) {
    if (!layout.is_interlaced) require(read_row(png, starts[0]));
    take_row(layout, starts[layout.is_interlaced ? row : 0], row, name, raw.values);
  }
  require(read_end(png, info));
  take_png_scale(texts_of(png, info), name, raw);
  return raw;
}

}  // namespace evaluation::detail
