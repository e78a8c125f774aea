#include "evaluation/advice/input.h"

#include <cmath>

#include "brdf/levelling.h"

namespace evaluation {

SamplingAdvice advise_sampling(const AdviceScene& scene) {
  const brdf::HeightField& field = scene.heights();
  const brdf::QueryBounds bounds = bounds_of(scene.request, scene.tolerance);
  const auto limit_um = [](double lo_per_um, double hi_per_um) {
    return brdf::pi / std::max(std::abs(lo_per_um), std::abs(hi_per_um));
  };
  const auto excess = nyquist_excess(scene.request, field);
  SamplingAdvice advice{
      SamplingVerdict::sampled,
      {field.dx_um(), field.dy_um()},
      {limit_um(bounds.lo.qx_per_um, bounds.hi.qx_per_um),
       limit_um(bounds.lo.qy_per_um, bounds.hi.qy_per_um)},
      std::pair(scene.request.theta_r_deg.front(), scene.request.theta_r_deg.back())};
  if (excess) {
    advice.verdict = SamplingVerdict::undersampled;
    advice.safe_deg = excess->safe_deg;
  }
  return advice;
}

HeightsAdvice advise_heights(const AdviceScene& scene) {
  const double error_rad =
      brdf::input_phase_error_rad(scene.heights(), bounds_of(scene.request, scene.tolerance));
  return {scene.tolerance < error_rad ? HeightsVerdict::too_coarse : HeightsVerdict::fine_enough,
          scene.heights().height_step_um(), error_rad};
}

TiltAdvice advise_tilt(const AdviceScene& scene) {
  const brdf::HeightField& field = scene.heights();
  const Eigen::Vector2d slopes = brdf::plane_slopes(field);
  const auto angle = [](double slope) { return brdf::Angle::rad(std::atan(slope)); };
  TiltAdvice advice{};
  advice.along_x = angle(slopes.x());
  advice.along_y = angle(slopes.y());
  advice.steepest = angle(slopes.norm());
  advice.mirror_shift = brdf::Angle::rad(2 * advice.steepest.rad());
  advice.lobe_width =
      brdf::Angle::rad(lobe_width_sine(scene.surface, scene.request.phi_i, scene.shortest_um()) /
                       std::cos(scene.nearest_to_mirror().rad()));
  advice.rise_um =
      std::abs(slopes.x()) * field.width_um() + std::abs(slopes.y()) * field.height_um();
  advice.peak_to_valley_um = 2 * field.half_range_um();
  const bool moves_lobe = advice.mirror_shift > advice.lobe_width;
  const bool is_most = advice.rise_um > most_of_the_range * advice.peak_to_valley_um;
  // What is left of a plane that was taken off is rounding.
  const bool is_rounding = advice.rise_um <= 1e-9 * advice.peak_to_valley_um;
  advice.verdict =
      (moves_lobe || is_most) && !is_rounding ? TiltVerdict::tilted : TiltVerdict::level;
  return advice;
}

}  // namespace evaluation
