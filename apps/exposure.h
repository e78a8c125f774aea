// How bright a picture is made.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>

#include "brdf/colour_matching.h"

namespace apps {

/// A factor of the light, given or chosen by the picture.
struct Exposure {
  std::optional<double> factor;
  bool asked_auto = false;  ///< by name

  void add_to(CLI::App* app);
  /// The factor given, or the automatic one (evaluation/exposure.h).
  double of(std::span<const brdf::Xyz> colours) const;
  std::string description() const;
  /// "exposure 7 (auto: ...)"
  std::string summary(double exposure) const;
};

}  // namespace apps
