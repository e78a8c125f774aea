// shedlight bake: the colours of a surface for all directions, once.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
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
  std::string output;
};

/// Volume against spectra, at directions spread evenly over those between the points of its grid.
struct VolumeError {
  std::size_t directions = 0;
  double rms = 0;  ///< of the luminance, as a part of the local brightness
  double worst = 0;
};

constexpr int audited_directions = 2000;

/// Directions of light and viewer, by the golden-ratio sequences of four dimensions.
std::vector<Eigen::Vector3d> spread_scattering(int count) {
  // The root of x^5 = x + 1 gives the steps (Roberts 2018).
  constexpr double root = 1.1673039782614187;
  std::vector<Eigen::Vector3d> scattering;
  for (int i = 1; i <= count; ++i) {
    double place[4];
    for (int d = 0; d < 4; ++d) {
      const double turns = i / std::pow(root, d + 1);
      place[d] = turns - std::floor(turns);
    }
    // Even over the hemispheres' projections.
    const auto direction = [](double radius_squared, double turn) {
      return brdf::direction(brdf::Angle::rad(std::asin(0.999 * std::sqrt(radius_squared))),
                             brdf::Angle::rad(2 * brdf::pi * turn));
    };
    scattering.push_back(
        brdf::scattering_vector(direction(place[0], place[1]), direction(place[2], place[3])));
  }
  return scattering;
}

/// A thousandth of what the automatic exposure makes white shows as code 3 of 255.
constexpr double darkest_shown = 1e-3;

/// The brightness about a place is the mean of the luminance over lobes nearby, along a ring; at
/// least the darkest that a picture shows.
VolumeError volume_error(const evaluation::ScatteringColours& spectra,
                         const evaluation::ScatteringColours& volume, double lobe) {
  const std::vector<Eigen::Vector3d> scattering = spread_scattering(audited_directions);
  std::vector<brdf::Xyz> exact(scattering.size()), read(scattering.size());
  spectra.evaluate(scattering, exact);
  volume.evaluate(scattering, read);
  const double darkest = darkest_shown / Exposure{}.of(exact);
  VolumeError error{scattering.size(), 0, 0};
  constexpr int around = 9;
  for (std::size_t i = 0; i < scattering.size(); ++i) {
    const Eigen::Vector3d& s = scattering[i];
    std::vector<Eigen::Vector3d> near;
    for (int j = 0; j < around; ++j) {
      const double turn = (j - around / 2) * lobe / std::max(lobe, std::hypot(s.x(), s.y()));
      near.emplace_back(s.x() * std::cos(turn) - s.y() * std::sin(turn),
                        s.x() * std::sin(turn) + s.y() * std::cos(turn), s.z());
    }
    std::vector<brdf::Xyz> values(near.size());
    volume.evaluate(near, values);
    double brightness = 0;
    for (const brdf::Xyz& value : values) brightness += value.y / around;
    const double part = std::abs(read[i].y - exact[i].y) / std::max(brightness, darkest);
    error.rms += part * part / static_cast<double>(scattering.size());
    error.worst = std::max(error.worst, part);
  }
  error.rms = std::sqrt(error.rms);
  return error;
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
  const auto began = std::chrono::steady_clock::now();
  const std::vector<float> numbers = brdf::at_place(options.surface.file(), [&] {
    return bake(grid, *patch->colours, options.surface.run().limits(), progress_line("bake"));
  });
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;

  const double mirror = mirror_radius(patch->surface);
  const VolumeError error = volume_error(
      *patch->colours, evaluation::BakedColours(brdf::ColourVolume(grid, numbers)), mirror / 4);
  Json sidecar = sidecar_head("bake", options.surface.file(), patch->input.sha256);
  sidecar["parameters"] = patch->parameters;
  sidecar["parameters"]["quantity"] = name_in(quantity_choices, options.surface.quantity());
  sidecar["parameters"]["coherence_area_um2"] = coherence_area_um2(patch->surface);
  sidecar["parameters"]["mirror_radius_sine"] = mirror;
  sidecar["volume"] = evaluation::volume_json(grid.shape());
  sidecar["error"] = options.surface.audited(*patch, spread_scattering(audited_directions));
  sidecar["error"]["volume"] = {{"directions", error.directions},
                                {"rms_of_local_brightness", error.rms},
                                {"worst_of_local_brightness", error.worst}};
  output.write(header);
  output.commit(evaluation::npy_bytes(numbers), std::move(sidecar));
  message(fmt::format(
      "{} points x {} terms, {:.3g} MB, {:.3g} s; against spectra at {} "
      "directions: {:.2g} rms, {:.2g} at worst, of the local brightness",
      grid.points(), grid.shape().terms, static_cast<double>(grid.size()) * sizeof(float) / 1e6,
      took.count(), error.directions, error.rms, error.worst));
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
  add_output(bake, options->output, "NPY file, with its sidecar FILE.json")->required();
  bake->callback([options] { run(*options); });
}

}  // namespace apps
