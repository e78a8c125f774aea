#include "evaluation/readers/tiff_reader.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "brdf/error.h"
#include "evaluation/readers/samples.h"
#include "evaluation/readers/stored_number.h"
#include "evaluation/readers/tiff_file.h"

namespace evaluation::detail {
namespace {

/// How a sample is stored, and read as a number.
struct SampleKind {
  std::uint16_t format, bits;
  double (*number)(const char* bytes);
  std::string_view name;
};

template <class T>
double number(const char* bytes) {
  return static_cast<double>(stored_number<T>(bytes, std::endian::native));
}

constexpr std::array sample_kinds{
    SampleKind{SAMPLEFORMAT_UINT, 8, number<std::uint8_t>, "8 bit"},
    SampleKind{SAMPLEFORMAT_UINT, 16, number<std::uint16_t>, "16 bit"},
    SampleKind{SAMPLEFORMAT_UINT, 32, number<std::uint32_t>, "32 bit unsigned"},
    SampleKind{SAMPLEFORMAT_INT, 8, number<std::int8_t>, "8 bit signed"},
    SampleKind{SAMPLEFORMAT_INT, 16, number<std::int16_t>, "16 bit signed"},
    SampleKind{SAMPLEFORMAT_INT, 32, number<std::int32_t>, "32 bit signed"},
    SampleKind{SAMPLEFORMAT_IEEEFP, 32, number<float>, "32 bit float"},
    SampleKind{SAMPLEFORMAT_IEEEFP, 64, number<double>, "64 bit float"},
};

/// A lossless compression, and more bytes than it makes of one of the file.
struct Compression {
  std::uint16_t code;
  std::uint64_t largest_ratio;
};

constexpr std::array compressions{
    Compression{COMPRESSION_NONE, 1},
    Compression{COMPRESSION_PACKBITS, 64},  // 128 bytes from two
    Compression{COMPRESSION_LZW, 4096},     // at most 4096 bytes from a code of 9 bits or more
    Compression{COMPRESSION_ADOBE_DEFLATE, 1032},  // 258 bytes from two bits
    Compression{COMPRESSION_DEFLATE, 1032},
    Compression{COMPRESSION_LZMA, 1 << 14},  // twice what it makes of zeros
    Compression{COMPRESSION_ZSTD, 1 << 16},  // a block of 128 KiB from four bytes
};

// Tiles are padded beyond the picture, small pictures by much; no writer's tiles are larger.
constexpr std::uint64_t widest_tile = 1024;

/// GDAL's tag: the number of a missing pixel, as text.
constexpr ttag_t missing_number_tag = 42113;

/// What a directory says of its picture, checked before memory is taken for it.
struct Picture {
  std::uint32_t cols, rows;
  std::uint16_t samples;  ///< of a pixel
  const SampleKind* kind;
  std::size_t pixel_bytes() const { return samples * kind->bits / 8u; }
};

void choose_picture(const TiffFile& file, const HeightRequest& request) {
  if (!request.channel) {
    if (!TIFFLastDirectory(file.get()))
      file.refuse("holds several pictures; --channel N takes one, the first is 1");
    return;
  }
  const std::string& text = *request.channel;
  std::uint16_t index = 0;
  const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (ec != std::errc{} || end != text.data() + text.size() || index < 1 ||
      !TIFFSetDirectory(file.get(), static_cast<tdir_t>(index - 1)))
    throw brdf::Error(brdf::Errc::invalid_argument,
                      file.source().name() + ": --channel " + text +
                          ": there is no picture of that number; the first is 1");
}

const SampleKind& kind_of(const TiffFile& file) {
  const auto bits = file.field<std::uint16_t>(TIFFTAG_BITSPERSAMPLE, "BitsPerSample");
  const auto format = file.field<std::uint16_t>(TIFFTAG_SAMPLEFORMAT, "SampleFormat");
  const auto found = std::ranges::find_if(sample_kinds, [&](const SampleKind& kind) {
    return kind.bits == bits && kind.format == format;
  });
  if (found == sample_kinds.end())
    file.refuse(std::to_string(bits) + " bits of sample format " + std::to_string(format) +
                "; read are integers of 8, 16 and 32 bits and floats of 32 and 64");
  return *found;
}

std::uint64_t largest_ratio(const TiffFile& file) {
  const auto code = file.field<std::uint16_t>(TIFFTAG_COMPRESSION, "Compression");
  const auto found = std::ranges::find(compressions, code, &Compression::code);
  if (found == compressions.end() || !TIFFIsCODECConfigured(code))
    file.refuse("compression " + std::to_string(code) +
                "; read are none, PackBits, LZW, Deflate, LZMA and ZSTD where libtiff has them");
  return found->largest_ratio;
}

/// Refuses what is stored in another way than rows from the top of samples that grow with height.
void require_plain_grey(const TiffFile& file, std::uint16_t samples) {
  std::uint16_t photometric = 0;
  if (!TIFFGetField(file.get(), TIFFTAG_PHOTOMETRIC, &photometric))
    file.refuse("has no PhotometricInterpretation");
  if (photometric == PHOTOMETRIC_MINISWHITE)
    file.refuse("photometric interpretation WhiteIsZero, whose codes fall with brightness");
  if (!(photometric == PHOTOMETRIC_MINISBLACK && samples == 1) &&
      !(photometric == PHOTOMETRIC_RGB && samples == 3))
    file.refuse("photometric interpretation " + std::to_string(photometric) + " with " +
                std::to_string(samples) + " samples a pixel; read are grey (1) and RGB (2) alone");
  const auto planes = file.field<std::uint16_t>(TIFFTAG_PLANARCONFIG, "PlanarConfiguration");
  if (samples > 1 && planes != PLANARCONFIG_CONTIG)
    file.refuse("colours in separate planes; read are colours side by side");
  const auto orientation = file.field<std::uint16_t>(TIFFTAG_ORIENTATION, "Orientation");
  if (orientation != ORIENTATION_TOPLEFT)
    file.refuse("orientation " + std::to_string(orientation) +
                "; read is 1, the first row at the top and the first column at the left");
  if (file.field<std::uint32_t>(TIFFTAG_IMAGEDEPTH, "ImageDepth") != 1)
    file.refuse("holds a volume; read are pictures");
}

Picture checked_picture(const TiffFile& file, const HeightRequest& request) {
  TIFF* const tiff = file.get();
  Picture picture{file.field<std::uint32_t>(TIFFTAG_IMAGEWIDTH, "ImageWidth"),
                  file.field<std::uint32_t>(TIFFTAG_IMAGELENGTH, "ImageLength"),
                  file.field<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL, "SamplesPerPixel"), nullptr};
  require_grid(picture.cols, picture.rows, request, file.source().name());
  picture.kind = &kind_of(file);
  require_plain_grey(file, picture.samples);
  std::uint64_t bytes = picture.pixel_bytes() * picture.cols * picture.rows;
  if (TIFFIsTiled(tiff)) {
    const auto width = file.field<std::uint32_t>(TIFFTAG_TILEWIDTH, "TileWidth");
    const auto length = file.field<std::uint32_t>(TIFFTAG_TILELENGTH, "TileLength");
    if (width == 0 || length == 0 || width > std::max<std::uint64_t>(picture.cols, widest_tile) ||
        length > std::max<std::uint64_t>(picture.rows, widest_tile))
      file.refuse("tiles of " + std::to_string(width) + " x " + std::to_string(length) +
                  " pixels, larger than the picture and than " + std::to_string(widest_tile));
    bytes = picture.pixel_bytes() * width * length * ((picture.cols - 1) / width + 1) *
            ((picture.rows - 1) / length + 1);
  }
  const std::uint64_t ratio = largest_ratio(file), size = file.source().size();
  if (bytes / ratio > size)
    file.refuse("declares " + std::to_string(bytes) + " bytes of samples; a file of " +
                std::to_string(size) + " bytes holds at most " + std::to_string(size * ratio));
  return picture;
}

/// Puts the pixels of one row into the field, from a column on.
void store(const TiffFile& file, const Picture& picture, const char* bytes, std::uint32_t row,
           std::uint32_t first_col, std::uint32_t count, brdf::HeightArray& values) {
  const std::size_t sample_bytes = picture.kind->bits / 8u;
  for (std::uint32_t col = first_col; col < first_col + count; ++col) {
    for (std::size_t i = 1; i < picture.samples; ++i)
      if (std::memcmp(bytes, bytes + i * sample_bytes, sample_bytes) != 0)
        file.refuse("pixel at row " + std::to_string(row) + ", column " + std::to_string(col) +
                    " is coloured; heights need grey, R = G = B");
    values(row, col) = picture.kind->number(bytes);
    bytes += picture.pixel_bytes();
  }
}

void read_strips(const TiffFile& file, const Picture& picture, brdf::HeightArray& values) {
  const auto line =
      std::make_unique<char[]>(static_cast<std::size_t>(TIFFScanlineSize(file.get())));
  for (std::uint32_t row = 0; row < picture.rows; ++row) {
    if (TIFFReadScanline(file.get(), line.get(), row, 0) != 1)
      file.refuse_read("row " + std::to_string(row) + " cannot be read");
    store(file, picture, line.get(), row, 0, picture.cols, values);
  }
}

void read_tiles(const TiffFile& file, const Picture& picture, brdf::HeightArray& values) {
  const auto width = file.field<std::uint32_t>(TIFFTAG_TILEWIDTH, "TileWidth");
  const auto length = file.field<std::uint32_t>(TIFFTAG_TILELENGTH, "TileLength");
  const tmsize_t size = TIFFTileSize(file.get());
  const auto tile = std::make_unique_for_overwrite<char[]>(static_cast<std::size_t>(size));
  for (std::uint32_t top = 0; top < picture.rows; top += length)
    for (std::uint32_t left = 0; left < picture.cols; left += width) {
      const std::uint32_t index = TIFFComputeTile(file.get(), left, top, 0, 0);
      if (TIFFReadEncodedTile(file.get(), index, tile.get(), size) != size)
        file.refuse_read("tile " + std::to_string(index) + " cannot be read");
      const std::uint32_t cols = std::min(width, picture.cols - left);
      const std::uint32_t rows = std::min(length, picture.rows - top);
      for (std::uint32_t i = 0; i < rows; ++i)
        store(file, picture, tile.get() + picture.pixel_bytes() * width * i, top + i, left, cols,
              values);
    }
}

/// Pixels of the number that the file calls missing become NaN.
void mark_missing(const TiffFile& file, brdf::HeightArray& values) {
  std::uint32_t count = 0;
  const char* text = nullptr;
  if (!TIFFGetField(file.get(), missing_number_tag, &count, &text)) return;
  std::string_view digits(text, count);
  digits = digits.substr(0, digits.find('\0'));
  while (digits.starts_with(' ')) digits.remove_prefix(1);
  while (digits.ends_with(' ')) digits.remove_suffix(1);
  double missing = 0;
  const auto [end, ec] = std::from_chars(digits.data(), digits.data() + digits.size(), missing);
  if (ec != std::errc{} || end != digits.data() + digits.size())
    file.refuse("GDAL_NODATA \"" + std::string(digits.substr(0, 40)) + "\" is no number");
  values = (values == missing).select(std::numeric_limits<double>::quiet_NaN(), values);
}

}  // namespace

RawHeights decode_tiff(const FileSource& source, const HeightRequest& request) {
  const TiffFile file(source);
  file.require_no_guess();
  choose_picture(file, request);
  const Picture picture = checked_picture(file, request);
  const SampleKind& kind = *picture.kind;

  RawHeights raw;
  if (request.channel) {
    raw.channel = "picture " + *request.channel;
    raw.channels.push_back({raw.channel});
  }
  raw.values.resize(picture.rows, picture.cols);
  if (TIFFIsTiled(file.get()))
    read_tiles(file, picture, raw.values);
  else
    read_strips(file, picture, raw.values);
  file.require_no_guess();
  mark_missing(file, raw.values);
  raw.format =
      "TIFF, " + std::string(kind.name) + (picture.samples == 1 ? "" : ", colour with R = G = B");
  if (kind.format == SAMPLEFORMAT_UINT && kind.bits < 32)
    raw.full_scale = (1 << kind.bits) - 1;
  else if (kind.format != SAMPLEFORMAT_IEEEFP)
    raw.step = 1;
  else if (kind.bits == 64)
    raw.step = step_of_doubles(raw.values);
  return raw;
}

}  // namespace evaluation::detail
