#include "apps/exposure.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

#include "apps/colour_warnings.h"
#include "apps/options.h"

namespace apps {
namespace {

constexpr double bright_pixels = 0.01, bright_light = 0.5;

}  // namespace

void Exposure::add_to(CLI::App* app) {
  add_parsed(
      app, "--exposure", factor,
      [this](const std::string& option, const std::string& text) {
        asked_auto = text == "auto";
        return asked_auto ? std::optional<double>() : parse_exposure(option, text);
      },
      "factor of the light (default auto: brighter than white are 1 % of the pixels or half of the "
      "light)",
      "NUMBER|auto");
}

double Exposure::of(std::span<const brdf::Xyz> colours) const {
  if (factor) return *factor;
  std::vector<double> luminances;
  for (const brdf::Xyz& colour : colours)
    if (colour.y > 0) luminances.push_back(colour.y);
  if (luminances.empty()) return 1;
  std::sort(luminances.begin(), luminances.end(), std::greater());
  const double all = std::accumulate(luminances.begin(), luminances.end(), 0.0);
  const double pixels = bright_pixels * static_cast<double>(luminances.size());
  double white = luminances.front(), light = 0;
  for (std::size_t i = 0; i < luminances.size(); ++i) {
    white = luminances[i];
    light += luminances[i];
    if (static_cast<double>(i) >= pixels || light >= bright_light * all) break;
  }
  return 1 / white;
}

std::string Exposure::description() const {
  return factor ? "given" : "auto: brighter than white are 1 % of the pixels or half of the light";
}

std::string Exposure::summary(double exposure) const {
  return fmt::format("exposure {:.6g} ({})", exposure, description());
}

}  // namespace apps
