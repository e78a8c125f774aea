// A picture of a table of checks.
#pragma once

#include <string>
#include <vector>

#include "apps/picture_format.h"
#include "evaluation/checks.h"

namespace apps {

struct ChecksPicture {
  std::vector<evaluation::CheckRow> rows;
  std::string title;
};

/// The bytes of a file: a line per row, from its worst error (a point) to its limit (a bar), on one
/// logarithmic scale; red where it failed; a diamond where some cases were refused, and nothing
/// else where all were. Throws Errc::cannot_write where gnuplot is missing or fails.
std::string draw(const ChecksPicture& picture, PictureFormat format);

}  // namespace apps
