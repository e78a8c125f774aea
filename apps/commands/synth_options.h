// The options of `shedlight synth` that say what is made; its grid and its file are in synth.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "brdf/synthetic_surface.h"
#include "evaluation/writers/output_file.h"

namespace apps {

/// What stands first on the command line.
enum class Shape { blazed, sinusoid, lamellar, triangle, fingers, flat };

struct SynthOptions {
  Shape shape = Shape::flat;
  std::optional<brdf::Length> period, height;
  std::optional<double> duty;
  std::optional<brdf::Facing> facing;
  std::optional<brdf::Angle> direction;
  std::optional<brdf::Length> crossed_period;
  std::optional<brdf::Angle> crossed_angle;
  std::optional<brdf::Length> jitter;
  std::optional<brdf::DisorderKind> jitter_kind;
  std::optional<brdf::Length> second_period;
  std::optional<brdf::Angle> second_direction;
  std::optional<double> second_share;
  std::optional<brdf::Length> noise;
  std::optional<int> seed;
  std::optional<brdf::Edges> edges;

  void add_to(CLI::App* synth);
  std::string shape_name() const;
  /// What is made. Each shape takes the options that mean something for it, and no others.
  brdf::SyntheticSurface surface() const;
  /// The same for the sidecar.
  evaluation::Json parameters() const;

 private:
  void add_lines_to(CLI::App* synth);
  void add_disorder_to(CLI::App* synth);
  void require_consistent() const;
  bool is_random() const { return jitter || noise; }
};

}  // namespace apps
