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

/// Cost: three transforms of the height field. Throws Errc::invalid_argument as `require_valid`.
Advice advise(const AdviceScene& scene);

}  // namespace evaluation
