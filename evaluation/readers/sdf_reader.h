// Surface Data File, ISO 25178-71, text and binary.
#pragma once

#include <string_view>

#include "evaluation/readers/height_formats.h"

namespace evaluation::detail {

/// "aBCR-" and "bBCR-" of any version, "aISO-" and "bISO-" of 1.0 and 2.0.
bool is_sdf(std::string_view head);

/// Heights in metres, rows as they are stored, the first at the top as Gwyddion shows them. BAD, a
/// NaN, and in a binary file the lowest number of a signed or floating type are missing pixels.
RawHeights decode_sdf(const FileSource& source, const HeightRequest& request);

}  // namespace evaluation::detail
