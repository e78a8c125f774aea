// shedlight sweep: the response over wavelength and viewing angle.
#include <fmt/format.h>

#include <memory>

#include "apps/commands/commands.h"
#include "apps/commands/sweep_options.h"
#include "apps/memory_limit.h"
#include "evaluation/audit.h"
#include "evaluation/diffraction.h"
#include "evaluation/writers/npy_writer.h"

namespace apps {
namespace {

using evaluation::Json;

/// 1e-6 of the flat patch's peak: far below what a scan's own heights can bear.
constexpr double default_tolerance = 1e-6;
/// With the terms given there is no tolerance; a bound above this is worth a warning.
constexpr double tolerable_bound = 1e-2;
constexpr int default_audit = 32;

double tolerance(const SweepOptions& options) {
  return options.tolerance.value_or(default_tolerance);
}

void require_memory(std::size_t needed, const SweepOptions& options) {
  apps::require_memory({options.heights.file, "the sweep", needed,
                        "a smaller range, a larger tolerance or --reduce needs less"},
                       options.run.memory_limit);
}

/// Says where the error stated, or the error found, is above what was asked for.
void check_error(const char* what, double error, const SweepOptions& options) {
  const double limit = options.settings.terms ? tolerable_bound : tolerance(options);
  // A window radius given by hand leaves out what it leaves out: no tolerance was asked for.
  const bool radius_rules = options.settings.radius_sigma_f && !options.tolerance;
  if (error <= (radius_rules ? tolerable_bound : limit)) return;
  report_unattained(
      fmt::format("{}: {} of the amplitude is {:.3g}, above {:.3g}{}", options.heights.file, what,
                  error, limit, options.settings.terms ? "; more --terms lower it" : ""),
      options.run.attainability());
}

/// What every method has in common.
Json common_json(const SweepOptions& options, const evaluation::SweepRequest& request,
                 const brdf::HeightField& field) {
  Json p = options.heights.parameters(field);
  p["preset"] = name_in(preset_choices, options.preset);
  p.update(apps::scene_json(request));
  if (!options.like.file.empty()) p["like"] = options.like.parameters();
  p["method"] = *options.method;
  p["layout"] = name_in(layout_choices, options.layout);
  p["strict"] = options.run.strict;
  return p;
}

Json diffraction_json(const SweepOptions& options, const brdf::Surface& surface,
                      const brdf::PlanReport& report) {
  Json p = illuminated_json(surface);
  p["window_centre"] = surface.origin == brdf::Origin::patch_centre ? "centre" : "corner";
  if (options.settings.terms)
    p["terms"] = *options.settings.terms;
  else
    p["tolerance"] = tolerance(options);
  if (report.radius_sigma_f > 0) p["window_radius_sigma_f"] = report.radius_sigma_f;
  if (evaluation::method_named(*options.method).takes(evaluation::Knob::interpolation))
    p["interpolation"] =
        evaluation::name_of(options.settings.interpolation.value_or(brdf::BinInterpolation::exact));
  if (options.tables.given()) p["tables"] = options.tables.parameters();
  p.update(options.optics.parameters());
  return p;
}

/// "path  in plane", one part of a plan a line, nested ones by their names in a row.
std::string for_people(const Json& plan, const std::string& prefix = "") {
  std::string text;
  for (const auto& [key, value] : plan.items()) {
    const std::string name = prefix.empty() ? key : prefix + " " + key;
    if (value.is_structured())
      text += for_people(value, name);
    else
      text += fmt::format("{:<34}{}\n", name,
                          value.is_string()         ? value.get<std::string>()
                          : value.is_number_float() ? fmt::format("{:.3g}", value.get<double>())
                                                    : value.dump());
  }
  return text;
}

/// After the run: a sample of cells against the direct sum. Nothing to learn from auditing the
/// direct sum by itself.
Json audited(const evaluation::SweepRequest& request, const evaluation::CellSelection& selected,
             const brdf::Surface& surface, const evaluation::Amplitude& amplitude,
             const evaluation::RunLimits& limits, const SweepOptions& options) {
  const int wanted = *options.method == "direct" ? 0 : options.audit.value_or(default_audit);
  const std::size_t cells = std::min(static_cast<std::size_t>(wanted), selected.size());
  if (cells == 0) return {{"cells", 0}};
  const evaluation::Audit found = audit(request, selected, surface, amplitude, cells, limits);
  // What the bound owned up to has been said before the run.
  if (!(found.worst_error <= amplitude.report().error_bound))
    check_error("the error found by the audit", found.worst_error, options);
  return {{"cells", found.cells},
          {"worst_error", found.worst_error},
          {"worst_lambda_nm", found.lambda_nm},
          {"worst_theta_r_deg", found.theta_r_deg}};
}

/// A response and its sidecar.
struct Computed {
  evaluation::ResponseMatrix response;
  Json sidecar;
  std::shared_ptr<evaluation::Checkpoint> checkpoint;
};

/// The sweep itself, with what goes wrong in it said of the file. sidecar: with all parameters.
Computed swept(const SweepOptions& options, const evaluation::SweepRequest& request,
               const evaluation::Reflectance& reflectance, const evaluation::CellSelection& cells,
               evaluation::RunLimits limits, Json sidecar) {
  const auto checkpoint = options.checkpoint.open(sidecar);
  limits.chunks = checkpoint.get();
  auto response = brdf::at_place(options.heights.file, [&] {
    return sweep(request, reflectance, cells, limits, progress_line("sweep"));
  });
  return {std::move(response), std::move(sidecar), checkpoint};
}

/// The matrix, its CSV at about 24 bytes a number, and where each selected cell lies.
std::size_t response_bytes(const SweepOptions& options, const evaluation::SweepRequest& request) {
  return request.cells() *
         (sizeof(double) + 24 + (options.selection.orders_only ? sizeof(std::size_t) : 0));
}

Computed diffraction(const SweepOptions& options, const evaluation::SweepRequest& request,
                     const brdf::Surface& surface, const evaluation::RunLimits& limits,
                     Json sidecar) {
  const evaluation::Method& method = evaluation::method_named(*options.method);
  const brdf::HeightField& field = *surface.heights;
  const brdf::QueryBounds bounds = bounds_of(request, tolerance(options));
  check_sampling(request, field, options.heights.file, options.run.attainability());
  require_memory(method.bytes(surface, bounds, options.settings) +
                     response_bytes(options, request) +
                     static_cast<std::size_t>(field.heights_um().size()) * sizeof(double),
                 options);
  const auto amplitude = method.plan(surface, bounds, options.settings);
  const brdf::PlanReport report = amplitude->report();
  check_error("the error bound", report.error_bound, options);

  const evaluation::CellSelection cells = options.selection.cells(request, surface);
  const evaluation::Diffraction reflectance(*amplitude, options.optics.optics(surface),
                                            request.depth);
  Json& parameters = sidecar["parameters"];
  parameters.update(diffraction_json(options, surface, report));
  if (options.selection.orders_only)
    parameters["orders_only"] = options.selection.parameters(request, surface, cells);
  Computed computed = swept(options, request, reflectance, cells, limits, std::move(sidecar));
  computed.sidecar["error"] = {
      {"amplitude_bound", report.error_bound},
      {"audit", audited(request, cells, surface, *amplitude, limits, options)},
      {"input_phase_error_rad", report.input_phase_error_rad},
      {"terms", report.terms},
      {"relative_to", "the peak of a flat patch"}};
  return computed;
}

Computed geometric_optics(const SweepOptions& options, const evaluation::SweepRequest& request,
                          const brdf::HeightField& field, const evaluation::RunLimits& limits,
                          Json sidecar) {
  require_memory(response_bytes(options, request), options);
  const auto model = options.geometric.model(*options.method, options.optics, field);
  const evaluation::GeometricOptics reflectance(model, *options.optics.quantity);
  sidecar["parameters"].update(model_json(model));
  sidecar["parameters"]["quantity"] = name_in(quantity_choices, *options.optics.quantity);
  Computed computed = swept(options, request, reflectance, evaluation::CellSelection::all(request),
                            limits, std::move(sidecar));
  computed.sidecar["error"] = {{"of_the_model", "rounding alone"}, {"diffraction", "not modelled"}};
  return computed;
}

void explain(const SweepOptions& options, const evaluation::SweepRequest& request,
             const brdf::Surface& surface) {
  const brdf::QueryBounds bounds = bounds_of(request, tolerance(options));
  const Json plan =
      evaluation::method_named(*options.method).explain(surface, bounds, options.settings);
  print(options.json ? evaluation::json_text(plan) : for_people(plan));
}

void run(SweepOptions options) {
  const evaluation::RunLimits limits = options.run.limits();
  options.resolve();
  evaluation::SweepRequest request = options.request();
  std::optional<evaluation::OutputWithSidecar> output;
  std::optional<evaluation::NpyAxes> axes;
  if (!options.output.empty() && !options.explain) {
    require_other_file(options.output, options.heights.file);
    output.emplace(options.output);
    if (evaluation::has_extension(options.output, ".npy"))
      axes.emplace(options.output, std::vector<std::string>{"lambda_nm", "theta_r_deg"});
  }
  const evaluation::HeightFile input = options.heights.read();
  options.scene.turn(input.field, options.heights.file);
  request = options.request();
  options.settings.power_spectra = options.tables.read(options.heights, input);
  if (options.explain) return explain(options, request, options.surface(input.field));
  Json head = sidecar_head("sweep", options.heights.file, input.sha256);
  head["parameters"] = common_json(options, request, input.field);
  Computed computed =
      options.is_geometric()
          ? geometric_optics(options, request, input.field, limits, std::move(head))
          : diffraction(options, request, options.surface(input.field), limits, std::move(head));
  const evaluation::ResponseMatrix& response = computed.response;
  const std::string bytes =
      axes ? evaluation::to_npy(response.values) : to_csv(response, options.layout);
  if (axes)
    computed.sidecar["axes"] =
        axes->write({response.lambda_nm.values, response.theta_r_deg.values});
  Json sidecar;
  if (output)
    sidecar = output->commit(bytes, std::move(computed.sidecar),
                             axes ? axes->files() : std::vector<evaluation::OutputFile*>{});
  else
    print(bytes);
  remove(computed.checkpoint);
  if (output && options.json) print(evaluation::json_text(sidecar));
}

}  // namespace

void add_sweep(CLI::App& app) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* sweep =
      app.add_subcommand("sweep", "Response over wavelength and viewing angle, as a CSV matrix");
  sweep->footer(
      "Example:\n"
      "  shedlight sweep scan.png --width 65um --height-range 818.69nm --theta-i 75deg \\\n"
      "    --phi-i 90deg --theta-r -50:-25:0.05deg --lambda 380:780:1nm -o R.csv");
  options->add_to(sweep);
  sweep->callback([options] { run(*options); });
}

}  // namespace apps
