// The colour that a surface has for pairs of directions.
#pragma once

#include <span>
#include <vector>

#include "brdf/colour_matching.h"
#include "evaluation/reflectance.h"
#include "evaluation/sweep.h"

namespace evaluation {

/// Gives linear XYZ under D65, Y = 1 for a white surface; neither exposed nor clipped.
class DirectionColours {
 public:
  virtual ~DirectionColours() = default;
  /// colours[j] of pairs[j]; it depends on that pair only. May be called from many threads.
  virtual void evaluate(std::span<const DirectionPair> pairs,
                        std::span<brdf::Xyz> colours) const = 0;
};

/// The colours of all pairs. Bit-identical for any number of threads. Pairs near each other are
/// faster than scattered ones: a picture is best listed block by block.
///
/// Throws Errc::over_limit past the time limit; Errc::not_attainable for a colour that is not
/// finite.
std::vector<brdf::Xyz> colours_of(std::span<const DirectionPair> pairs,
                                  const DirectionColours& surface, const RunLimits& limits,
                                  const Progress& progress = {});

}  // namespace evaluation
