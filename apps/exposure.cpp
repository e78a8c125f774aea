#include "apps/exposure.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "apps/colour_warnings.h"
#include "apps/options.h"

namespace apps {
namespace {

constexpr double metered_share = 0.99;

}  // namespace

void Exposure::add_to(CLI::App* app) {
  add_parsed(
      app, "--exposure", factor,
      [this](const std::string& option, const std::string& text) {
        asked_auto = text == "auto";
        return asked_auto ? std::optional<double>() : parse_exposure(option, text);
      },
      "factor of the light (default auto: one pixel in a hundred is brighter than white)",
      "NUMBER|auto");
}

double Exposure::of(std::span<const brdf::Xyz> colours) const {
  if (factor) return *factor;
  std::vector<double> luminances;
  for (const brdf::Xyz& colour : colours)
    if (colour.y > 0) luminances.push_back(colour.y);
  if (luminances.empty()) return 1;
  const auto place =
      luminances.begin() +
      static_cast<std::ptrdiff_t>(metered_share * static_cast<double>(luminances.size() - 1));
  std::nth_element(luminances.begin(), place, luminances.end());
  return 1 / *place;
}

std::string Exposure::description() const {
  return factor ? "given" : "auto: the 99th percentile of the luminance is white";
}

std::string Exposure::summary(double exposure) const {
  return fmt::format("exposure {:.6g} ({})", exposure, description());
}

}  // namespace apps
