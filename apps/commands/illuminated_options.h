// The options that say what is illuminated: the coherence window, and what lies beyond the patch.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <utility>

#include "apps/options.h"
#include "brdf/surface.h"
#include "evaluation/methods.h"

namespace apps {

struct IlluminatedOptions {
  std::optional<brdf::Length> sigma;
  std::optional<brdf::SurfaceModel> model;
  std::optional<std::pair<int, int>> replicas;

  void add_to(CLI::App* app);
  /// Chooses the method's default model where none is given; refuses a model that the method has
  /// not, and copies without a model of them.
  void resolve(const evaluation::Method& method);
  /// Once resolved. Refers to the field. Without --sigma the window's is a quarter of the shorter
  /// side.
  brdf::Surface surface(const brdf::HeightField& field, brdf::Origin origin) const;
};

/// Model, and copies or window, for the sidecar.
evaluation::Json illuminated_json(const brdf::Surface& surface);

}  // namespace apps
