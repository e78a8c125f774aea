// shedlight colour: the colour of a response at each viewing angle.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "apps/colour_warnings.h"
#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/options.h"
#include "apps/quantities.h"
#include "apps/response_input.h"
#include "evaluation/response_colour.h"

namespace apps {
namespace {

using evaluation::Json;
using evaluation::RgbSpace;

const Choices<RgbSpace> space_choices{{"srgb", RgbSpace::srgb}, {"cie-rgb", RgbSpace::cie}};

struct ColourOptions {
  std::string file, output;
  RgbSpace space = RgbSpace::srgb;
  double exposure = 1;
};

/// A colour needs rho, whose 1 is the white; the other quantities have no white. Without a sidecar
/// the user knows.
void require_relative(const Json& sidecar, const std::string& file) {
  if (sidecar.is_null()) return;
  const std::string quantity = sidecar_text(sidecar, "/parameters/quantity", "an unknown quantity");
  if (quantity != "relative")
    throw brdf::Error(brdf::Errc::bad_input,
                      fmt::format("{}: holds {}; a colour needs the relative reflectance, whose 1 "
                                  "is the white: sweep --quantity relative",
                                  file, quantity));
}

Json parameters(const ColourOptions& options, const evaluation::ResponseColours& colours,
                const evaluation::ShownColours& shown) {
  const brdf::Chromaticity xy = chromaticity(colours.white);
  return {{"observer", "CIE 1931 2 degrees"},
          {"illuminant", "D65"},
          {"first_nm", colours.coverage.first_nm},
          {"last_nm", colours.coverage.last_nm},
          {"largest_step_nm", colours.coverage.largest_step_nm},
          {"white_xyz", {colours.white.x, colours.white.y, colours.white.z}},
          {"white_xy", {xy.x, xy.y}},
          {"space", name_in(space_choices, options.space)},
          {"rgb", options.space == RgbSpace::srgb ? "IEC 61966-2-1 transfer curve" : "linear"},
          {"exposure", options.exposure},
          {"colours", shown.rgb.size()},
          {"clipped", shown.clipped}};
}

void run(const ColourOptions& options) {
  std::optional<evaluation::OutputWithSidecar> output;
  if (!options.output.empty()) {
    require_other_file(options.output, options.file);
    output.emplace(options.output);
  }
  const ResponseFile input = read_response(options.file);
  require_relative(input.sidecar, options.file);
  const evaluation::ResponseColours colours =
      brdf::at_place(options.file, [&] { return response_colours(input.response); });
  const evaluation::ShownColours shown =
      shown_colours(colours.xyz, options.space, options.exposure);

  const std::string csv = to_csv(input.response.theta_r_deg, colours.xyz, shown.rgb);
  if (output) {
    Json sidecar = sidecar_head("colour", options.file, input.sha256);
    sidecar["parameters"] = parameters(options, colours, shown);
    output->commit(csv, std::move(sidecar));
  } else {
    print(csv);
  }
  warn_of_coverage(colours.coverage, options.file);
  warn_of_clipped(shown.clipped, shown.rgb.size(), "colours", name_in(space_choices, options.space),
                  options.file);
}

}  // namespace

void add_colour(CLI::App& app) {
  auto options = std::make_shared<ColourOptions>();
  CLI::App* colour =
      app.add_subcommand("colour", "Colour of a relative response under D65, per viewing angle");
  colour->footer(
      "X, Y, Z: CIE 1931 2-degree observer, Y = 1 for a reflectance of 1; without the exposure.\n"
      "R, G, B: 0 to 1, clipped; srgb through its transfer curve, cie-rgb linear and with a white\n"
      "of its own (E), in which D65 is (0.841, 1.033, 1.089).\n"
      "Example:\n"
      "  shedlight sweep g.gsf --theta-i 75deg --theta-r -80:80:0.5deg --lambda 380:780:5nm "
      "-o R.csv\n"
      "  shedlight colour R.csv -o colours.csv");
  add_parsed(colour, "response", options->file, parse_path, "CSV of sweep --quantity relative",
             "FILE")
      ->required();
  add_choice(colour, "--space", options->space, space_choices,
             "of R, G and B: srgb through the transfer curve, cie-rgb linear (default srgb)");
  add_parsed(colour, "--exposure", options->exposure, parse_exposure,
             "factor of the light before R, G and B (default 1)", "NUMBER");
  add_output(colour, options->output, "CSV file (default: standard output)");
  colour->callback([options] { run(*options); });
}

}  // namespace apps
