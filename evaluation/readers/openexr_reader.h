// OpenEXR, through the library of that name.
#pragma once

#include <string_view>

#include "evaluation/readers/height_formats.h"

namespace evaluation::detail {

inline bool is_openexr(std::string_view head) {
  return head.starts_with("\x76\x2f\x31\x01");
}

/// One channel of a single part in scan lines or tiles of one level; the numbers have no unit.
RawHeights decode_openexr(const FileSource& source, const HeightRequest& request);

}  // namespace evaluation::detail
