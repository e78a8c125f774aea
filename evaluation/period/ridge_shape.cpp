#include "evaluation/period/ridge_shape.h"

#include <cmath>

namespace evaluation {
namespace {

/// The half maximum on one side of a candidate, in points from it; empty where S rises again first.
std::optional<double> half_width(const FrequencyResponse& over, std::size_t top, int step) {
  const double half = over.mean[top] / 2;
  double last = over.mean[top];
  std::size_t at = top;
  for (double away = 1;; ++away) {
    if ((step < 0 && at == 0) || (step > 0 && at + 1 == over.points())) return std::nullopt;
    at = step < 0 ? at - 1 : at + 1;
    const double now = over.mean[at];
    if (over.rows[at] == 0 || now > last) return std::nullopt;
    if (now <= half) return away - (half - now) / (last - now);
    last = now;
  }
}

}  // namespace

std::optional<double> width_per_um(const FrequencyResponse& over, std::size_t top) {
  const auto below = half_width(over, top, -1), above = half_width(over, top, 1);
  if (!below && !above) return std::nullopt;
  return (below.value_or(above.value_or(0)) + above.value_or(below.value_or(0))) * over.step_per_um;
}

double spread_per_um(const RidgeTrack& track) {
  double weights = 0, mean = 0, squares = 0;
  for (const auto& member : track.members)
    if (member) {
      weights += member->value;
      mean += member->value * (member->f_per_um - track.f_per_um);
    }
  mean /= weights;
  for (const auto& member : track.members)
    if (member) squares += member->value * std::pow(member->f_per_um - track.f_per_um - mean, 2);
  return std::sqrt(squares / weights);
}

std::vector<WavelengthSpan> spans(const RidgeTrack& track, const Axis& lambda_nm) {
  std::vector<WavelengthSpan> spans;
  bool inside = false;
  for (std::size_t i = 0; i < track.members.size(); ++i) {
    if (track.members[i]) {
      if (inside)
        spans.back().last_nm = lambda_nm[i];
      else
        spans.push_back({lambda_nm[i], lambda_nm[i]});
    }
    inside = track.members[i].has_value();
  }
  return spans;
}

}  // namespace evaluation
