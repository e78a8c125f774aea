// The scale that Gwyddion writes into a PNG.
#pragma once

#include <map>
#include <string>

#include "evaluation/readers/height_formats.h"

namespace evaluation::detail {

/// Text chunks of a PNG by their keys.
using PngTexts = std::map<std::string, std::string>;

/// Sets what the `Gwy::` keys say: pixel, heights of the codes, title, unit of height. Lengths are
/// in Gwy::XYUnit and Gwy::ZUnit; what is given in another unit is left unset.
///
/// Throws Errc::bad_input for a value that is no number, a side that is not positive, a range that
/// is upside down.
void take_png_scale(const PngTexts& texts, const std::string& name, RawHeights& raw);

}  // namespace evaluation::detail
