#include "apps/exposure.h"

#include <fmt/format.h>

#include "apps/colour_warnings.h"
#include "apps/options.h"
#include "evaluation/exposure.h"

namespace apps {
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
  return factor ? *factor : evaluation::automatic_exposure(colours);
}

std::string Exposure::description() const {
  return factor ? "given" : "auto: brighter than white are 1 % of the pixels or half of the light";
}

std::string Exposure::summary(double exposure) const {
  return fmt::format("exposure {:.6g} ({})", exposure, description());
}

}  // namespace apps
