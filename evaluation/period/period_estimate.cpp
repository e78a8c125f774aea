#include "evaluation/period/period_estimate.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

#include "brdf/error.h"
#include "evaluation/period/folded_period.h"

namespace evaluation {
namespace {

constexpr Eigen::Index strips = 4;
/// Narrower strips hold too few pixels to be compared.
constexpr Eigen::Index least_strip_pixels = 8;
/// How far a folded period is looked for: in half widths of the interval of the lines, and in
/// pixels that an edge may be off at either end of the patch.
constexpr double folded_half_widths = 1.5, folded_pixels = 2;

/// Relative width of an interval that only a band-limited profile gives: heights in single
/// precision, as files hold them, leave phases right to 1e-7 rad.
constexpr double band_limited = 1e-6;

double deviation(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  if (count < 2) return 0;
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / (count - 1));
}

double deviation_nm(const std::vector<LocalPeriod>& local) {
  std::vector<double> values;
  for (const LocalPeriod& one : local) values.push_back(one.period_nm);
  return deviation(values);
}

/// A strip along the grating vector, and the place of its middle.
struct Strip {
  SurfaceWave wave;
  double x_um, y_um;
};

/// Strips of equal width along the pixel axis nearer to the grating vector. The origin of each is
/// its own middle, which changes phases, not their slopes.
std::vector<Strip> strips_of(const SurfaceWave& wave, const Frequency& f) {
  const bool along_x = std::abs(f.x_per_um) >= std::abs(f.y_per_um);
  const Eigen::Index count = along_x ? wave.rows() : wave.cols();
  std::vector<Strip> parts;
  if (count < strips * least_strip_pixels || wave.is_even_along_y()) return parts;
  for (Eigen::Index i = 0; i < strips; ++i) {
    const Eigen::Index first = i * count / strips, size = (i + 1) * count / strips - first;
    const double middle = static_cast<double>(first) + static_cast<double>(size - 1) / 2 -
                          static_cast<double>(count - 1) / 2;
    if (along_x)
      parts.push_back({rows_of(wave, first, size), 0, middle * wave.dy_um});
    else
      parts.push_back({columns_of(wave, first, size), middle * wave.dx_um, 0});
  }
  return parts;
}

/// Slopes of the strips by themselves, and what their mean is uncertain by beyond what the lines
/// of each say.
struct StripSlopes {
  std::vector<LocalPeriod> periods;
  double excess = 0;  ///< standard deviation of the mean slope
};

StripSlopes strip_slopes(const SurfaceWave& wave, const Frequency& f) {
  StripSlopes found;
  std::vector<double> slopes;
  double own_variance = 0;
  for (const Strip& strip : strips_of(wave, f)) {
    const LinePhases phases = line_phases(strip.wave, f);
    if (phases.size() < least_lines) return {};
    const SlopePosterior posterior = slope_posterior(phases);
    const double half = posterior.interval.width() / 4;  // about one standard deviation
    slopes.push_back(posterior.median);
    own_variance += half * half;
    found.periods.push_back(
        {strip.x_um, strip.y_um, f.period().nm() / (1 + posterior.median / (2 * brdf::pi))});
  }
  if (slopes.empty()) return found;
  const auto count = static_cast<double>(slopes.size());
  const double spread = deviation(slopes);
  found.excess = std::sqrt(std::max(0.0, spread * spread - own_variance / count) / count);
  return found;
}

/// The interval widened by a standard error from `strips` values.
Interval widened(const SlopePosterior& slope, double excess) {
  const double half = excess * boost::math::quantile(
                                   boost::math::students_t(static_cast<double>(strips - 1)), 0.975);
  return {slope.median - std::hypot(slope.median - slope.interval.lo, half),
          slope.median + std::hypot(slope.interval.hi - slope.median, half)};
}

/// Whether no line lies farther from its place than a pixel, which is what sampling does to an
/// edge.
bool scatters_by_a_pixel_at_most(const LinePhases& phases, double slope, double pixel_periods) {
  double lo = 0, hi = 0;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const double rest =
        phases.phase_rad[i] - phases.phase_rad[0] - slope * (phases.line[i] - phases.line[0]);
    lo = std::min(lo, rest);
    hi = std::max(hi, rest);
  }
  return hi - lo <= 2 * (2 * brdf::pi * pixel_periods);
}

