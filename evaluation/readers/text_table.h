// Rows of numbers in a text.
#pragma once

#include <functional>
#include <string>

#include "brdf/height_field.h"
#include "evaluation/readers/text_lines.h"

namespace evaluation::detail {

/// The numbers of a text, and how exactly they were written.
struct TextTable {
  brdf::HeightArray values;  ///< NaN where a cell is empty or "nan"
  int digits = 0;            ///< most significant ones of a number
};

/// Whether a line may hold a row: a number, or "nan", and no character of anything else.
bool looks_like_numbers(std::string_view line);

/// Reads the line that `lines` stands on and all behind it; blank ones are stepped over.
///
/// Cells are parted by semicolons where the first line has one, else by tabs, else by commas, else
/// by blanks; a separator at the end of a line opens no cell, unless the row lacks one. `require`
/// is called with the numbers of columns and rows before memory is taken. Throws Errc::bad_input
/// with line and column for a cell that is no number, such as one with a decimal comma or beyond
/// the range of double, and with the line for rows of another length.
TextTable read_text_table(TextLines lines,
                          const std::function<void(std::size_t, std::size_t)>& require);

}  // namespace evaluation::detail
