// Files of microscopes, read through Gwyddion where it is installed.
#pragma once

#include <filesystem>

#include "evaluation/readers/height_formats.h"

namespace evaluation::detail {

/// Whether a name ends as those of microscopes do (.spm, .nid, .ibw, .jpk, ..., .000 to .999). It
/// decides alone whether another program is started for a file that no format recognises.
bool is_vendor_name(const std::filesystem::path& path);

/// What `gwyddion --convert-to-gwy` makes of a file, which it takes no display for. It is looked
/// for on the PATH, started without a shell and with an environment of its own, in a folder that is
/// removed afterwards, and killed after a minute.
///
/// Throws Errc::bad_input where it is not installed, does not know the file, or takes too long, and
/// as decode_gwy.
RawHeights decode_through_gwyddion(const std::filesystem::path& path, const HeightRequest& request);

}  // namespace evaluation::detail