/// Lines of a surface that repeats itself exactly scatter through the sampling of its edges alone,
/// which is not random: the folded period then replaces theirs. Lines of a band-limited profile,
/// right to rounding, say more than folding.
void fold(const SurfaceWave& wave, const SlopePosterior& slope, PeriodEstimate& estimate) {
  const bool to_rounding = estimate.interval_nm.width() <= band_limited * estimate.period_nm;
  if (to_rounding || estimate.frequency.y_per_um != 0 || !wave.imaginary.isZero(0)) return;
  const double period_um = brdf::Length::nm(estimate.period_nm).um();
  if (!scatters_by_a_pixel_at_most(estimate.phases, slope.median, wave.dx_um / period_um)) return;
  const double reach =
      std::max(folded_half_widths * estimate.interval_nm.width() / 2 / estimate.period_nm,
               folded_pixels / static_cast<double>(wave.cols()));
  const auto folded = folded_period_um(wave, period_um, reach);
  if (!folded) return;
  const Interval nm{brdf::Length::um(folded->lo).nm(), brdf::Length::um(folded->hi).nm()};
  estimate.interval_nm = nm;
  estimate.period_nm = std::midpoint(nm.lo, nm.hi);
  estimate.frequency = estimate.frequency * (period_um / brdf::Length::nm(estimate.period_nm).um());
}

}  // namespace

std::vector<PatchWindow> window_positions(const SurfaceWave& wave, const Frequency& along,
                                          double share) {
  std::vector<PatchWindow> windows;
  for (const double place : {-0.25, -0.125, 0.0, 0.125, 0.25})
    windows.push_back({share, place * wave.width_um() * along.x_per_um / along.length_per_um(),
                       place * wave.height_um() * along.y_per_um / along.length_per_um()});
  return windows;
}

PeriodEstimate estimate_period(const SurfaceWave& wave, const Frequency& start) {
  const Frequency carrier = refined_line(wave, start).value_or(start);
  PeriodEstimate estimate{};
  estimate.phases = line_phases(wave, carrier);
  estimate.lines = estimate.phases.size();
  const SlopePosterior slope = slope_posterior(estimate.phases);
  const StripSlopes by_strip = strip_slopes(wave, carrier);
  const Interval slopes = widened(slope, by_strip.excess);

  const double carrier_nm = carrier.period().nm();
  const auto period_nm = [&](double per_line) {
    return carrier_nm / (1 + per_line / (2 * brdf::pi));
  };
  estimate.frequency = carrier * (1 + slope.median / (2 * brdf::pi));
  estimate.period_nm = period_nm(slope.median);
  estimate.interval_nm = {period_nm(slopes.hi), period_nm(slopes.lo)};
  estimate.drift_share = slope.accumulated_share;
  estimate.bow_share = slope.bowed_share;
  estimate.by_patch = by_strip.periods;
  for (const PatchWindow& window : window_positions(wave, carrier, PatchWindow{}.share))
    if (const auto local = refined_line(wave, carrier, window))
      estimate.by_window.push_back({window.centre_x_um, window.centre_y_um, local->period().nm()});
  estimate.parts = {carrier_nm * slope.independent_std / (2 * brdf::pi),
                    carrier_nm * slope.accumulated_std / (2 * brdf::pi),
                    deviation_nm(estimate.by_patch), deviation_nm(estimate.by_window)};
  fold(wave, slope, estimate);
  return estimate;
}

}  // namespace evaluation
