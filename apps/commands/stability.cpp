// shedlight stability: every method and formula at its extremes.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "apps/check_table.h"
#include "apps/checks_picture.h"
#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/exit_codes.h"
#include "apps/options.h"
#include "evaluation/stability.h"

namespace apps {
namespace {

struct StabilityOptions {
  std::string output, picture;
  bool json = false;
};

void run(const StabilityOptions& options) {
  require_apart(options.output, options.picture);
  std::optional<evaluation::OutputWithSidecar> output;
  std::optional<PictureOutput> picture;
  if (!options.output.empty()) output.emplace(options.output);
  if (!options.picture.empty()) picture.emplace(options.picture);
  const std::vector<evaluation::CheckRow> rows = evaluation::stability_rows();
  const evaluation::Json sidecar = sidecar_head("stability", "", "");
  if (output) output->commit(table_csv(rows), sidecar);
  if (picture)
    picture->commit(draw(ChecksPicture{rows, "Largest errors at the extremes, against 50 digits"},
                         picture->format),
                    sidecar);
  print(options.json ? evaluation::json_text(table_json(rows)) : table_for_people(rows));
  if (!all_hold(rows)) throw ValidationFailed{};
}

}  // namespace

void add_stability(CLI::App& app) {
  auto options = std::make_shared<StabilityOptions>();
  CLI::App* stability = app.add_subcommand(
      "stability", "Measure every method at its extremes against 50 digits; exit 1 if one fails");
  stability->footer("Example:\n  shedlight stability -o stability.csv --plot stability.png");
  add_output(stability, options->output, "CSV of all columns, with the reason of each limit");
  add_parsed(stability, "--plot", options->picture, parse_path,
             "PNG, SVG or PDF: each row's error against its limit", "FILE");
  stability->add_flag("--json", options->json, "the table as JSON");
  stability->callback([options] { run(*options); });
}

}  // namespace apps
