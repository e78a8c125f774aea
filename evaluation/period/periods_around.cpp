#include "evaluation/period/periods_around.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "brdf/units.h"
#include "evaluation/axis.h"
#include "evaluation/dominant_periods.h"

namespace evaluation {
namespace {

using brdf::HeightSpectrum;

constexpr double least_depth = 0.01;
/// Steps along a ray, in bins.
constexpr double ray_step = 0.25;

/// Logarithm of the power between the bins, by parabolas through the nearest three each way: exact
/// for a line under the Gaussian window.
double log_power(const HeightSpectrum& spectrum, double col, double row) {
  const auto weights = [](double s) {
    return std::array{s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2};
  };
  const long l = std::lround(col), j = std::lround(row);
  const auto across = weights(col - static_cast<double>(l));
  const auto down = weights(row - static_cast<double>(j));
  double sum = 0;
  for (const long dj : {-1, 0, 1})
    for (const long dl : {-1, 0, 1})
      sum += down[static_cast<std::size_t>(dj + 1)] * across[static_cast<std::size_t>(dl + 1)] *
             std::log(spectrum.power(j + dj, l + dl));
  return sum;
}

/// The highest maximum inside a ray.
std::optional<AzimuthPeriod> on_ray(const HeightSpectrum& spectrum, double azimuth_deg,
                                    const PeriodRange& range) {
  const double azimuth = brdf::Angle::deg(azimuth_deg).rad();
  // Bins per cycle a micrometre along the ray.
  const double col = std::cos(azimuth) * spectrum.width_um();
  const double row = std::sin(azimuth) * spectrum.height_um();
  const double bins = std::hypot(col, row);
  const double half_cols = static_cast<double>(spectrum.cols()) / 2;
  const double half_rows = static_cast<double>(spectrum.rows()) / 2;
  const double last = bins * std::min(half_cols / std::max(std::abs(col), 1e-9 * half_cols),
                                      half_rows / std::max(std::abs(row), 1e-9 * half_rows));
  const double first = std::max(least_cycles, bins / range.longest.um());
  const double end = std::min(last, bins / range.shortest.um());
  std::vector<double> powers;
  for (double at = first; at <= end; at += ray_step)
    powers.push_back(log_power(spectrum, at * col / bins, at * row / bins));
  std::optional<std::size_t> top;
  for (std::size_t i = 1; i + 1 < powers.size(); ++i)
    if (powers[i] >= powers[i - 1] && powers[i] > powers[i + 1] &&
        (!top || powers[i] > powers[*top]))
      top = i;
  if (!top) return std::nullopt;
  const double before = powers[*top - 1], middle = powers[*top], after = powers[*top + 1];
  const double curvature = before - 2 * middle + after;
  const double offset =
      curvature < 0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0;
  const double place = first + ray_step * (static_cast<double>(*top) + offset);
  return AzimuthPeriod{azimuth_deg, brdf::Length::um(bins / place).nm(),
                       brdf::Length::um(2 * spectrum.amplitude_um(std::exp(middle))).nm()};
}

}  // namespace

std::vector<AzimuthPeriod> periods_around(const HeightSpectrum& spectrum, double step_deg,
                                          const PeriodRange& range) {
  std::vector<AzimuthPeriod> periods;
  double deepest = 0;
  const int steps = static_cast<int>(std::floor(180 / step_deg + 1e-9));
  for (int i = 1; i <= steps; ++i)
    if (const auto one = on_ray(spectrum, -90 + step_deg * i, range)) {
      periods.push_back(*one);
      deepest = std::max(deepest, one->depth_nm);
    }
  std::erase_if(periods,
                [&](const AzimuthPeriod& one) { return !(one.depth_nm >= least_depth * deepest); });
  return periods;
}

std::string to_csv(const std::vector<AzimuthPeriod>& periods) {
  std::string csv = "azimuth_deg,period_nm,depth_nm\n";
  for (const AzimuthPeriod& one : periods)
    csv += number_text(one.azimuth_deg) + "," + number_text(one.period_nm) + "," +
           number_text(one.depth_nm) + "\n";
  return csv;
}

}  // namespace evaluation
