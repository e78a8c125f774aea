// Heights as text: a matrix, or points.
#pragma once

#include "evaluation/readers/height_formats.h"

namespace evaluation::detail {

/// Whether numbers follow what may stand above them, in UTF-8 or UTF-16 with its mark.
bool is_text(std::string_view head);
/// A matrix, or x, y, z on a regular grid. Three columns are points where a line names them x, y,
/// z, or where they fill a grid; a matrix where a header says so, or up to three rows. Anything
/// else of three columns is refused.
RawHeights decode_text(const FileSource& source, const HeightRequest& request);

}  // namespace evaluation::detail
