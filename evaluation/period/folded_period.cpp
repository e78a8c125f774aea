#include "evaluation/period/folded_period.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace evaluation {
namespace {

constexpr double same_variation = 0.02;
constexpr double repeats_itself = 1.5;
/// Steps across the mean distance of two samples on the folded period: first to find where it may
/// repeat itself, then there to find where it does, for gaps down to 1/64 of the mean.
constexpr int coarse_steps = 4, fine_steps = 64;
/// Of the single period's variation, above which a coarse step has nothing near it: a step between
/// two coarse ones misorders at most the samples at one edge, which it crosses twice.
constexpr double nothing_near = 3.5;
constexpr int most_steps = 20000;

double variation(const std::vector<double>& curve) {
  double sum = std::abs(curve.front() - curve.back());
  for (std::size_t i = 1; i < curve.size(); ++i) sum += std::abs(curve[i] - curve[i - 1]);
  return sum;
}

double folded_variation(const SurfaceWave& wave, double period_um) {
  std::vector<std::pair<double, double>> samples;
  for (Eigen::Index col = 0; col < wave.cols(); ++col) {
    const double t = wave.x_um(col) / period_um;
    samples.emplace_back(t - std::floor(t), wave.real(0, col));
  }
  std::sort(samples.begin(), samples.end());
  std::vector<double> curve;
  for (const auto& sample : samples) curve.push_back(sample.second);
  return variation(curve);
}

/// Mean variation over one period of the profile as it lies.
double single_variation(const SurfaceWave& wave, double period_um) {
  std::vector<double> profile;
  for (Eigen::Index col = 0; col < wave.cols(); ++col) profile.push_back(wave.real(0, col));
  return (variation(profile) - std::abs(profile.front() - profile.back())) * period_um /
         wave.width_um();
}

}  // namespace

std::optional<Interval> folded_period_um(const SurfaceWave& wave, double start_um, double reach) {
  if (!wave.is_even_along_y()) return std::nullopt;
  const double single = single_variation(wave, start_um);
  // Samples lie 1 / columns apart; the last moves by as many periods as there are, times the
  // change.
  const double feature = start_um / wave.width_um() / static_cast<double>(wave.cols());
  const double step = feature / fine_steps;
  constexpr int stride = fine_steps / coarse_steps;
  const int half =
      stride * static_cast<int>(std::min(reach / (step * stride) + 1, 0.5 * most_steps));
  const auto period_um = [&](int i) { return start_um * (1 + step * i); };

  std::map<int, double> variations;  // by step
  for (int i = -half; i <= half; i += stride) variations[i] = folded_variation(wave, period_um(i));
  std::vector<int> near;
  for (const auto& [i, coarse] : variations)
    if (coarse <= nothing_near * single) near.push_back(i);
  for (const int i : near)
    for (int j = i - stride + 1; j < i + stride; ++j)
      if (!variations.contains(j)) variations[j] = folded_variation(wave, period_um(j));

  double best = variations.begin()->second;
  for (const auto& [i, one] : variations) best = std::min(best, one);
  if (!(best <= repeats_itself * single)) return std::nullopt;
  const double range = wave.real.row(0).maxCoeff() - wave.real.row(0).minCoeff();
  std::optional<Interval> steps;
  for (const auto& [i, one] : variations) {
    if (!(one <= best + same_variation * range)) continue;
    if (!steps) steps = Interval{i - 1.0, 0};
    steps->hi = i + 1.0;
  }
  if (steps->lo <= -half || steps->hi >= half) return std::nullopt;  // no end in sight
  return Interval{start_um * (1 + step * steps->lo), start_um * (1 + step * steps->hi)};
}

}  // namespace evaluation
