// Two maps of colours held against each other.
#pragma once

#include <cstddef>
#include <filesystem>

#include "evaluation/npy.h"

namespace evaluation {

/// The colours of a map as they lie on disk: lights x rows x columns x 3, linear XYZ.
///
/// Throws Errc::bad_input naming the file: no NPY of doubles, or of another shape.
NpyFile read_map(const std::filesystem::path& path);

/// How different two maps look.
struct MapDifference {
  double worst = 0, mean = 0, percentile_99 = 0;  ///< CIEDE2000
  std::size_t light = 0, row = 0, column = 0;     ///< of the worst
  std::size_t pixels = 0;                         ///< with any light in either
};

/// CIEDE2000 of each pixel's colours times the exposure as they are shown, clipped to sRGB.
///
/// Throws Errc::bad_input where the shapes differ or no pixel has light.
MapDifference map_difference(const NpyFile& map, const NpyFile& reference, double exposure);

}  // namespace evaluation
