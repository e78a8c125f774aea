// What an OpenEXR header says of the places of pixels, checked before OpenEXR trusts it.
#pragma once

#include <OpenEXR/ImfHeader.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "evaluation/readers/height_formats.h"

namespace evaluation::detail {

/// Refuses a file in the words of OpenEXR or of this reader.
struct ExrRefusal {
  const FileSource& source;
  [[noreturn]] void operator()(std::string what) const;
};

// The magic number and the version with its flags.
inline constexpr std::size_t preamble_bytes = 8;
inline constexpr std::uint32_t tiled_flag = 0x200, deep_flag = 0x800, parts_flag = 0x1000;

/// Refuses a header that does not end within the head of the file. OpenEXR takes the length of an
/// attribute for granted: walked over here, none is longer than what is there.
void require_whole_header(std::string_view head, const ExrRefusal& refuse);

struct ExrWindow {
  Imath::Box2i box;
  std::uint64_t cols, rows;
};

/// The grid, checked before the library takes memory for its tables.
ExrWindow checked_window(const Imf::Header& header, bool is_tiled, const FileSource& source,
                         const HeightRequest& request);

/// Refuses a table of places, at `at`, that does not lead into the file for each block: the library
/// would look for the blocks in all of it.
void require_places(const Imf::Header& header, bool is_tiled, const ExrWindow& window,
                    std::uint64_t at, const FileSource& source);

}  // namespace evaluation::detail
