// shedlight albedo: how much of the light a surface sends back.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "apps/commands/commands.h"
#include "apps/commands/illuminated_options.h"
#include "apps/commands/method_options.h"
#include "apps/commands/optics_options.h"
#include "apps/commands/run_options.h"
#include "apps/memory_limit.h"
#include "apps/options.h"
#include "apps/quantities.h"
#include "evaluation/albedo.h"

namespace apps {
namespace {

using evaluation::DirectionalAlbedo;
using evaluation::Json;

/// Its effect on an albedo stays below 1e-5 on scans of this size.
constexpr double default_tolerance = 1e-9;

struct AlbedoOptions {
  HeightOptions heights;
  std::optional<evaluation::Axis> theta_i_deg, lambda_nm;
  brdf::Angle phi_i;
  IlluminatedOptions illuminated;
  OpticsOptions optics;
  std::string method = "auto";
  double tolerance = default_tolerance;
  RunOptions run;
  std::string output;

  void add_to(CLI::App* app);
  void require_consistent() const;
};

void AlbedoOptions::add_to(CLI::App* app) {
  heights.add_to(app);
  add_parsed(app, "--theta-i", theta_i_deg, parse_angle_axis, "angles of incidence",
             "START:STOP:STEP")
      ->required();
  add_parsed(app, "--phi-i", phi_i, parse_angle, "azimuth of the light (default 0deg)", "ANGLE");
  add_parsed(app, "--lambda", lambda_nm, parse_length_axis, "wavelengths", "START:STOP:STEP")
      ->required();
  illuminated.add_to(app);
  app->add_option("--method", method, "how the amplitude is computed (default auto)")
      ->type_name(amplitude_methods());
  add_parsed(app, "--tolerance", tolerance, parse_number,
             "largest error of the amplitude, flat patch's peak = 1 (default 1e-9)", "NUMBER");
  optics.add_to(app);
  run.add_to(app);
  add_output(app, output, "CSV file, with its sidecar FILE.json (default: standard output)");
}

void AlbedoOptions::require_consistent() const {
  const auto refuse = [](const std::string& what) {
    throw brdf::Error(brdf::Errc::invalid_argument, what);
  };
  require_not_given({{optics.quantity.has_value(), "--quantity"}},
                    "an albedo, which is that of the BRDF");
  require_tolerance("--tolerance", tolerance);
  for (const double theta : {theta_i_deg->front(), theta_i_deg->back()})
    if (!(std::abs(theta) < 90))
      refuse("--theta-i " + brdf::text(theta) + " deg: must lie between -90 and 90 deg");
  if (!(lambda_nm->front() > 0))
    refuse("--lambda " + brdf::text(lambda_nm->front()) + " nm: must be > 0");
}

/// Where frequencies of the hemisphere lie beyond the Nyquist limit the spectrum repeats itself,
/// and light counts twice.
void check_sampling(const AlbedoOptions& options, const brdf::HeightField& field) {
  const double shortest_nm = options.lambda_nm->front();
  double largest_sine = 0;
  for (const double theta : {options.theta_i_deg->front(), options.theta_i_deg->back()})
    largest_sine = std::max(largest_sine, std::abs(std::sin(brdf::Angle::deg(theta).rad())));
  const double limit_um = brdf::Length::nm(shortest_nm).um() / (2 * (1 + largest_sine));
  const double pixel_um = std::max(field.dx_um(), field.dy_um());
  if (pixel_um <= limit_um) return;
  report_unattained(
      fmt::format(
          "{}: pixels of {:.4g} um are too coarse for all directions at {} nm: up to {:.4g} "
          "um light would not count twice",
          options.heights.file, pixel_um, shortest_nm, limit_um),
      options.run.attainability());
}

struct Row {
  double theta_i_deg, lambda_nm;
  DirectionalAlbedo albedo;
};

std::string to_csv(const std::vector<Row>& rows) {
  std::string csv = "theta_i_deg,lambda_nm,albedo,error_bound,directions,outside_scalar_theory\n";
  for (const Row& row : rows)
    csv +=
        fmt::format("{},{},{},{:.3g},{},{}\n", brdf::text(row.theta_i_deg),
                    brdf::text(row.lambda_nm), brdf::text(row.albedo.value), row.albedo.error_bound,
                    row.albedo.directions, row.albedo.is_physical() ? "" : "yes");
  return csv;
}

/// The albedos at one wavelength. done: called after each.
template <class Done>
void add_rows(const AlbedoOptions& options, const brdf::Surface& surface, double lambda_nm,
              std::vector<Row>& rows, Done done) {
  const evaluation::AlbedoQuadrature quadrature(surface, brdf::Length::nm(lambda_nm));
  std::vector<brdf::Direction> lights;
  for (const double theta_i_deg : options.theta_i_deg->values)
    lights.push_back(brdf::direction(brdf::Angle::deg(theta_i_deg), options.phi_i));
  const brdf::QueryBounds bounds = quadrature.bounds(lights, options.tolerance);
  const evaluation::Method& method = evaluation::method_named(options.method);
  evaluation::MethodSettings settings;
  settings.threads = options.run.threads;
  require_memory({options.heights.file, "the albedo", method.bytes(surface, bounds, settings),
                  "a narrower window, a larger tolerance or --reduce needs less"},
                 options.run.memory_limit);
  const auto amplitude = method.plan(surface, bounds, settings);
  const evaluation::Optics optics = options.optics.optics(surface);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    rows.push_back({(*options.theta_i_deg)[i], lambda_nm,
                    quadrature.integrate(lights[i], *amplitude, optics, options.run.limits())});
    done();
  }
}

/// One line for all that are outside.
void warn_of_excess(const AlbedoOptions& options, const std::vector<Row>& rows) {
  const Row* worst = nullptr;
  std::size_t count = 0;
  for (const Row& row : rows) {
    if (row.albedo.is_physical()) continue;
    ++count;
    if (worst == nullptr || row.albedo.value > worst->albedo.value) worst = &row;
  }
  if (count == 0) return;
  report_unattained(
      fmt::format("{}: {} of {} albedos are above 1.001, outside the scalar theory; the largest is "
                  "{:.9g} at {} deg, {} nm",
                  options.heights.file, count, rows.size(), worst->albedo.value, worst->theta_i_deg,
                  worst->lambda_nm),
      options.run.attainability());
}

void run(AlbedoOptions options) {
  options.require_consistent();
  options.optics.quantity = brdf::Quantity::brdf;
  options.optics.require_consistent();
  options.illuminated.resolve(evaluation::method_named(options.method));
  std::optional<evaluation::OutputWithSidecar> output;
  if (!options.output.empty()) {
    require_other_file(options.output, options.heights.file);
    output.emplace(options.output);
  }
  const evaluation::HeightFile input = options.heights.read();
  check_sampling(options, input.field);
  const brdf::Surface surface =
      options.illuminated.surface(input.field, brdf::Origin::patch_centre);
  std::vector<Row> rows;
  const evaluation::Progress progress = progress_line("albedo");
  const std::size_t all = options.theta_i_deg->size() * options.lambda_nm->size();
  brdf::at_place(options.heights.file, [&] {
    for (const double lambda_nm : options.lambda_nm->values)
      add_rows(options, surface, lambda_nm, rows, [&] {
        if (progress) progress(static_cast<double>(rows.size()) / static_cast<double>(all));
      });
  });
  warn_of_excess(options, rows);
  if (!output) return print(to_csv(rows));
  Json sidecar = sidecar_head("albedo", options.heights.file, input.sha256);
  sidecar["parameters"] = options.heights.parameters(input.field);
  sidecar["parameters"]["theta_i_deg"] = axis_json(*options.theta_i_deg);
  sidecar["parameters"]["phi_i_deg"] = options.phi_i.deg();
  sidecar["parameters"]["lambda_nm"] = axis_json(*options.lambda_nm);
  sidecar["parameters"].update(illuminated_json(surface));
  sidecar["parameters"]["method"] = options.method;
  sidecar["parameters"]["tolerance"] = options.tolerance;
  sidecar["parameters"].update(options.optics.parameters());
  output->commit(to_csv(rows), std::move(sidecar));
}

}  // namespace

void add_albedo(CLI::App& app) {
  auto options = std::make_shared<AlbedoOptions>();
  CLI::App* albedo = app.add_subcommand(
      "albedo", "Directional albedo: the part of the light that a surface sends back");
  albedo->footer(
      "The integral of f_r cos theta_r over the hemisphere, with the error that the tolerance may\n"
      "make in it. Above 1.001 it is flagged as outside the scalar theory, never clipped.\n"
      "Example:\n"
      "  shedlight albedo scan.png --width 65um --height-range 818.69nm --theta-i 0:80:10deg \\\n"
      "    --lambda 550nm");
  options->add_to(albedo);
  albedo->callback([options] { run(*options); });
}

}  // namespace apps
