// Advice on the input: its sampling, the spacing of its heights, its tilt.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "evaluation/advice/scene.h"

namespace evaluation {

enum class SamplingVerdict { sampled, undersampled };

/// A pixel must be smaller than lambda / (2 abs(u)) along each axis.
struct SamplingAdvice {
  SamplingVerdict verdict;
  std::array<double, 2> pixel_um;  ///< along x, y
  std::array<double, 2>
      limit_um;  ///< at the shortest wavelength; infinite where u is 0 along the axis
  std::optional<std::pair<double, double>> safe_deg;  ///< all of those asked for, where sampled
};
SamplingAdvice advise_sampling(const AdviceScene& scene);

enum class HeightsVerdict { fine_enough, too_coarse };

/// The stored heights are right to half a step; what that does to the amplitude is at most its
/// phase.
struct HeightsAdvice {
  HeightsVerdict verdict;
  double step_um;          ///< 0 for floating-point heights
  double phase_error_rad;  ///< k abs(w) step / 2 at the shortest wavelength: tolerance it can bear
};
HeightsAdvice advise_heights(const AdviceScene& scene);

enum class TiltVerdict { level, tilted };

/// A surface tilted by t sends the mirror lobe 2 t aside.
struct TiltAdvice {
  TiltVerdict verdict;
  brdf::Angle along_x, along_y, steepest;  ///< of the least-squares plane
  brdf::Angle mirror_shift;                ///< 2 x the steepest
  brdf::Angle lobe_width;  ///< full, at half maximum, shortest wavelength, at the mirror direction
  double rise_um;          ///< of the plane from corner to corner
  double peak_to_valley_um;  ///< of the heights with the plane
};
TiltAdvice advise_tilt(const AdviceScene& scene);

/// The least part of peak to valley that a plane must rise to be most of it.
inline constexpr double most_of_the_range = 0.5;

}  // namespace evaluation
