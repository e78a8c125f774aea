#include "apps/commands/sweep_options.h"

#include <algorithm>

#include "apps/commands/method_options.h"
#include "apps/quantities.h"
#include "brdf/error.h"
#include "evaluation/sweep.h"

namespace apps {

using brdf::BinInterpolation;
using brdf::Length;
using brdf::Quantity;
using brdf::SurfaceModel;
using evaluation::CsvLayout;

const Choices<CsvLayout> layout_choices{{"matrix", CsvLayout::matrix},
                                        {"long", CsvLayout::long_table}};
const Choices<Preset> preset_choices{{"physical", Preset::physical}, {"thesis", Preset::thesis}};

namespace {

const Choices<BinInterpolation> interpolation_choices{{"nearest", BinInterpolation::nearest},
                                                      {"linear", BinInterpolation::linear},
                                                      {"sinc", BinInterpolation::sinc},
                                                      {"exact", BinInterpolation::exact}};

/// What the sources' evaluator does; what is given beside it stays as given.
void fill_in_thesis(SweepOptions& options) {
  if (!options.method) options.method = "taylor";
  if (!options.heights.level) options.heights.level = brdf::Level::mean;
  if (!options.settings.radius_sigma_f && *options.method == "taylor")
    options.settings.radius_sigma_f = 4;
  if (!options.illuminated.sigma)
    options.illuminated.sigma = Length::um(65.0 / 4);  // 4 sigma_s = 65 um
  if (!options.illuminated.model) options.illuminated.model = SurfaceModel::periodic;
  if (!options.optics.quantity) options.optics.quantity = Quantity::power;
}

void require_consistent(const SweepOptions& options, const evaluation::Method& method) {
  const auto refuse = [](const std::string& what) {
    throw brdf::Error(brdf::Errc::invalid_argument, what);
  };
  if (options.settings.terms && options.tolerance)
    refuse("--terms and --tolerance exclude each other: the tolerance chooses the terms");
  const auto require_knob = [&](const std::string& option, evaluation::Knob knob) {
    if (!method.takes(knob))
      refuse(option + " has no meaning for --method " + std::string(method.name) +
             "; it goes with --method " + evaluation::methods_with(knob));
  };
  if (options.tables.given()) require_knob("--tables", evaluation::Knob::power_spectra);
  if (options.settings.terms) require_knob("--terms", evaluation::Knob::terms);
  if (options.settings.radius_sigma_f)
    require_knob("--window-radius", evaluation::Knob::window_radius);
  if (options.settings.interpolation)
    require_knob("--interpolation", evaluation::Knob::interpolation);
  if (options.tolerance) require_tolerance("--tolerance", *options.tolerance);
}

/// Who gives the knobs of one of the sources' series means that series.
std::string method_meant(const SweepOptions& options) {
  if (options.settings.interpolation) return "pq";
  if (options.settings.radius_sigma_f) return "taylor";
  if (!options.settings.terms && !options.tables.given()) return "auto";
  return options.illuminated.replicas || options.illuminated.model == SurfaceModel::replicated
             ? "pq"
             : "taylor";
}

/// What is asked of a diffraction amplitude means nothing to a model without one.
void require_geometric(const SweepOptions& options) {
  require_not_given({{options.preset == Preset::thesis, "--preset thesis"},
                     {options.settings.terms.has_value(), "--terms"},
                     {options.settings.radius_sigma_f.has_value(), "--window-radius"},
                     {options.settings.interpolation.has_value(), "--interpolation"},
                     {options.tables.given(), "--tables"},
                     {options.tolerance.has_value(), "--tolerance"},
                     {options.illuminated.sigma.has_value(), "--sigma"},
                     {options.illuminated.model.has_value(), "--surface"},
                     {options.illuminated.replicas.has_value(), "--replicas"},
                     {options.audit.has_value(), "--audit"},
                     {options.explain, "--explain"},
                     {options.selection.orders_only, "--orders-only"},
                     {options.optics.shadowing.has_value(), "--shadowing"}},
                    "--method " + *options.method + ", which knows no diffraction");
  const auto quantity = options.optics.quantity;
  if (quantity == Quantity::power || quantity == Quantity::relative)
    throw brdf::Error(brdf::Errc::invalid_argument,
                      "--quantity " + name_in(quantity_choices, *quantity) +
                          " has no meaning for --method " + *options.method +
                          ", which knows no diffraction; it has brdf and radiance");
}

}  // namespace

void SweepOptions::fill_in_like() {
  require_not_given({{preset == Preset::thesis, "--preset thesis"},
                     {method.has_value(), "--method"},
                     {settings.terms.has_value(), "--terms"},
                     {settings.radius_sigma_f.has_value(), "--window-radius"},
                     {settings.interpolation.has_value(), "--interpolation"},
                     {tolerance.has_value(), "--tolerance"},
                     {illuminated.model.has_value(), "--surface"},
                     {illuminated.replicas.has_value(), "--replicas"}},
                    "--like, which brings method and knobs");
  like.read();
  const evaluation::Trial& trial = like.trial;
  method = trial.method;
  settings = trial.settings(run.threads);
  tolerance = trial.tolerance;
  illuminated.model = trial.model;
  if (trial.model == SurfaceModel::replicated)
    illuminated.replicas = {trial.replicas.x, trial.replicas.y};
  if (trial.cells == evaluation::Cells::orders) {
    if (!selection.period)
      throw brdf::Error(brdf::Errc::invalid_argument,
                        like.place() + " evaluates the orders only: give --period, too");
    selection.orders_only = true;
  }
}

void SweepOptions::resolve() {
  settings.threads = run.threads;
  if (json && output.empty() && !explain)
    throw brdf::Error(brdf::Errc::invalid_argument,
                      "--json needs -o: both would go to standard output");
  if (!like.file.empty()) fill_in_like();
  if (preset == Preset::thesis) fill_in_thesis(*this);
  if (!method) method = method_meant(*this);
  selection.require_consistent();
  tables.require_consistent(output);
  geometric.require_consistent(*method, optics);
  if (is_geometric()) {
    require_geometric(*this);
    if (!optics.quantity) optics.quantity = Quantity::brdf;
  } else {
    const evaluation::Method& chosen = evaluation::method_named(*method);
    illuminated.resolve(chosen);
    require_consistent(*this, chosen);
    if (!optics.quantity) optics.quantity = Quantity::relative;
  }
  optics.require_consistent();
}

evaluation::SweepRequest SweepOptions::request() const {
  evaluation::SweepRequest request = thinned(scene.request(), like.trial.lambda_step_nm);
  if (preset == Preset::thesis) request.depth = evaluation::DepthFrequency::unit_w;
  return request;
}

brdf::Surface SweepOptions::surface(const brdf::HeightField& field) const {
  return illuminated.surface(
      field, preset == Preset::thesis ? brdf::Origin::patch_corner : brdf::Origin::patch_centre);
}

namespace {

void add_method(CLI::App* sweep, SweepOptions& options) {
  sweep
      ->add_option(
          "--method", options.method,
          "how the amplitude is computed (default auto; taylor or pq where their options are "
          "given), or a model without diffraction")
      ->type_name(amplitude_methods() + "|" + GeometricOptions::names());
  add_parsed(sweep, "--tolerance", options.tolerance, parse_number,
             "largest error of the amplitude, flat patch's peak = 1 (default 1e-6)", "NUMBER");
  add_parsed(sweep, "--terms", options.settings.terms, count_between(1, 2000),
             "taylor, pq: number of terms, powers 0 to N-1", "N");
  add_parsed(sweep, "--window-radius", options.settings.radius_sigma_f, parse_number,
             "taylor: neighbouring bins kept, in sigma_f (default 6, or by --tolerance)", "NUMBER");
  add_choice(sweep, "--interpolation", options.settings.interpolation, interpolation_choices,
             "pq: between the bins of the tile's transform (default exact)");
  add_choice(sweep, "--preset", options.preset, preset_choices,
             "thesis: the sources' own evaluator, with its conventions");
  add_parsed(sweep, "--audit", options.audit, count_between(0, 1000000),
             "cells held against the direct sum after the run (default 32)", "N");
  sweep->add_flag("--explain", options.explain, "print the plan instead of running it");
}

void add_run(CLI::App* sweep, SweepOptions& options) {
  add_output(sweep, options.output,
             "CSV file, with its sidecar FILE.json (default: CSV to standard output)");
  add_choice(sweep, "--layout", options.layout, layout_choices, "of the CSV (default matrix)");
  options.run.add_to(sweep);
  options.checkpoint.add_to(sweep);
  sweep->add_flag("--json", options.json, "print the sidecar, or with --explain the plan, as JSON");
}

}  // namespace

void SweepOptions::add_to(CLI::App* sweep) {
  heights.add_to(sweep);
  tables.add_to(sweep);
  scene.add_to(sweep);
  illuminated.add_to(sweep);
  like.add_to(sweep);
  add_method(sweep, *this);
  optics.add_to(sweep);
  selection.add_to(sweep);
  geometric.add_to(sweep);
  add_run(sweep, *this);
}

}  // namespace apps
