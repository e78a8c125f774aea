// shedlight peaks: the brightest viewing angle of an order, wavelength by wavelength.
#include <memory>

#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/options.h"
#include "apps/response_input.h"

namespace apps {
namespace {

struct PeaksOptions {
  ResponseOptions response;
  std::string output;
};

void run(const PeaksOptions& options) {
  std::optional<evaluation::OutputWithSidecar> output;
  if (!options.output.empty()) {
    require_other_file(options.output, options.response.file);
    output.emplace(options.output);
  }
  const ResponseInput input = options.response.read();
  const std::string csv = to_csv(input.peaks(), input.plane, input.search.order, input.response);
  if (!output) return print(csv);
  evaluation::Json sidecar = sidecar_head("peaks", options.response.file, input.sha256);
  sidecar["parameters"] = input.parameters();
  output->commit(csv, std::move(sidecar));
}

}  // namespace

void add_peaks(CLI::App& app) {
  auto options = std::make_shared<PeaksOptions>();
  CLI::App* peaks =
      app.add_subcommand("peaks", "Brightest viewing angle of an order, per wavelength");
  peaks->footer(
      "A maximum on the edge of the searched angles is no peak: its row stays empty.\n"
      "Example:\n  shedlight peaks R.csv --order 1 --period-guess 1.55um -o peaks.csv");
  options->response.add_to(peaks);
  add_output(peaks, options->output, "CSV file (default: standard output)");
  peaks->callback([options] { run(*options); });
}

}  // namespace apps
