#include "evaluation/advice/optics.h"

#include <algorithm>
#include <cmath>

namespace evaluation {
namespace {

using brdf::Angle;
using brdf::SurfaceModel;

WindowVerdict window_verdict(SurfaceModel model, double edge) {
  if (model == SurfaceModel::periodic) return WindowVerdict::repeated;
  if (model == SurfaceModel::replicated) return WindowVerdict::even;
  return edge > smooth_edge ? WindowVerdict::cut : WindowVerdict::smooth;
}

/// Angle between directions whose sines are `sine` apart along an azimuth, seen at theta: along the
/// plane of incidence it is stretched by 1 / cos theta, across it is not.
Angle seen_apart(double sine, Angle azimuth_from_plane, Angle theta) {
  return Angle::rad(sine * std::hypot(std::cos(azimuth_from_plane.rad()) / std::cos(theta.rad()),
                                      std::sin(azimuth_from_plane.rad())));
}

}  // namespace

std::vector<std::size_t> fundamentals(const SurfaceMeasures& surface) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < surface.periods.size(); ++i)
    if (!surface.periods[i].harmonic) indices.push_back(i);
  return indices;
}

CoherenceAdvice advise_coherence(const AdviceScene& scene, const SurfaceMeasures& surface) {
  const brdf::HeightField& field = scene.heights();
  const brdf::GaussianWindow& window = scene.surface.window;
  CoherenceAdvice advice{};
  advice.sigma_um = window.sigma_um();
  advice.area_um2 = brdf::coherence_area_um2(scene.surface);
  advice.length_um = coherence_length_um(scene.surface, scene.request.phi_i);
  advice.edge_x = window.spatial(field.width_um() / 2);
  advice.edge_y = window.spatial(field.height_um() / 2);
  // A single row or column is no edge but all there is.
  const double edge =
      std::max(field.cols() > 1 ? advice.edge_x : 0.0, field.rows() > 1 ? advice.edge_y : 0.0);
  advice.verdict = window_verdict(scene.surface.model, edge);
  for (const HeightPeriod& period : surface.periods)
    advice.periods_inside.push_back(coherence_length_um(scene.surface, period.azimuth) /
                                    period.period.um());
  return advice;
}

OpticsAdvice advise_optics(const AdviceScene& scene, const SurfaceMeasures& surface) {
  const double lambda_um = scene.longest_um(), w = scene.mirror_abs_w();
  const double k_per_um = brdf::wavenumber_per_um(brdf::Length::um(lambda_um));
  const double lobe_sine = lobe_width_sine(scene.surface, scene.request.phi_i, lambda_um);
  OpticsAdvice advice{};
  advice.seen_at = scene.nearest_to_mirror();
  advice.lobe_width = seen_apart(lobe_sine, {}, advice.seen_at);
  advice.phase_depth_rad = k_per_um * w * surface.peak_to_valley_um;
  // Stationary phase: a slope s sends light abs(w) s aside; s is spread by its RMS.
  const double normal_fwhm = 2 * std::sqrt(2 * std::log(2.0));
  const double slope_sine = normal_fwhm * w * surface.rms_slope;
  advice.slope_lobe = seen_apart(slope_sine, {}, advice.seen_at);

  bool is_resolved = false;
  for (const std::size_t i : fundamentals(surface)) {
    const HeightPeriod& period = surface.periods[i];
    const double sine = lambda_um / period.period.um();
    const Angle spacing = seen_apart(
        sine, Angle::deg(period.azimuth.deg() - scene.request.phi_i.deg()), advice.seen_at);
    const bool apart = sine > lobe_width_sine(scene.surface, period.azimuth, lambda_um);
    is_resolved = is_resolved || (apart && spacing > scene.resolution);
    if (!advice.period || spacing > advice.spacing) {
      advice.period = i;
      advice.spacing = spacing;
    }
  }
  if (!advice.period) {
    advice.spacing = advice.lobe_width;
    is_resolved = advice.lobe_width > scene.resolution;
  }

  const double shortest_phase_rad = brdf::wavenumber_per_um(brdf::Length::um(scene.shortest_um())) *
                                    scene.largest_abs_w() * surface.peak_to_valley_um / 2;
  const auto decide = [&](OpticsVerdict verdict, OpticsReason reason) {
    advice.verdict = verdict;
    advice.reason = reason;
  };
  if (shortest_phase_rad <= scene.tolerance)
    decide(OpticsVerdict::mirror, OpticsReason::no_phase);
  else if (is_resolved)
    decide(OpticsVerdict::diffraction, OpticsReason::resolved);
  else if (advice.phase_depth_rad >= deep_phase_rad && slope_sine > lobe_sine)
    decide(OpticsVerdict::geometric, OpticsReason::deep);
  else
    decide(OpticsVerdict::diffraction, OpticsReason::shallow);
  return advice;
}

ScalarAdvice advise_scalar(const AdviceScene& scene, const SurfaceMeasures& surface) {
  ScalarAdvice advice;
  for (const std::size_t i : fundamentals(surface))
    for (const double lambda_um : {scene.shortest_um(), scene.longest_um()}) {
      const HeightPeriod& period = surface.periods[i];
      ScalarCase at{i,
                    lambda_um,
                    period.period.um() / lambda_um,
                    period.depth_um / lambda_um,
                    surface.peak_to_valley_um / lambda_um,
                    {},
                    {}};
      at.limit = brdf::scalar_limit(at.period_over_lambda, scene.request.theta_i);
      const auto [shallowest, deepest] =
          std::minmax(at.component_over_lambda, at.peak_to_valley_over_lambda);
      at.verdict = brdf::scalar_verdict(at.limit, shallowest, deepest);
      advice.verdict = std::max(advice.verdict, std::optional(at.verdict));  // empty is least
      advice.cases.push_back(at);
    }
  return advice;
}

}  // namespace evaluation
