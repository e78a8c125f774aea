// TIFF and BigTIFF, through libtiff.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "evaluation/readers/height_formats.h"

namespace evaluation::detail {

inline bool is_tiff(std::string_view head) {
  using namespace std::string_view_literals;
  constexpr std::array magics{"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv};
  return std::ranges::any_of(magics,
                             [&](std::string_view magic) { return head.starts_with(magic); });
}

/// Grey or R = G = B, of 8, 16 or 32 bits as integers, 32 or 64 as floating point, in strips or
/// tiles. Unsigned codes of 8 and 16 bits have a full scale; other integers and floats are numbers.
RawHeights decode_tiff(const FileSource& source, const HeightRequest& request);

}  // namespace evaluation::detail
