// The hemisphere of viewing directions as a square of pixels.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "brdf/directions.h"

namespace evaluation {

/// Orthographic: a pixel's place is (sin theta cos phi, sin theta sin phi), x to the right, y
/// upwards; the disk of the hemisphere touches the sides of the square.
class Hemisphere {
 public:
  /// size: pixels along a side, >= 2, else Errc::invalid_argument.
  explicit Hemisphere(int size);

  int size() const { return size_; }
  /// The direction at the centre of a pixel, row 0 at the bottom; empty outside the disk.
  std::optional<brdf::Direction> direction(int column, int row) const;

  /// A pixel inside the disk.
  struct Pixel {
    int column, row;
    std::size_t index(int size) const {
      return static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
             static_cast<std::size_t>(column);
    }
  };
  /// All pixels inside the disk, in blocks of 16 x 16.
  const std::vector<Pixel>& pixels() const { return pixels_; }

 private:
  int size_;
  std::vector<Pixel> pixels_;
};

}  // namespace evaluation
