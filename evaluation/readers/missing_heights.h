// Pixels of a scan that carry no height.
#pragma once

#include <cstddef>
#include <string>

#include "brdf/height_field.h"

namespace evaluation {

/// What is done with pixels that the file masks, or that are not a number.
enum class MissingHeights {
  refuse,      ///< none is let through
  neighbours,  ///< each becomes the mean of the neighbours that have a height
};

/// Fills each NaN with the mean of those of its eight neighbours that have a height, ring by ring
/// from the rim inwards: a ring is filled from what was there before it. Returns how many were
/// filled.
///
/// Throws Errc::bad_input naming the first missing pixel where they are to be refused, and where no
/// pixel has a height. Infinite heights are left to be refused by the height field.
std::size_t fill_missing(brdf::HeightArray& heights, MissingHeights policy,
                         const std::string& name);

}  // namespace evaluation
