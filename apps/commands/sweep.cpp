// shedlight sweep: the response over wavelength and viewing angle.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <thread>

#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/options.h"
#include "apps/quantities.h"
#include "evaluation/sweep.h"

namespace apps {
namespace {

using brdf::Angle;
using brdf::Length;
using brdf::Quantity;
using brdf::SurfaceModel;
using evaluation::CsvLayout;
using evaluation::Json;

enum class Preset { physical, thesis };

const Choices<Quantity> quantity_choices{
    {"power", Quantity::power}, {"relative", Quantity::relative}, {"brdf", Quantity::brdf}};
const Choices<CsvLayout> layout_choices{{"matrix", CsvLayout::matrix},
                                        {"long", CsvLayout::long_table}};
const Choices<SurfaceModel> surface_choices{{"isolated", SurfaceModel::isolated},
                                            {"periodic", SurfaceModel::periodic}};
const Choices<Preset> preset_choices{{"physical", Preset::physical}, {"thesis", Preset::thesis}};

/// 1e-6 of the flat patch's peak: far below what a scan's own heights can bear.
constexpr double default_tolerance = 1e-6;
/// Without a tolerance asked for, a bound above this is worth a warning.
constexpr double tolerable_bound = 1e-2;

struct SweepOptions {
  HeightOptions heights;
  std::optional<Angle> theta_i;
  Angle phi_i;
  std::optional<Angle> phi_r;
  std::optional<evaluation::Axis> theta_r_deg, lambda_nm;
  std::string method = "taylor";
  evaluation::MethodSettings settings;
  std::optional<double> tolerance;
  std::optional<Length> sigma;
  std::optional<SurfaceModel> model;
  std::optional<Quantity> quantity;
  CsvLayout layout = CsvLayout::matrix;
  Preset preset = Preset::physical;
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::optional<std::size_t> memory_limit;
  std::optional<std::chrono::duration<double>> time_limit;
  std::string output;
  bool strict = false, json = false;

