// shedlight synth: gratings made by formula.
#include <fmt/format.h>

#include <memory>

#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/options.h"
#include "apps/quantities.h"
#include "brdf/synthetic_surface.h"
#include "evaluation/writers/gsf_writer.h"

namespace apps {
namespace {

using brdf::Facing;
using brdf::Length;
using brdf::Profile;

const Choices<Profile> profile_choices{{"blazed", Profile::blazed},
                                       {"sinusoid", Profile::sinusoid},
                                       {"lamellar", Profile::lamellar},
                                       {"triangle", Profile::triangle},
                                       {"flat", Profile::flat}};
const Choices<Facing> facing_choices{{"+x", Facing::plus_x}, {"-x", Facing::minus_x}};

constexpr int max_side = 1 << 20;

struct SynthOptions {
  brdf::ProfileParameters parameters;
  std::optional<Length> period, height;
  std::optional<double> duty;
  std::optional<Facing> facing;
  std::pair<Length, Length> size;
  std::pair<int, int> pixels;
  std::string output;
};

/// Each profile takes the options that mean something for it, and no others.
brdf::ProfileParameters resolved(const SynthOptions& options) {
  brdf::ProfileParameters parameters = options.parameters;
  const std::string name = name_in(profile_choices, parameters.profile);
  const auto require = [&](bool given, bool wanted, const char* option) {
    if (given == wanted) return;
    throw brdf::Error(brdf::Errc::invalid_argument,
                      wanted ? fmt::format("a {} profile needs {}", name, option)
                             : fmt::format("{} has no meaning for a {} profile", option, name));
  };
  const bool is_grating = parameters.profile != Profile::flat;
  require(options.period.has_value(), is_grating, "--period");
  require(options.height.has_value(), is_grating, "--height");
  if (options.duty) require(true, parameters.profile == Profile::lamellar, "--duty");
  if (options.facing) require(true, parameters.profile == Profile::blazed, "--facing");
  parameters.period = options.period.value_or(parameters.period);
  parameters.height = options.height.value_or(parameters.height);
  parameters.duty = options.duty.value_or(parameters.duty);
  parameters.facing = options.facing.value_or(parameters.facing);
  return parameters;
}

void run(const SynthOptions& options) {
  const brdf::ProfileParameters parameters = resolved(options);
  const auto [cols, rows] = options.pixels;
  if (!(options.size.first.um() > 0 && options.size.second.um() > 0))
    throw brdf::Error(brdf::Errc::invalid_argument,
                      fmt::format("--size {}um,{}um: must be > 0", options.size.first.um(),
                                  options.size.second.um()));
  if (static_cast<std::size_t>(cols) * static_cast<std::size_t>(rows) > evaluation::max_pixels)
    throw brdf::Error(
        brdf::Errc::invalid_argument,
        fmt::format("--pixels {},{}: at most {} in all", cols, rows, evaluation::max_pixels));
  evaluation::OutputWithSidecar output(options.output);
  const brdf::HeightField field =
      brdf::synthetic_grating(parameters, rows, cols, Length::um(options.size.first.um() / cols),
                              Length::um(options.size.second.um() / rows));
  const std::string name = name_in(profile_choices, parameters.profile);
  evaluation::Json sidecar = sidecar_head("synth", "", "");
  sidecar["parameters"] = {{"profile", name},
                           {"width_um", field.width_um()},
                           {"height_um", field.height_um()},
                           {"pixels", {cols, rows}}};
  if (parameters.profile != Profile::flat) {
    sidecar["parameters"]["period_nm"] = parameters.period.nm();
    sidecar["parameters"]["peak_to_valley_nm"] = parameters.height.nm();
  }
  if (parameters.profile == Profile::lamellar) sidecar["parameters"]["duty"] = parameters.duty;
  if (parameters.profile == Profile::blazed)
    sidecar["parameters"]["falls_towards"] = name_in(facing_choices, parameters.facing);
  output.commit(evaluation::to_gsf(field, name), std::move(sidecar));
}

}  // namespace

void add_synth(CLI::App& app) {
  auto options = std::make_shared<SynthOptions>();
  CLI::App* synth = app.add_subcommand("synth", "Make a grating by formula, as a GSF file");
  synth->footer(
      "Phase 0 lies at x = 0, the middle of the patch; heights are sampled at pixel centres.\n"
      "A blaze falling in +x (the default) sends light into order +1.\n"
      "Example:\n"
      "  shedlight synth blazed --period 2500nm --height 200nm --size 65um --pixels 650 -o g.gsf");
  add_choice(synth, "profile", options->parameters.profile, profile_choices, "shape")->required();
  add_parsed(synth, "--period", options->period, parse_length, "period along x", "LENGTH");
  add_parsed(synth, "--height", options->height, parse_length, "peak to valley", "LENGTH");
  add_parsed(synth, "--duty", options->duty, parse_number,
             "lamellar: part of the period that is high (default 0.5)", "FRACTION");
  add_choice(synth, "--facing", options->facing, facing_choices,
             "blazed: the direction in which it falls (default +x)");
  add_parsed(synth, "--size", options->size, parse_length_pair, "side of the patch, or x,y",
             "LENGTH[,LENGTH]")
      ->required();
  add_parsed(
      synth, "--pixels", options->pixels,
      [](const std::string& option, const std::string& text) {
        return parse_count_pair(option, text, 1, max_side);
      },
      "pixels a side, or columns,rows", "N[,N]")
      ->required();
  add_output(synth, options->output, "the GSF file")->required();
  synth->callback([options] { run(*options); });
}

}  // namespace apps
