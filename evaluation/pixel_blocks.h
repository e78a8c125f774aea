// The order of pixels in which neighbours stay together.
#pragma once

#include <algorithm>

namespace evaluation {

/// Pixels along a side of a block.
inline constexpr int block_side = 16;

/// Calls visit(column, row) for each pixel of a picture, block by block.
template <class Visit>
void in_blocks(int columns, int rows, Visit visit) {
  for (int top = 0; top < rows; top += block_side)
    for (int left = 0; left < columns; left += block_side)
      for (int row = top; row < std::min(top + block_side, rows); ++row)
        for (int column = left; column < std::min(left + block_side, columns); ++column)
          visit(column, row);
}

}  // namespace evaluation
