// Arrays of NumPy as heights.
#pragma once

#include "evaluation/readers/height_formats.h"

namespace evaluation::detail {

/// Whether a file begins as NPY does, whatever its shape.
bool is_npy_heights(std::string_view head);
/// Two axes, rows and columns; float or integer of any order, integers as the numbers they are.
RawHeights decode_npy(const FileSource& source, const HeightRequest& request);

}  // namespace evaluation::detail