  Attainability attainability() const {
    return strict ? Attainability::refuse : Attainability::warn;
  }
};

/// `--preset thesis`: the sources' own evaluator; what is given beside it stays as given.
void apply_preset(SweepOptions& options) {
  if (options.preset != Preset::thesis) return;
  if (!options.heights.level) options.heights.level = brdf::Level::mean;
  if (!options.settings.radius_sigma_f) options.settings.radius_sigma_f = 4;
  if (!options.sigma) options.sigma = Length::um(65.0 / 4);  // 4 sigma_s = 65 um
  if (!options.model) options.model = SurfaceModel::periodic;
  if (!options.quantity) options.quantity = Quantity::power;
}

void require_consistent(const SweepOptions& options, const evaluation::Method& method) {
  const auto refuse = [](const std::string& what) {
    throw brdf::Error(brdf::Errc::invalid_argument, what);
  };
  if (options.settings.terms && options.tolerance)
    refuse("--terms and --tolerance exclude each other: the tolerance chooses the terms");
  if (!method.is_series && options.settings.terms)
    refuse("--terms has no meaning for --method " + std::string(method.name));
  if (!method.is_series && options.settings.radius_sigma_f && options.preset != Preset::thesis)
    refuse("--window-radius has no meaning for --method " + std::string(method.name));
  if (options.tolerance && !(*options.tolerance > 0 && *options.tolerance < 1))
    refuse("--tolerance " + brdf::text(*options.tolerance) + ": must lie between 0 and 1");
  if (options.json && options.output.empty())
    refuse("--json needs -o: both would go to standard output");
}

/// Physical memory, or all there is to address where the system does not say.
std::size_t physical_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
  if (pages <= 0 || page <= 0) return std::size_t(-1);
  return static_cast<std::size_t>(pages) * static_cast<std::size_t>(page);
}

void require_memory(std::size_t needed, const SweepOptions& options) {
  const std::size_t limit = options.memory_limit.value_or(physical_memory() / 10 * 8);
  if (needed > limit)
    throw brdf::Error(
        brdf::Errc::over_limit,
        fmt::format("{}: the sweep needs about {:.3g} MB, the limit is {:.3g} MB "
                    "(--memory-limit); fewer terms, a smaller range or --reduce needs less",
                    options.heights.file, static_cast<double>(needed) / 1e6,
                    static_cast<double>(limit) / 1e6));
}

void check_sampling(const evaluation::SweepRequest& request, const brdf::HeightField& field,
                    const SweepOptions& options) {
  const auto excess = evaluation::nyquist_excess(request, field);
  if (!excess) return;
  const std::string safe =
      excess->safe_deg
          ? fmt::format("safe are {} to {} deg", excess->safe_deg->first, excess->safe_deg->second)
          : "no angle asked for is safe";
  report_unattained(
      fmt::format("{}: at {} nm the viewing angles go past the Nyquist limit of its {} x {} um "
                  "pixels: {}",
                  options.heights.file, excess->lambda_nm, field.dx_um(), field.dy_um(), safe),
      options.attainability());
}

void check_bound(const brdf::PlanReport& report, const SweepOptions& options) {
  const double limit = options.tolerance.value_or(tolerable_bound);
  if (report.error_bound <= limit) return;
  report_unattained(fmt::format("{}: the error bound of the amplitude is {:.3g}, above {:.3g}{}",
                                options.heights.file, report.error_bound, limit,
                                options.settings.terms ? "; more --terms lower it" : ""),
                    options.attainability());
}

Json parameters_json(const SweepOptions& options, const evaluation::SweepRequest& request,
                     const brdf::Surface& surface, const brdf::PlanReport& report) {
  const brdf::HeightField& field = *surface.heights;
  Json p{{"columns", field.cols()},
         {"rows", field.rows()},
         {"pixel_um", {field.dx_um(), field.dy_um()}},
         {"reduce", options.heights.reduction},
         {"level", name_in(level_choices, options.heights.level.value_or(brdf::Level::none))}};
  if (options.heights.scale.height_range)
    p["height_range_nm"] = options.heights.scale.height_range->nm();
  p["preset"] = name_in(preset_choices, options.preset);
  p["theta_i_deg"] = request.theta_i.deg();
  p["phi_i_deg"] = request.phi_i.deg();
  p["phi_r_deg"] = request.phi_r.deg();
  p["theta_r_deg"] = axis_json(request.theta_r_deg);
  p["lambda_nm"] = axis_json(request.lambda_nm);
  p["method"] = options.method;
  p["surface"] = evaluation::name_of(surface.model);
  p["sigma_um"] = surface.window.sigma_um();
  p["window_centre"] = surface.origin == brdf::Origin::patch_centre ? "centre" : "corner";
  if (options.settings.terms)
    p["terms"] = *options.settings.terms;
  else
    p["tolerance"] = options.tolerance.value_or(default_tolerance);
  if (report.radius_sigma_f > 0) p["window_radius_sigma_f"] = report.radius_sigma_f;
  p["quantity"] = name_in(quantity_choices, request.quantity);
  p["layout"] = name_in(layout_choices, options.layout);
  p["strict"] = options.strict;
  return p;
}

evaluation::SweepRequest request_of(const SweepOptions& options) {
  evaluation::SweepRequest request{*options.theta_i, options.phi_i,
                                   options.phi_r.value_or(options.phi_i), *options.lambda_nm,
                                   *options.theta_r_deg};
  request.quantity = options.quantity.value_or(Quantity::relative);
  if (options.preset == Preset::thesis) request.depth = evaluation::DepthFrequency::unit_w;
  evaluation::require_valid(request);
  return request;
}

void run(SweepOptions options) {
  const auto start = std::chrono::steady_clock::now();
  apply_preset(options);
  const evaluation::Method& method = evaluation::method_named(options.method);
  require_consistent(options, method);
  const SurfaceModel model = evaluation::surface_model(method, options.model);
  const evaluation::SweepRequest request = request_of(options);

  std::optional<evaluation::OutputWithSidecar> output;
  if (!options.output.empty()) {
    require_other_file(options.output, options.heights.file);
    output.emplace(options.output);
  }
  const evaluation::HeightFile input = options.heights.read();
  const brdf::HeightField& field = input.field;
  const Length sigma =
      options.sigma.value_or(Length::um(std::min(field.width_um(), field.height_um()) / 4));
  const brdf::Surface surface{
      &field, brdf::GaussianWindow(sigma), model,
      options.preset == Preset::thesis ? brdf::Origin::patch_corner : brdf::Origin::patch_centre};
  check_sampling(request, field, options);

  const brdf::QueryBounds bounds =
      bounds_of(request, options.tolerance.value_or(default_tolerance));
  // The matrix, and its CSV at about 24 bytes a number.
  const std::size_t response_bytes = request.cells() * (sizeof(double) + 24);
  require_memory(method.bytes(surface, bounds, options.settings) + response_bytes +
                     static_cast<std::size_t>(field.heights_um().size()) * sizeof(double),
                 options);
  const auto amplitude = method.plan(surface, bounds, options.settings);
  const brdf::PlanReport report = amplitude->report();
  check_bound(report, options);

  evaluation::RunLimits limits;
  limits.threads = options.threads;
  if (options.time_limit) limits.time = {start, *options.time_limit};
  const evaluation::ResponseMatrix response = brdf::at_place(options.heights.file, [&] {
    return sweep(request, *amplitude, coherence_area_um2(surface), limits, progress_line("sweep"));
  });
  const std::string csv = to_csv(response, options.layout);
  if (!output) return print(csv);

  Json sidecar = sidecar_head("sweep", options.heights.file, input.sha256);
  sidecar["parameters"] = parameters_json(options, request, surface, report);
  sidecar["error"] = {{"amplitude_bound", report.error_bound},
                      {"input_phase_error_rad", report.input_phase_error_rad},
                      {"terms", report.terms},
                      {"relative_to", "the peak of a flat patch"}};
  sidecar = output->commit(csv, std::move(sidecar));
  if (options.json) print(sidecar.dump(2) + "\n");
}

void add_scene_options(CLI::App* sweep, SweepOptions& options) {
  add_parsed(sweep, "--theta-i", options.theta_i, parse_angle, "angle of incidence", "ANGLE")
      ->required();
  add_parsed(sweep, "--phi-i", options.phi_i, parse_angle, "azimuth of the light (default 0deg)",
             "ANGLE");
  add_parsed(sweep, "--theta-r", options.theta_r_deg, parse_angle_axis,
             "viewing angles, positive on the light's side", "START:STOP:STEP")
      ->required();
  add_parsed(sweep, "--phi-r", options.phi_r, parse_angle,
             "azimuth of the half-plane where theta_r is positive (default: phi_i)", "ANGLE");
  add_parsed(sweep, "--lambda", options.lambda_nm, parse_length_axis, "wavelengths",
             "START:STOP:STEP")
      ->required();
  add_parsed(sweep, "--sigma", options.sigma, parse_length,
             "standard deviation of the coherence window (default a quarter of the shorter side)",
             "LENGTH");
  add_choice(sweep, "--surface", options.model, surface_choices,
             "how the surface goes on beyond the patch (default: by the method)");
  add_choice(sweep, "--quantity", options.quantity, quantity_choices,
             "abs(a)^2, relative reflectance (default), or BRDF in 1/sr");
}

void add_method_options(CLI::App* sweep, SweepOptions& options) {
  std::string names;
  for (const evaluation::Method& method : evaluation::methods())
    names.append(names.empty() ? "" : "|").append(method.name);
  sweep->add_option("--method", options.method, "how the amplitude is computed (default taylor)")
      ->type_name(names);
  add_parsed(
      sweep, "--terms", options.settings.terms,
      [](const std::string& option, const std::string& text) {
        return parse_count(option, text, 1, 2000);
      },
      "taylor: number of terms, powers 0 to N-1", "N");
  add_parsed(sweep, "--tolerance", options.tolerance, parse_number,
             "largest error of the amplitude, flat patch's peak = 1 (default 1e-6)", "NUMBER");
  add_parsed(sweep, "--window-radius", options.settings.radius_sigma_f, parse_number,
             "taylor: neighbouring bins kept, in sigma_f (default 6, or by --tolerance)", "NUMBER");
  add_choice(sweep, "--preset", options.preset, preset_choices,
             "thesis: the sources' own evaluator, with its conventions");
}

void add_run_options(CLI::App* sweep, SweepOptions& options) {
  add_output(sweep, options.output,
             "CSV file, with its sidecar FILE.json (default: CSV to standard "
             "output)");
  add_choice(sweep, "--layout", options.layout, layout_choices, "of the CSV (default matrix)");
  add_parsed(
      sweep, "--threads", options.threads,
      [](const std::string& option, const std::string& text) {
        return parse_count(option, text, 1, 1024);
      },
      "threads (default: all); the result does not depend on them", "N");
  add_parsed(sweep, "--memory-limit", options.memory_limit, parse_bytes,
             "refuse what needs more (default 80 % of the machine's)", "BYTES");
  add_parsed(sweep, "--time-limit", options.time_limit, parse_duration, "give up after this",
             "TIME");
  sweep->add_flag("--strict", options.strict,
                  "fail with 5 where accuracy or sampling cannot be attained, instead of warning");
  sweep->add_flag("--json", options.json, "print the sidecar");
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
  options->heights.add_to(sweep);
  add_scene_options(sweep, *options);
  add_method_options(sweep, *options);
  add_run_options(sweep, *options);
  sweep->callback([options] { run(*options); });
}

}  // namespace apps
