#include "evaluation/exposure.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

#include "brdf/colour.h"
#include "brdf/colour_difference.h"

namespace evaluation {
namespace {

constexpr double bright_colours = 0.01, bright_light = 0.5;

}  // namespace

double automatic_exposure(std::span<const brdf::Xyz> colours) {
  std::vector<double> luminances;
  for (const brdf::Xyz& colour : colours)
    if (colour.y > 0) luminances.push_back(colour.y);
  if (luminances.empty()) return 1;
  std::sort(luminances.begin(), luminances.end(), std::greater());
  const double all = std::accumulate(luminances.begin(), luminances.end(), 0.0);
  const double count = bright_colours * static_cast<double>(luminances.size());
  double white = luminances.front(), light = 0;
  for (std::size_t i = 0; i < luminances.size(); ++i) {
    white = luminances[i];
    light += luminances[i];
    if (static_cast<double>(i) >= count || light >= bright_light * all) break;
  }
  return 1 / white;
}

double shown_difference(const brdf::Xyz& a, const brdf::Xyz& b, double exposure) {
  const auto lab_of = [exposure](const brdf::Xyz& colour) {
    return brdf::lab(
        xyz_of_linear_srgb(clipped_to_gamut(brdf::linear_srgb(exposure * colour)).rgb));
  };
  return ciede2000(lab_of(a), lab_of(b));
}

}  // namespace evaluation
