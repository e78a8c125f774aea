// shedlight plot: a response as a picture.
#include <fmt/format.h>

#include <memory>

#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/options.h"
#include "apps/plot.h"
#include "apps/response_input.h"
#include "evaluation/readers/file_bytes.h"

namespace apps {
namespace {

using evaluation::Json;

struct PlotOptions {
  ResponseOptions response;
  std::string output;
};

std::string value_label(const Json& sidecar) {
  const std::string quantity = sidecar_text(sidecar, "/parameters/quantity", "");
  if (quantity == "power") return "abs(a)^2";
  if (quantity == "relative") return "relative reflectance";
  if (quantity == "brdf") return "BRDF [1/sr]";
  if (quantity == "radiance") return "radiance per intensity I [1/sr]";
  return "response";
}

/// The fit, or nothing with a warning: a response without an order is a picture all the same.
std::optional<evaluation::PeriodFit> fit(const ResponseInput& input,
                                         const std::vector<evaluation::Peak>& peaks) {
  try {
    return fit_period(peaks, input.plane, input.search.order, input.angle_step_deg());
  } catch (const brdf::Error& error) {
    if (error.code() != brdf::Errc::not_attainable) throw;
    message(std::string("warning: no period drawn: ") + error.what());
    return std::nullopt;
  }
}

void run(const PlotOptions& options) {
  require_other_file(options.output, options.response.file);
  evaluation::OutputWithSidecar output(options.output);
  const ResponseInput input = options.response.read();
  ResponsePicture picture{
      &input.response,           input.plane, input.search.order, input.peaks(), {}, {},
      value_label(input.sidecar)};
  picture.fit = fit(input, picture.peaks);
  const std::filesystem::path scan =
      sidecar_text(input.sidecar, "/input/file", options.response.file);
  picture.title =
      fmt::format("{}, light at {:.6g} deg", scan.filename().string(), input.plane.theta_i.deg());
  Json sidecar = sidecar_head("plot", options.response.file, input.sha256);
  sidecar["parameters"] = input.parameters();
  output.commit(draw_png(picture), std::move(sidecar));
}

}  // namespace

void add_plot(CLI::App& app) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* plot =
      app.add_subcommand("plot", "Picture of a response: heat map, peaks, fitted grating equation");
  plot->footer("Example:\n  shedlight plot R.csv -o R.png");
  options->response.add_to(plot);
  add_output(plot, options->output, "PNG file")->required();
  plot->callback([options] { run(*options); });
}

}  // namespace apps
