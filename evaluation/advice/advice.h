// What a scene requires of the model: everything that can be said before anything is computed.
#pragma once

#include "evaluation/advice/sweep_plan.h"

namespace evaluation {

struct Advice {
  SurfaceMeasures surface;
  SamplingAdvice sampling;
  HeightsAdvice heights;
  TiltAdvice tilt;
  CoherenceAdvice coherence;
  OpticsAdvice optics;
  ScalarAdvice scalar;
  OrdersAdvice orders;
  StepsAdvice steps;
  MethodAdvice method;
};

/// Bytes that `advise` takes for a height field beside it: levelled heights, spectrum,
/// autocorrelation.
std::size_t advice_bytes(const brdf::HeightField& heights);

/// Cost: three transforms of the height field. Throws Errc::invalid_argument as `require_valid`.
Advice advise(const AdviceScene& scene);

}  // namespace evaluation
