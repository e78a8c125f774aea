#include "evaluation/advice/scene.h"

#include <algorithm>
#include <cmath>

#include "brdf/levelling.h"
#include "brdf/lobe_width.h"
#include "brdf/roughness.h"
#include "brdf/slope.h"

namespace evaluation {
namespace {

double half_width_per_um(const brdf::Surface& surface, brdf::Angle azimuth) {
  const brdf::Direction along = brdf::direction(brdf::Angle::deg(45), azimuth);
  const double length = std::hypot(along.x(), along.y());
  return brdf::lobe_half_width_per_um(surface, {along.x() / length, along.y() / length});
}

}  // namespace

brdf::Angle AdviceScene::nearest_to_mirror() const {
  return brdf::Angle::deg(std::clamp(0.0 - request.theta_i.deg(), request.theta_r_deg.front(),
                                     request.theta_r_deg.back()));
}

brdf::Angle AdviceScene::nearest_to_normal() const {
  return brdf::Angle::deg(std::clamp(0.0, request.theta_r_deg.front(), request.theta_r_deg.back()));
}

double AdviceScene::largest_abs_u() const {
  const double light = std::sin(request.theta_i.rad());
  const auto u = [&](double deg) {
    return std::abs(light + std::sin(brdf::Angle::deg(deg).rad()));
  };
  return std::max(u(request.theta_r_deg.front()), u(request.theta_r_deg.back()));
}

double AdviceScene::largest_abs_w() const {
  return std::cos(request.theta_i.rad()) + std::cos(nearest_to_normal().rad());
}

double AdviceScene::mirror_abs_w() const {
  return std::cos(request.theta_i.rad()) + std::cos(nearest_to_mirror().rad());
}

void require_valid(const AdviceScene& scene) {
  require_valid(scene.request);
  const auto refuse = [](const std::string& what) {
    throw brdf::Error(brdf::Errc::invalid_argument, what);
  };
  if (!(scene.tolerance > 0 && scene.tolerance < 1))
    refuse("tolerance " + brdf::text(scene.tolerance) + " must lie between 0 and 1");
  if (!(scene.resolution.deg() > 0 && scene.resolution.deg() < 90))
    refuse("angular resolution " + brdf::text(scene.resolution.deg()) +
           " deg must lie between 0 and 90 deg");
}

SurfaceMeasures measured(const brdf::HeightField& heights) {
  brdf::HeightField levelled = brdf::levelled(heights, brdf::Level::plane);
  const brdf::HeightSpectrum spectrum(levelled);
  const double peak_to_valley_um = 2 * levelled.half_range_um();
  const double rms_um = std::sqrt(levelled.heights_um().square().mean());
  const double slope = brdf::rms_slope(levelled);
  // What levelling leaves of a flat patch is rounding.
  const double rounding_um = 1e-12 * std::max(1.0, std::abs(heights.max_um()));
  if (!(peak_to_valley_um > rounding_um))
    return {std::move(levelled), peak_to_valley_um, rms_um, slope, std::nullopt, {}};
  return {std::move(levelled),
          peak_to_valley_um,
          rms_um,
          slope,
          brdf::correlation_length_um(spectrum),
          dominant_periods(spectrum)};
}

double lobe_width_sine(const brdf::Surface& surface, brdf::Angle azimuth, double lambda_um) {
  return lambda_um * half_width_per_um(surface, azimuth) / brdf::pi;
}

double coherence_length_um(const brdf::Surface& surface, brdf::Angle azimuth) {
  return brdf::pi / half_width_per_um(surface, azimuth);
}

}  // namespace evaluation
