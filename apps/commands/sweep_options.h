// The options of `shedlight sweep`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "apps/commands/checkpoint_options.h"
#include "apps/commands/geometric_options.h"
#include "apps/commands/illuminated_options.h"
#include "apps/commands/like_options.h"
#include "apps/commands/optics_options.h"
#include "apps/commands/run_options.h"
#include "apps/commands/scene_options.h"
#include "apps/commands/selection_options.h"
#include "apps/commands/tables_options.h"
#include "apps/options.h"
#include "brdf/surface.h"
#include "evaluation/methods.h"
#include "evaluation/sweep.h"

namespace apps {

/// Whose conventions a sweep follows.
enum class Preset {
  physical,
  thesis,  ///< the sources' own evaluator
};

extern const Choices<evaluation::CsvLayout> layout_choices;
extern const Choices<Preset> preset_choices;

struct SweepOptions {
  HeightOptions heights;
  SceneOptions scene;
  LikeOptions like;
  std::optional<std::string> method;
  evaluation::MethodSettings settings;
  TablesOptions tables;
  std::optional<double> tolerance;
  IlluminatedOptions illuminated;
  OpticsOptions optics;
  GeometricOptions geometric;
  SelectionOptions selection;
  evaluation::CsvLayout layout = evaluation::CsvLayout::matrix;
  Preset preset = Preset::physical;
  std::optional<int> audit;
  RunOptions run;
  CheckpointOptions checkpoint;
  std::string output;
  bool json = false, explain = false;

  void add_to(CLI::App* sweep);
  /// Fills in what a row of a trade-off, a preset and the options together leave open, and refuses
  /// combinations that have no meaning.
  void resolve();
  /// Whether the method is one without diffraction.
  bool is_geometric() const { return GeometricOptions::has(*method); }

  evaluation::SweepRequest request() const;
  /// Refers to the field.
  brdf::Surface surface(const brdf::HeightField& field) const;

 private:
  void fill_in_like();
};

}  // namespace apps
