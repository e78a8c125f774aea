// Gwyddion's native files.
#pragma once

#include "evaluation/readers/height_formats.h"

namespace evaluation::detail {

bool is_gwy(std::string_view head);
/// One channel of the container, its masked pixels missing.
RawHeights decode_gwy(const FileSource& source, const HeightRequest& request);

}  // namespace evaluation::detail
