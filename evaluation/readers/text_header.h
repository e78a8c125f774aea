// The lines above the numbers of a text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "brdf/units.h"
#include "evaluation/readers/text_lines.h"

namespace evaluation::detail {

/// What the lines above the numbers say.
struct TextHeader {
  bool is_matrix = false;  ///< one of Gwyddion's lines for a matrix is there
  bool is_points = false;  ///< the columns are called x, y, z
  std::string title;
  std::optional<brdf::Length> width, height;
  std::string x_unit, y_unit, z_unit;  ///< as they are written; empty where they are not
};

/// Steps over blank lines, lines that begin with # or %, and a line that names the columns x, y, z.
/// Afterwards `lines` stands on the first other line. False where there is none.
///
/// Known are the lines that Gwyddion writes, "Channel: ", "Width: ", "Height: " and "Value units:
/// ", in all its languages, and names such as "x [um]", "y (um)", "z_nm". Others say nothing.
/// Throws Errc::bad_input for a width or height with a decimal comma, or that is not positive.
bool read_text_header(TextLines& lines, TextHeader& header);

/// Without blanks, no-break spaces among them, at either end.
std::string_view trimmed(std::string_view text);

}  // namespace evaluation::detail
