// shedlight plot: a response as a picture.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/cut_picture.h"
#include "apps/options.h"
#include "apps/quantities.h"
#include "apps/response_input.h"
#include "apps/response_picture.h"

namespace apps {
namespace {

using evaluation::Json;

const Choices<ValueScale> scale_choices{{"linear", ValueScale::linear},
                                        {"log", ValueScale::logarithmic}};

struct PlotOptions {
  ResponseOptions response;
  std::vector<std::string> others;
  std::optional<brdf::Length> cut;
  std::optional<ValueScale> scale;
  std::string output;
};

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

std::string draw_map(const ResponseInput& input, const PlotOptions& options) {
  ResponsePicture picture{
      &input.response,           input.plane, input.search.order, input.peaks(), {}, {},
      value_label(input.sidecar)};
  picture.fit = fit(input, picture.peaks);
  picture.title = picture_title(input, options.response.file);
  return draw(picture, picture_format(options.output));
}

/// The row of the wavelength nearest to the one asked for.
std::size_t row_at(const evaluation::Axis& lambda_nm, double wanted_nm, const std::string& file) {
  if (!(wanted_nm >= lambda_nm.front() && wanted_nm <= lambda_nm.back()))
    throw brdf::Error(brdf::Errc::invalid_argument,
                      fmt::format("--cut {} nm: {} has wavelengths from {} to {} nm", wanted_nm,
                                  file, lambda_nm.front(), lambda_nm.back()));
  std::size_t nearest = 0;
  for (std::size_t row = 0; row < lambda_nm.size(); ++row)
    if (std::abs(lambda_nm[row] - wanted_nm) < std::abs(lambda_nm[nearest] - wanted_nm))
      nearest = row;
  return nearest;
}

CutPicture::Curve curve_of(const evaluation::ResponseMatrix& response, double wanted_nm,
                           const std::string& file) {
  const std::size_t row = row_at(response.lambda_nm, wanted_nm, file);
  CutPicture::Curve curve{std::filesystem::path(file).filename().string(), {}};
  if (response.lambda_nm[row] != wanted_nm)
    curve.name += fmt::format(" at {} nm", response.lambda_nm[row]);
  for (std::size_t column = 0; column < response.theta_r_deg.size(); ++column)
    curve.points.emplace_back(
        response.theta_r_deg[column],
        response.values(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
  return curve;
}

std::string draw_cut(const ResponseInput& input, const PlotOptions& options) {
  const double wanted_nm = options.cut->nm();
  CutPicture picture{
      {curve_of(input.response, wanted_nm, options.response.file)},
      options.scale.value_or(ValueScale::linear),
      fmt::format("{:.6g} nm, light at {:.6g} deg", wanted_nm, input.plane.theta_i.deg()),
      value_label(input.sidecar)};
  for (const std::string& file : options.others) {
    const ResponseFile other = read_response(file);
    const std::string label = value_label(other.sidecar);
    if (!other.sidecar.is_null() && label != picture.value_label)
      throw brdf::Error(brdf::Errc::bad_input,
                        fmt::format("{}: holds {}, {} holds {}: one axis cannot show both", file,
                                    label, options.response.file, picture.value_label));
    picture.curves.push_back(curve_of(other.response, wanted_nm, file));
  }
  return draw(picture, picture_format(options.output));
}

void require_consistent(const PlotOptions& options) {
  const auto refuse = [](const char* what) {
    throw brdf::Error(brdf::Errc::invalid_argument, what);
  };
  if (!options.cut && !options.others.empty())
    refuse("several responses are drawn at one wavelength: give --cut");
  if (!options.cut && options.scale) refuse("--scale has no meaning without --cut");
}

void run(const PlotOptions& options) {
  require_consistent(options);
  require_other_file(options.output, options.response.file);
  for (const std::string& file : options.others) require_other_file(options.output, file);
  evaluation::OutputWithSidecar output(options.output);
  const ResponseInput input = options.response.read();
  Json sidecar = sidecar_head("plot", options.response.file, input.sha256);
  sidecar["parameters"] = input.parameters();
  if (options.cut) {
    sidecar["parameters"]["cut_nm"] = options.cut->nm();
    sidecar["parameters"]["beside"] = options.others;
  }
  output.commit(options.cut ? draw_cut(input, options) : draw_map(input, options),
                std::move(sidecar));
}

}  // namespace

void add_plot(CLI::App& app) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* plot = app.add_subcommand(
      "plot", "Picture of a response: heat map with peaks and fit, or several at one wavelength");
  plot->footer(
      "Examples:\n"
      "  shedlight plot R.csv -o R.png\n"
      "  shedlight plot one.csv two.csv --cut 550nm --scale log -o cut.png");
  options->response.add_to(plot);
  plot->add_option_function<std::vector<std::string>>(
          "others",
          [options](const std::vector<std::string>& files) {
            for (const std::string& file : files)
              options->others.push_back(parse_path("others", file));
          },
          "with --cut: further responses, one curve each")
      ->type_name("FILE ...");
  add_parsed(plot, "--cut", options->cut, parse_length,
             "draw the values at this wavelength over the viewing angle", "LENGTH");
  add_choice(plot, "--scale", options->scale, scale_choices,
             "of the values in a cut (default linear)");
  add_output(plot, options->output, "PNG, SVG or PDF, by its extension")->required();
  plot->callback([options] { run(*options); });
}

}  // namespace apps
