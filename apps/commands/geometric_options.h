// The options of `shedlight sweep` for the models without diffraction.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "apps/commands/optics_options.h"
#include "evaluation/geometric_optics.h"

namespace apps {

struct GeometricOptions {
  std::optional<brdf::Distribution> distribution;
  std::optional<double> roughness, tail, albedo;
  std::optional<brdf::Masking> masking;
  std::optional<std::string> material;

  void add_to(CLI::App* sweep);
  /// "microfacet, lambert"
  static std::string names();
  static bool has(const std::string& method);
  /// Refuses what the model does not take.
  void require_consistent(const std::string& method, const OpticsOptions& optics) const;
  /// The model; a roughness that is not given is the root mean square slope of the heights.
  evaluation::GeometricOptics::Model model(const std::string& method, const OpticsOptions& optics,
                                           const brdf::HeightField& field) const;
};

/// For the sidecar.
evaluation::Json model_json(const evaluation::GeometricOptics::Model& model);

}  // namespace apps
