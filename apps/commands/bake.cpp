// shedlight bake: the colours of a surface for all directions, once.
#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/exposure.h"
#include "apps/memory_limit.h"
#include "apps/surface_colours.h"
#include "evaluation/bake.h"
#include "evaluation/colour_volume_file.h"
#include "evaluation/npy.h"

namespace apps {
namespace {

using evaluation::Json;

struct BakeOptions {
  SurfaceColourOptions surface;
  CheckpointOptions checkpoint;
  std::string output;
};

constexpr int audited_directions = 2000;

/// A thousandth of what the automatic exposure makes white shows as code 3 of 255.
constexpr double darkest_shown = 1e-3;

/// The volume against spectra, at directions spread evenly.
evaluation::VolumeError volume_error(std::span<const Eigen::Vector3d> scattering,
                                     const evaluation::ScatteringColours& spectra,
                                     const brdf::ColourVolume& volume, double lobe) {
  std::vector<brdf::Xyz> exact(scattering.size());
  spectra.evaluate(scattering, exact);
  return evaluation::volume_error(volume, scattering, exact,
                                  {lobe, darkest_shown / Exposure{}.of(exact)});
}

void run(const BakeOptions& options) {
  require_other_file(options.output, options.surface.file());
  evaluation::OutputWithSidecar output(options.output);
  options.surface.require_bakeable();
  const auto patch = options.surface.read_patch();
  const brdf::VolumeGrid grid = options.surface.volume_grid(*patch);
  require_memory({options.surface.file(), "the volume", grid.size() * sizeof(float),
                  "a narrower window (--sigma) or a larger --colour-tolerance needs less"},
                 options.surface.run().memory_limit);
  const std::string header = evaluation::colour_volume_header(grid);
  evaluation::require_room(options.output, header.size() + grid.size() * sizeof(float));
  options.surface.prepare(*patch, evaluation::volume_corners(grid),
                          grid.points() * static_cast<std::size_t>(grid.shape().terms));
  Json sidecar = sidecar_head("bake", options.surface.file(), patch->input.sha256);
  sidecar["parameters"] = patch->parameters;
  sidecar["parameters"]["quantity"] = name_in(quantity_choices, options.surface.quantity());
  sidecar["volume"] = evaluation::volume_json(grid.shape());
  const auto checkpoint = options.checkpoint.open(sidecar);
  evaluation::RunLimits limits = options.surface.run().limits();
  limits.chunks = checkpoint.get();
  const auto began = std::chrono::steady_clock::now();
  const std::vector<float> numbers = brdf::at_place(options.surface.file(), [&] {
    return bake(grid, *patch->colours, limits, progress_line("bake"));
  });
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;

  const double mirror = mirror_radius(patch->surface);
  const std::vector<Eigen::Vector3d> scattering = evaluation::spread_scattering(audited_directions);
  const evaluation::VolumeError error =
      volume_error(scattering, *patch->colours, brdf::ColourVolume(grid, numbers), mirror / 4);
  sidecar["parameters"]["coherence_area_um2"] = coherence_area_um2(patch->surface);
  sidecar["parameters"]["mirror_radius_sine"] = mirror;
  sidecar["error"] = options.surface.audited(*patch, scattering);
  sidecar["error"]["volume"] = {{"directions", scattering.size()},
                                {"rms_of_local_brightness", error.rms},
                                {"worst_of_local_brightness", error.worst}};
  output.write(header);
  output.commit(evaluation::npy_bytes(numbers), std::move(sidecar));
  remove(checkpoint);
  message(fmt::format(
      "{} points x {} terms, {:.3g} MB, {:.3g} s; against spectra at {} "
      "directions: {:.2g} rms, {:.2g} at worst, of the local brightness",
      grid.points(), grid.shape().terms, static_cast<double>(grid.size()) * sizeof(float) / 1e6,
      took.count(), scattering.size(), error.rms, error.worst));
}

}  // namespace

void add_bake(CLI::App& app) {
  auto options = std::make_shared<BakeOptions>();
  CLI::App* bake = app.add_subcommand(
      "bake", "Colours for all directions, for map and render to look up, as an NPY file");
  bake->footer(
      "Fresnel's factor and shadowing stay open: they are options of map and render.\n"
      "Example:\n"
      "  shedlight bake scan.png --width 65um --height-range 818.69nm -o skin.npy\n"
      "  shedlight map skin.npy --theta-i 30deg --phi-i 90deg -o map.png");
  options->surface.add_to(bake);
  options->checkpoint.add_to(bake);
  add_output(bake, options->output, "NPY file, with its sidecar FILE.json")->required();
  bake->callback([options] { run(*options); });
}

}  // namespace apps
