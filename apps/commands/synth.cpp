// shedlight synth: surfaces made by formula.
#include <fmt/format.h>

#include <memory>

#include "apps/commands/commands.h"
#include "apps/commands/synth_options.h"
#include "apps/options.h"
#include "apps/quantities.h"
#include "evaluation/writers/gsf_writer.h"

namespace apps {
namespace {

using brdf::Length;

constexpr int max_side = 1 << 20;

struct Options {
  SynthOptions surface;
  std::pair<Length, Length> size;
  std::pair<int, int> pixels;
  std::string output;
};

void run(const Options& options) {
  const brdf::SyntheticSurface surface = options.surface.surface();
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
      brdf::synthetic_surface(surface, rows, cols, Length::um(options.size.first.um() / cols),
                              Length::um(options.size.second.um() / rows));
  evaluation::Json sidecar = sidecar_head("synth", "", "");
  sidecar["parameters"] = options.surface.parameters();
  sidecar["parameters"].update(
      {{"width_um", field.width_um()}, {"height_um", field.height_um()}, {"pixels", {cols, rows}}});
  output.commit(evaluation::to_gsf(field, options.surface.shape_name()), std::move(sidecar));
}

}  // namespace

void add_synth(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* synth = app.add_subcommand("synth", "Make a surface by formula, as a GSF file");
  synth->footer(
      "Phase 0 of every grating lies in the middle of the patch; heights are sampled at pixel "
      "centres.\n"
      "A blaze falling in +x (the default) sends light into order +1.\n"
      "The same seed makes the same surface on every machine; a line's jitter does not depend on "
      "size and pixels.\n"
      "Examples:\n"
      "  shedlight synth blazed --period 2500nm --height 200nm --size 65um --pixels 650 -o g.gsf\n"
      "  shedlight synth fingers --period 1100nm --crossed-period 4um --height 300nm --jitter 80nm "
      "\\\n"
      "      --size 65um --pixels 650 -o skin.gsf");
  options->surface.add_to(synth);
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
