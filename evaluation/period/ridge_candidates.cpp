#include "evaluation/period/ridge_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evaluation {
namespace {

/// A lobe 10 times as wide as the window's falls to 0.78 within this distance, a lobe of the window
/// to 1e-11.
constexpr double fall_radius_sigma_f = 5;
constexpr double least_fall = 1.25;
/// Two equal lobes closer than 1.41 have one maximum: one seen closer is noise on the other.
constexpr double least_distance_sigma_f = 1;

bool is_usable(const FrequencyResponse& over, std::size_t point) {
  return over.rows[point] > 0 && !over.in_mirror(point);
}

/// Mean power of an exponential distribution from the median over an octave to both sides; ridges
/// do not move it as long as they fill less than half of the octaves.
double background(const FrequencyResponse& over, std::size_t top) {
  const double f = over.frequency(static_cast<double>(top));
  std::vector<double> around;
  for (std::size_t j = 0; j < over.points(); ++j) {
    const double ratio = over.frequency(static_cast<double>(j)) / f;
    if (ratio >= 0.5 && ratio <= 2 && is_usable(over, j)) around.push_back(over.mean[j]);
  }
  const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
  std::nth_element(around.begin(), middle, around.end());
  return *middle / std::log(2.0);
}

bool falls_on_both_sides(const FrequencyResponse& over, std::size_t top) {
  const double radius = fall_radius_sigma_f * over.sigma_f_per_um / over.step_per_um;
  const auto lowest = [&](int step) {
    double low = over.mean[top];
    for (double away = 1; away <= radius; ++away) {
      const double at = static_cast<double>(top) + step * away;
      if (!(at >= 0 && at < static_cast<double>(over.points()))) break;
      const auto point = static_cast<std::size_t>(at);
      if (!is_usable(over, point)) break;
      low = std::min(low, over.mean[point]);
    }
    return low;
  };
  return least_fall * std::max(lowest(-1), lowest(1)) <= over.mean[top];
}

/// Whether a stronger maximum is too near, or has sidelobes of this power here.
bool belongs_to(const FrequencyResponse& over, std::size_t top, std::size_t stronger) {
  const double apart = std::abs(static_cast<double>(top) - static_cast<double>(stronger)) *
                       over.step_per_um / over.sigma_f_per_um;
  const double amplitude = over.sidelobe / apart;
  return apart < least_distance_sigma_f ||
         over.mean[top] <= amplitude * amplitude * over.mean[stronger];
}

}  // namespace

std::vector<RidgeCandidate> ridge_candidates(const FrequencyResponse& over, double least_contrast) {
  std::vector<std::size_t> maxima;  // the mirror lobe's too
  for (std::size_t j = 1; j + 1 < over.points(); ++j)
    if (over.rows[j - 1] > 0 && over.rows[j] > 0 && over.rows[j + 1] > 0 &&
        over.mean[j] > over.mean[j - 1] && over.mean[j] >= over.mean[j + 1])
      maxima.push_back(j);
  std::ranges::stable_sort(maxima, std::ranges::greater{},
                           [&](std::size_t j) { return over.mean[j]; });
  std::vector<RidgeCandidate> candidates;
  for (std::size_t i = 0; i < maxima.size(); ++i) {
    const std::size_t top = maxima[i];
    if (!is_usable(over, top) || !falls_on_both_sides(over, top)) continue;
    if (std::any_of(maxima.begin(), maxima.begin() + static_cast<std::ptrdiff_t>(i),
                    [&](std::size_t stronger) { return belongs_to(over, top, stronger); }))
      continue;
    const double around = background(over, top);
    const double contrast =
        around > 0 ? over.mean[top] / around : std::numeric_limits<double>::infinity();
    if (contrast >= least_contrast) candidates.push_back({top, contrast});
  }
  std::ranges::sort(candidates, {}, &RidgeCandidate::point);
  return candidates;
}

}  // namespace evaluation
