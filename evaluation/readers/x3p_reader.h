// X3P, ISO 25178-72: a zip archive with main.xml and binary data.
#pragma once

#include <string_view>

#include "evaluation/readers/height_formats.h"

namespace evaluation::detail {

/// Any zip archive; whether it holds a surface is seen when it is read.
inline bool is_x3p(std::string_view head) {
  return head.starts_with("PK\3\4");
}

/// A matrix of heights in metres with equal steps along x and y, the first row at the top.
RawHeights decode_x3p(const FileSource& source, const HeightRequest& request);

}  // namespace evaluation::detail
