#include "evaluation/period/window_lobe.h"

#include <algorithm>
#include <cmath>

#include "brdf/axis_lobe.h"
#include "brdf/lobe_width.h"

namespace evaluation {
namespace {

/// The table reaches beyond the cells that are taken, also where narrower lobes are tried.
constexpr double reach_half_widths = 6;

/// Samples at h / extent: the transform of an extent is band-limited to half of it, and a cubic
/// through four samples is off by at most (h / 2)^4 3 / 128 = 9e-9.
constexpr double samples_of_extent = 0.05;

double lit_um(const Illumination& lit, const brdf::SurfaceAxis& axis) {
  // A window without an end is over at the reach of its sums.
  if (lit.model == brdf::SurfaceModel::periodic)
    return 2 * brdf::detail::window_reach_sigma * lit.window.sigma_um();
  return axis.length_um() * axis.copies();
}

/// 2 g(edge) / Int g along the axis that the line follows most.
double edge(const Illumination& lit, const brdf::SurfaceAxis& axis, double cosine) {
  if (lit.model == brdf::SurfaceModel::periodic) return 0;
  const double length_um = lit_um(lit, axis);
  if (lit.model == brdf::SurfaceModel::replicated) return 2 / (length_um * cosine);
  double sum_um = 0;
  const double middle = static_cast<double>(axis.count - 1) / 2;
  for (Eigen::Index i = 0; i < axis.count; ++i)
    sum_um += axis.pixel_um * lit.window.spatial(axis.pixel_um * (static_cast<double>(i) - middle));
  return 2 * lit.window.spatial(length_um / 2) / (sum_um * cosine);
}

}  // namespace

double Illumination::lobe(double q_per_um) const {
  return axis_lobe(model, window, x, q_per_um * line.cos_azimuth) *
         axis_lobe(model, window, y, q_per_um * line.sin_azimuth);
}

WindowLobe::WindowLobe(const Illumination& lit)
    : illumination_(lit),
      half_width_per_um_(lobe_half_width_per_um(lit.model, lit.window, lit.x, lit.y, lit.line)) {
  if (!std::isfinite(half_width_per_um_))
    throw brdf::Error(brdf::Errc::not_attainable,
                      "the patch has a single pixel along the plane of incidence: its orders have "
                      "no lobe");
  const double cosine = std::abs(lit.line.cos_azimuth), sine = std::abs(lit.line.sin_azimuth);
  const bool along_x = cosine >= sine;
  const brdf::SurfaceAxis& axis = along_x ? lit.x : lit.y;
  const double share = std::max(cosine, sine);
  edge_per_um_ = edge(lit, axis, share);
  half_length_um_ = lit_um(lit, axis) * share / 2;
  const double extent_um = lit_um(lit, lit.x) * cosine + lit_um(lit, lit.y) * sine;
  step_per_um_ = samples_of_extent / extent_um;
  reach_per_um_ = reach_half_widths * half_width_per_um_;
  const auto count = static_cast<int>(std::ceil(reach_per_um_ / step_per_um_)) + 4;
  for (int i = -1; i < count; ++i) samples_.push_back(lit.lobe(i * step_per_um_));
}

double WindowLobe::operator()(double q_per_um) const {
  const double q = std::abs(q_per_um);
  if (!(q <= reach_per_um_)) return illumination_.lobe(q);
  const double at = q / step_per_um_;
  const auto i = static_cast<std::size_t>(at);
  const double f = at - static_cast<double>(i);
  const double* s = samples_.data() + i;  // at -1, 0, 1, 2 steps from i
  return -s[0] * f * (f - 1) * (f - 2) / 6 + s[1] * (f + 1) * (f - 1) * (f - 2) / 2 -
         s[2] * (f + 1) * f * (f - 2) / 2 + s[3] * (f + 1) * f * (f - 1) / 6;
}

double WindowLobe::illumination(double x_um) const {
  if (!(std::abs(x_um) <= half_length_um_)) return 0;
  if (illumination_.model == brdf::SurfaceModel::replicated) return 1;
  return illumination_.window.spatial(x_um);
}

double WindowLobe::core(double q_per_um) const {
  if (illumination_.model == brdf::SurfaceModel::replicated) return 0;
  return illumination_.window.spectral(q_per_um / (2 * brdf::pi));
}

}  // namespace evaluation
