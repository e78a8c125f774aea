#include "evaluation/readers/openexr_layout.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfTileDescription.h>

#include <algorithm>
#include <array>

#include "brdf/error.h"
#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

/// How a compression stores lines.
struct Packing {
  Imf::Compression compression;
  std::uint64_t lines;          ///< of a block
  std::uint64_t largest_ratio;  ///< more bytes than it makes of one of the file
};

// Run lengths make 128 bytes of two, B44 32 of three, Deflate 1032 of one; the others, which pack
// Deflate or Huffman codes of run lengths, are given room.
constexpr std::array packings{
    Packing{Imf::NO_COMPRESSION, 1, 1},          Packing{Imf::RLE_COMPRESSION, 1, 64},
    Packing{Imf::ZIPS_COMPRESSION, 1, 1032},     Packing{Imf::ZIP_COMPRESSION, 16, 1032},
    Packing{Imf::PIZ_COMPRESSION, 32, 1 << 16},  Packing{Imf::PXR24_COMPRESSION, 16, 4 * 1032},
    Packing{Imf::B44_COMPRESSION, 32, 11},       Packing{Imf::B44A_COMPRESSION, 32, 11},
    Packing{Imf::DWAA_COMPRESSION, 32, 1 << 16}, Packing{Imf::DWAB_COMPRESSION, 256, 1 << 16},
};

const Packing& packing_of(const Imf::Header& header, const ExrRefusal& refuse) {
  const auto found = std::ranges::find(packings, header.compression(), &Packing::compression);
  if (found == packings.end())
    refuse("compression " + std::to_string(static_cast<int>(header.compression())) +
           " is not known");
  return *found;
}

// Tiles are padded beyond the picture, small pictures by much; no writer's tiles are larger.
constexpr std::uint64_t widest_tile = 1024;

}  // namespace

void ExrRefusal::operator()(std::string what) const {
  std::ranges::replace(what, '\n', ' ');
  throw brdf::Error(brdf::Errc::bad_input, source.name() + ": OpenEXR: " + what);
}

void require_whole_header(std::string_view head, const ExrRefusal& refuse) {
  std::size_t at = preamble_bytes;
  const auto skip = [&](std::size_t count) {
    if (count > head.size() - at)
      refuse("header does not end within " + std::to_string(head.size()) + " bytes");
    at += count;
  };
  const auto skip_text = [&] {
    const std::size_t end = head.find('\0', at);
    skip(end == std::string_view::npos ? head.size() : end - at + 1);
  };
  skip(0);
  while (at < head.size() && head[at] != '\0') {
    skip_text();  // name
    skip_text();  // type
    skip(4);
    skip(stored_number<std::uint32_t>(head.data() + at - 4));
  }
  skip(1);
}

ExrWindow checked_window(const Imf::Header& header, bool is_tiled, const FileSource& source,
                         const HeightRequest& request) {
  const ExrRefusal refuse{source};
  const Imath::Box2i& box = header.dataWindow();
  const auto extent = [](int low, int high) -> std::uint64_t {
    return high < low ? 0 : static_cast<std::uint64_t>(std::int64_t{high} - low + 1);
  };
  const ExrWindow window{box, extent(box.min.x, box.max.x), extent(box.min.y, box.max.y)};
  require_grid(window.cols, window.rows, request, source.name());
  std::uint64_t pixel_bytes = 0;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
      refuse(std::string("channel ") + channel.name() + " is not sampled at every pixel");
    pixel_bytes += channel.channel().type == Imf::HALF ? 2 : 4;
  }
  if (is_tiled) {
    const Imf::TileDescription& tiles = header.tileDescription();
    if (tiles.mode != Imf::ONE_LEVEL) refuse("tiles of several levels; read is one level");
    if (tiles.xSize == 0 || tiles.ySize == 0 || tiles.xSize > std::max(window.cols, widest_tile) ||
        tiles.ySize > std::max(window.rows, widest_tile))
      refuse("tiles of " + std::to_string(tiles.xSize) + " x " + std::to_string(tiles.ySize) +
             " pixels, larger than the picture and than " + std::to_string(widest_tile));
  }
  const std::uint64_t bytes = window.cols * window.rows * pixel_bytes, size = source.size();
  const std::uint64_t ratio = packing_of(header, refuse).largest_ratio;
  if (bytes / ratio > size)
    refuse("declares " + std::to_string(bytes) + " bytes of pixels; a file of " +
           std::to_string(size) + " bytes holds at most " + std::to_string(size * ratio));
  return window;
}

void require_places(const Imf::Header& header, bool is_tiled, const ExrWindow& window,
                    std::uint64_t at, const FileSource& source) {
  const ExrRefusal refuse{source};
  const auto parts = [](std::uint64_t whole, std::uint64_t part) { return (whole - 1) / part + 1; };
  std::uint64_t left = parts(window.rows, packing_of(header, refuse).lines);
  if (is_tiled)
    left = parts(window.cols, header.tileDescription().xSize) *
           parts(window.rows, header.tileDescription().ySize);
  const std::uint64_t end = at + 8 * left;
  std::array<char, 1 << 12> piece;
  while (left > 0) {
    const std::uint64_t count = std::min<std::uint64_t>(left, piece.size() / 8);
    if (source.read_at(at, piece.data(), 8 * count) != 8 * count) refuse("file is truncated");
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto place = stored_number<std::uint64_t>(piece.data() + 8 * i);
      if (place < end || place >= source.size())
        refuse("a line or tile lies at byte " + std::to_string(place) + " of " +
               std::to_string(source.size()) + "; file is truncated or was not finished");
    }
    at += 8 * count;
    left -= count;
  }
}

}  // namespace evaluation::detail
