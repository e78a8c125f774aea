// shedlight tradeoff: speed against accuracy of every method, measured on one's own surface.
#include <fmt/format.h>

#include <memory>

#include "apps/commands/commands.h"
#include "apps/commands/illuminated_options.h"
#include "apps/commands/run_options.h"
#include "apps/commands/scene_options.h"
#include "apps/memory_limit.h"
#include "apps/options.h"
#include "apps/quantities.h"
#include "apps/tradeoff_picture.h"

namespace apps {
namespace {

using brdf::SurfaceModel;
using evaluation::Json;
using evaluation::TradeoffRow;

/// The sources light some copies side by side; with one copy their factor is 1.
constexpr std::pair default_copies{8, 8};

struct TradeoffOptions {
  HeightOptions heights;
  SceneOptions scene;
  IlluminatedOptions illuminated;
  std::optional<brdf::Length> period;
  int order = 1, repeats = 5, seed = 1;
  std::optional<double> budget_error;
  std::optional<std::chrono::duration<double>> budget_time;
  RunOptions run;
  std::string output, picture;

  void add_to(CLI::App* app);
  void require_consistent() const;
  std::vector<SurfaceModel> models() const;
  brdf::Replicas replicas() const {
    const auto [across, down] =
        illuminated.replicas.value_or(illuminated.model ? std::pair(1, 1) : default_copies);
    return {across, down};
  }
};

void TradeoffOptions::add_to(CLI::App* app) {
  heights.add_to(app);
  scene.add_to(app);
  illuminated.add_to(app);
  add_parsed(app, "--period", period, parse_length,
             "period along the plane of incidence: peaks are looked for near it, and the orders "
             "alone are tried",
             "LENGTH");
  add_parsed(
      app, "--order", order,
      [](const std::string& option, const std::string& text) {
        return parse_count(option, text, -1000, 1000);
      },
      "order whose peaks and period are compared (default 1)", "M");
  add_parsed(app, "--budget-error", budget_error, parse_number,
             "name the fastest method with at most this worst error of the amplitude", "NUMBER");
  add_parsed(app, "--budget-time", budget_time, parse_duration,
             "name the most accurate method that takes at most this time", "TIME");
  add_parsed(app, "--repeats", repeats, count_between(1, 1000),
             "runs of each trial, of which the median counts (default 5)", "N");
  add_parsed(app, "--seed", seed, count_between(0, 1000000000),
             "of the order of the runs (default 1)", "N");
  run.add_to(app);
  add_output(app, output, "CSV table, with its sidecar FILE.json")->required();
  add_parsed(app, "--plot", picture, parse_path, "PNG, SVG or PDF: the picture of the table",
             "FILE");
}

void TradeoffOptions::require_consistent() const {
  const auto refuse = [](const std::string& what) {
    throw brdf::Error(brdf::Errc::invalid_argument, what);
  };
  if (budget_error && !(*budget_error > 0 && *budget_error < 1))
    refuse("--budget-error " + brdf::text(*budget_error) + ": must lie between 0 and 1");
  if (illuminated.replicas &&
      illuminated.model.value_or(SurfaceModel::replicated) != SurfaceModel::replicated)
    refuse("--replicas goes with --surface replicated, not " +
           std::string(evaluation::name_of(*illuminated.model)));
  if (picture == output) refuse("--plot " + picture + ": is the table's file");
  require_other_file(output, heights.file);
  if (!picture.empty()) require_other_file(picture, heights.file);
}

std::vector<SurfaceModel> TradeoffOptions::models() const {
  if (illuminated.model) return {*illuminated.model};
  if (illuminated.replicas) return {SurfaceModel::replicated};
  return {SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated};
}

std::string name_of(const TradeoffRow& row) {
  const evaluation::Trial& trial = row.trial;
  std::string name = trial.method;
  if (trial.tolerance) name += fmt::format(", tolerance {:g}", *trial.tolerance);
  if (trial.terms) name += fmt::format(", {} terms", *trial.terms);
  if (trial.radius_sigma_f) name += fmt::format(", radius {:.3g} sigma_f", *trial.radius_sigma_f);
  if (trial.interpolation) name += ", " + std::string(evaluation::name_of(*trial.interpolation));
  if (trial.lambda_step_nm) name += fmt::format(", every {:g} nm", *trial.lambda_step_nm);
  if (trial.cells == evaluation::Cells::orders) name += ", orders only";
  return name;
}

/// The frontier of each surface, a row a line.
std::string frontier_text(std::span<const TradeoffRow> rows) {
  std::string text = fmt::format("{:>4}  {:<11} {:<42} {:>10} {:>10} {:>9}\n", "row", "surface",
                                 "on the frontier", "seconds", "worst", "MB");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TradeoffRow& row = rows[i];
    if (!row.on_frontier) continue;
    std::string surface(evaluation::name_of(row.trial.model));
    if (row.trial.model == SurfaceModel::replicated)
      surface = fmt::format("{} x {}", row.trial.replicas.x, row.trial.replicas.y);
    text += fmt::format(
        "{:>4}  {:<11} {:<42} {:>10.3g} {:>10.2g} {:>9}\n", i + 1, surface, name_of(row),
        row.time.total_s(), row.errors.worst,
        row.peak_bytes ? fmt::format("{:.3g}", static_cast<double>(*row.peak_bytes) / 1e6) : "?");
  }
  return text;
}

/// Rows within the budget, one for each surface model.
std::vector<std::size_t> chosen(const TradeoffOptions& options, std::span<const TradeoffRow> rows) {
  std::vector<std::size_t> chosen;
  for (const SurfaceModel model : options.models()) {
    const brdf::Replicas copies =
        model == SurfaceModel::replicated ? options.replicas() : brdf::Replicas{};
    const auto add = [&](std::optional<std::size_t> row, const std::string& budget) {
      if (row)
        chosen.push_back(*row);
      else
        report_unattained(fmt::format("{}: no method on the {} surface {}", options.heights.file,
                                      evaluation::name_of(model), budget),
                          options.run.attainability());
    };
    if (options.budget_error)
      add(fastest_within(rows, model, copies, *options.budget_error),
          fmt::format("has an error of at most {:g}", *options.budget_error));
    if (options.budget_time)
      add(most_accurate_within(rows, model, copies, options.budget_time->count()),
          fmt::format("takes at most {:g} s", options.budget_time->count()));
  }
  return chosen;
}

Json audits_json(const evaluation::Tradeoff& found) {
  Json json = Json::array();
  for (const evaluation::ReferenceAudit& audit : found.references) {
    Json reference{{"surface", evaluation::name_of(audit.model)}};
    if (audit.model == SurfaceModel::replicated)
      reference["replicas"] = {audit.replicas.x, audit.replicas.y};
    reference["method"] = "chebyshev";
    reference["tolerance"] = evaluation::TradeoffReference::tolerance;
    reference["cells_audited"] = evaluation::TradeoffReference::audited_cells;
    reference["worst_error_against_direct_sum"] = audit.worst_error;
    json.push_back(std::move(reference));
  }
  return json;
}

void run(TradeoffOptions options) {
  options.require_consistent();
  evaluation::SweepRequest sweep = options.scene.request();
  evaluation::OutputWithSidecar output(options.output);
  std::optional<PictureOutput> picture;
  if (!options.picture.empty()) picture.emplace(options.picture);
  const evaluation::HeightFile input = options.heights.read();
  options.scene.turn(input.field, options.heights.file);
  sweep = options.scene.request();
  check_sampling(sweep, input.field, options.heights.file, options.run.attainability());

  IlluminatedOptions illuminated = options.illuminated;
  if (!illuminated.model) illuminated.model = options.models().front();
  const evaluation::TradeoffRequest request{
      sweep,
      &input.field,
      illuminated.surface(input.field, brdf::Origin::patch_centre).window,
      options.period,
      options.order,
      options.run.limits()};
  require_memory({options.heights.file, "the trade-off",
                  bytes_needed(request, options.models(), options.replicas()),
                  "a smaller range or --reduce needs less"},
                 options.run.memory_limit);
  evaluation::TradeoffSchedule schedule;
  schedule.repeats = options.repeats;
  schedule.seed = static_cast<std::uint64_t>(options.seed);
  const evaluation::Tradeoff found = brdf::at_place(options.heights.file, [&] {
    return tradeoff(request, options.models(), options.replicas(), schedule,
                    progress_line("tradeoff"));
  });
  for (const evaluation::ReferenceAudit& audit : found.references)
    if (!(audit.worst_error <= 100 * evaluation::TradeoffReference::tolerance))
      report_unattained(
          fmt::format("{}: the reference of the {} surface is {:.2g} off the direct sum: errors "
                      "below that mean nothing",
                      options.heights.file, evaluation::name_of(audit.model), audit.worst_error),
          options.run.attainability());

  const std::vector<std::size_t> within = chosen(options, found.rows);
  Json sidecar = sidecar_head("tradeoff", options.heights.file, input.sha256);
  sidecar["parameters"] = options.heights.parameters(input.field);
  sidecar["parameters"].update(scene_json(sweep));
  sidecar["parameters"]["sigma_um"] = request.window.sigma_um();
  if (options.period) sidecar["parameters"]["period_um"] = options.period->um();
  sidecar["parameters"]["order"] = options.order;
  sidecar["parameters"]["repeats"] = options.repeats;
  sidecar["parameters"]["seed"] = options.seed;
  sidecar["parameters"]["threads"] = options.run.threads;
  sidecar["references"] = audits_json(found);
  sidecar["within_budget"] = Json::array();
  for (const std::size_t i : within) sidecar["within_budget"].push_back(i + 1);
  output.commit(to_csv(found.rows), sidecar);
  if (picture)
    picture->commit(
        draw(TradeoffPicture{found.rows, within,
                             std::filesystem::path(options.heights.file).filename().string()},
             picture->format),
        std::move(sidecar));

  std::string text = frontier_text(found.rows);
  for (const std::size_t i : within)
    text += fmt::format("within the budget, {} surface: {}: sweep ... --like {}:{}\n",
                        evaluation::name_of(found.rows[i].trial.model), name_of(found.rows[i]),
                        options.output, i + 1);
  print(text);
}

}  // namespace

void add_tradeoff(CLI::App& app) {
  auto options = std::make_shared<TradeoffOptions>();
  CLI::App* tradeoff = app.add_subcommand(
      "tradeoff", "Speed against accuracy of every method on a request, measured");
  tradeoff->footer(
      "Every method runs over its knobs; errors are against the expansion at 1e-12 of the same\n"
      "surface model, itself held against the direct sum. Without --surface all three models.\n"
      "Example:\n"
      "  shedlight tradeoff scan.png --width 65um --height-range 818.69nm --theta-i 75deg \\\n"
      "    --phi-i 90deg --theta-r -50:-25:0.1deg --lambda 380:780:1nm --budget-error 1e-6 \\\n"
      "    -o frontier.csv --plot frontier.png\n"
      "  shedlight sweep scan.png ... --like frontier.csv:12 -o R.csv");
  options->add_to(tradeoff);
  tradeoff->callback([options] { run(*options); });
}

}  // namespace apps
