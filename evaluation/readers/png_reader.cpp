#include <png.h>

#include <csetjmp>
#include <cstring>
#include <vector>

#include "brdf/error.h"
#include "evaluation/readers/height_formats.h"

namespace evaluation::detail {
namespace {

using brdf::Errc;
using brdf::Error;

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

/// The samples of a PNG, all rows after each other, as libpng leaves them.
struct Samples {
  png_uint_32 cols = 0, rows = 0;
  int file_bits = 0;  ///< as stored; sub-byte samples are widened to 8
  int channels = 0;
  bool has_alpha = false;
  std::vector<unsigned char> bytes;
  std::vector<png_bytep> row_starts;
};

/// The two halves of reading. No object with a destructor lives in them: libpng's errors jump out.
bool read_header(png_structp png, png_infop info, Samples& samples) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_info(png, info);
  samples.cols = png_get_image_width(png, info);
  samples.rows = png_get_image_height(png, info);
  samples.file_bits = png_get_bit_depth(png, info);
  // The bits of a palette count its entries; the colours behind them have eight.
  if (png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE) samples.file_bits = 8;
  // Widens palettes, sub-byte grey and transparency; keeps 16 bit.
  png_set_expand(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  samples.channels = png_get_channels(png, info);
  samples.has_alpha = (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0;
  return true;
}

bool read_rows(png_structp png, Samples& samples) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_image(png, samples.row_starts.data());
  png_read_end(png, nullptr);
  return true;
}

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw Error(Errc::bad_input, name + ": " + what);
}

std::string place(png_uint_32 row, png_uint_32 col) {
  return "pixel at row " + std::to_string(row) + ", column " + std::to_string(col);
}

Samples read_samples(const FileSource& file, const HeightRequest& request) {
  const std::string& name = file.name();
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
  // The project's own limit is checked below; libpng's would be one million a side.
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);

  Samples samples;
  if (!read_header(png, info, samples)) refuse(name, std::string("PNG: ") + source.message);
  require_grid(samples.cols, samples.rows, request, name);
  const std::size_t row_bytes = png_get_rowbytes(png, info);
  samples.bytes.resize(row_bytes * samples.rows);
  samples.row_starts.resize(samples.rows);
  for (png_uint_32 row = 0; row < samples.rows; ++row)
    samples.row_starts[row] = samples.bytes.data() + row_bytes * row;
  if (!read_rows(png, samples)) refuse(name, std::string("PNG: ") + source.message);
  return samples;
}

}  // namespace

bool is_png(std::string_view head) {
  return head.size() >= 8 && png_sig_cmp(reinterpret_cast<png_const_bytep>(head.data()), 0, 8) == 0;
}

RawHeights decode_png(const FileSource& source, const HeightRequest& request) {
  const std::string& name = source.name();
  const Samples samples = read_samples(source, request);
  const int sample_bytes = samples.file_bits == 16 ? 2 : 1;
  const int colours = samples.channels - (samples.has_alpha ? 1 : 0);
  // Sub-byte codes arrive multiplied up to 0..255.
  const int scale = samples.file_bits < 8 ? 255 / ((1 << samples.file_bits) - 1) : 1;
  const int opaque = sample_bytes == 2 ? 65535 : 255;

  RawHeights raw;
  raw.full_scale = samples.file_bits == 16 ? 65535 : (1 << samples.file_bits) - 1;
  raw.format = "PNG, " + std::to_string(samples.file_bits) + " bit " +
               (colours == 1 ? "grey" : "colour with R = G = B");
  raw.values.resize(samples.rows, samples.cols);
  for (png_uint_32 row = 0; row < samples.rows; ++row) {
    const unsigned char* next = samples.row_starts[row];
    for (png_uint_32 col = 0; col < samples.cols; ++col) {
      int channel[4] = {};
      for (int i = 0; i < samples.channels; ++i) {
        channel[i] = sample_bytes == 2 ? next[0] << 8 | next[1] : next[0];
        next += sample_bytes;
      }
      if (colours == 3 && !(channel[0] == channel[1] && channel[1] == channel[2]))
        refuse(name, place(row, col) + " has R, G, B = " + std::to_string(channel[0]) + ", " +
                         std::to_string(channel[1]) + ", " + std::to_string(channel[2]) +
                         "; heights need grey, R = G = B");
      if (samples.has_alpha && channel[colours] != opaque)
        refuse(name, place(row, col) + " is transparent (alpha " +
                         std::to_string(channel[colours]) + " of " + std::to_string(opaque) +
                         "), so it carries no height");
      raw.values(row, col) = channel[0] / scale;
    }
  }
  return raw;
}

}  // namespace evaluation::detail
