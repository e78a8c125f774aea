#include "evaluation/advice/advice.h"

namespace evaluation {

std::size_t advice_bytes(const brdf::HeightField& heights) {
  const auto rows = static_cast<std::size_t>(heights.rows());
  const auto cols = static_cast<std::size_t>(heights.cols());
  return rows * cols * sizeof(double) + 2 * brdf::HeightSpectrum::bytes(rows, cols);
}

Advice advise(const AdviceScene& scene) {
  require_valid(scene);
  SurfaceMeasures surface = measured(scene.heights());
  const SamplingAdvice sampling = advise_sampling(scene);
  const HeightsAdvice heights = advise_heights(scene);
  const TiltAdvice tilt = advise_tilt(scene);
  const CoherenceAdvice coherence = advise_coherence(scene, surface);
  const OpticsAdvice optics = advise_optics(scene, surface);
  const ScalarAdvice scalar = advise_scalar(scene, surface);
  const OrdersAdvice orders = advise_orders(scene, surface);
  const StepsAdvice steps = advise_steps(scene, optics);
  const MethodAdvice method = advise_method(scene, surface, sampling, heights, tilt, optics, steps);
  return {std::move(surface),
          sampling,
          heights,
          tilt,
          coherence,
          optics,
          scalar,
          orders,
          steps,
          method};
}

}  // namespace evaluation
