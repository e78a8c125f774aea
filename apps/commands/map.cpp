// shedlight map: the colours of a surface over the hemisphere of viewing directions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>

#include "apps/colour_warnings.h"
#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/exposure.h"
#include "apps/map_picture.h"
#include "apps/quantities.h"
#include "apps/surface_colours.h"
#include "evaluation/hemisphere.h"
#include "evaluation/npy.h"
#include "evaluation/rgb_image.h"

namespace apps {
namespace {

using brdf::Angle;
using evaluation::DirectionPair;
using evaluation::Json;

enum class MirrorLobe { shown, apart };
const Choices<MirrorLobe> mirror_choices{{"shown", MirrorLobe::shown},
                                         {"apart", MirrorLobe::apart}};

constexpr int most_lights = 12;

struct MapOptions {
  SurfaceColourOptions surface;
  CheckpointOptions checkpoint;
  std::vector<Angle> theta_i;
  Angle phi_i;
  int size = 512;
  Exposure exposure;
  MirrorLobe mirror = MirrorLobe::shown;
  std::optional<brdf::Length> arcs;
  std::optional<Angle> arcs_azimuth;
  std::string output;
};

/// The lights and the pixels of one hemisphere, light by light.
std::vector<DirectionPair> pairs_of(const MapOptions& options,
                                    const evaluation::Hemisphere& hemisphere) {
  std::vector<DirectionPair> pairs;
  for (const Angle theta_i : options.theta_i) {
    const brdf::Direction omega_i =
        brdf::at_place("--theta-i", [&] { return brdf::direction(theta_i, options.phi_i); });
    for (const auto& pixel : hemisphere.pixels())
      pairs.push_back({omega_i, *hemisphere.direction(pixel.column, pixel.row)});
  }
  return pairs;
}

/// What the pairs come from, for the sidecar.
Json pairs_json(const MapOptions& options) {
  Json json;
  for (const Angle theta_i : options.theta_i) json["theta_i_deg"].push_back(theta_i.deg());
  json["phi_i_deg"] = options.phi_i.deg();
  json["size"] = options.size;
  return json;
}

/// Whether the mirror lobe covers a pair.
bool in_mirror_lobe(const DirectionPair& pair, double radius) {
  const Eigen::Vector3d s = brdf::scattering_vector(pair.omega_i, pair.omega_r);
  return std::hypot(s.x(), s.y()) <= radius;
}

/// Lights x rows x columns x 3, linear XYZ without exposure; 0 outside the disk. Row 0 has the
/// smallest y.
std::vector<double> linear_xyz(const MapOptions& options, const evaluation::Hemisphere& hemisphere,
                               const std::vector<brdf::Xyz>& colours) {
  const auto side = static_cast<std::size_t>(hemisphere.size());
  std::vector<double> values(options.theta_i.size() * side * side * 3, 0.0);
  std::size_t next = 0;
  for (std::size_t light = 0; light < options.theta_i.size(); ++light)
    for (const auto& pixel : hemisphere.pixels()) {
      const brdf::Xyz& colour = colours[next++];
      double* at = &values[(light * side * side + pixel.index(hemisphere.size())) * 3];
      at[0] = colour.x;
      at[1] = colour.y;
      at[2] = colour.z;
    }
  return values;
}

/// The picture of one light, from its colours as they are shown.
MapPanel panel(const MapOptions& options, const evaluation::Hemisphere& hemisphere, Angle theta_i,
               std::span<const brdf::Rgb> rgb) {
  MapPanel panel{{}, theta_i, options.phi_i, {}};
  const auto side = static_cast<std::size_t>(hemisphere.size());
  panel.rgba.assign(side * side * 4, 0);  // transparent outside the disk
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    std::uint8_t* at = &panel.rgba[hemisphere.pixels()[i].index(hemisphere.size()) * 4];
    std::ranges::copy(evaluation::to_code(rgb[i]), at);
    at[3] = 255;
  }
  return panel;
}

void run(const MapOptions& options) {
  if (options.theta_i.size() > most_lights)
    throw brdf::Error(brdf::Errc::invalid_argument,
                      fmt::format("--theta-i: {} lights; a sheet holds at most {}",
                                  options.theta_i.size(), most_lights));
  if (options.arcs_azimuth && !options.arcs)
    throw brdf::Error(brdf::Errc::invalid_argument, "--arcs-azimuth needs --arcs, the period");
  require_other_file(options.output, options.surface.file());
  const std::filesystem::path npy = std::filesystem::path(options.output).replace_extension(".npy");
  if (npy == std::filesystem::path(options.output))
    throw brdf::Error(brdf::Errc::invalid_argument, "output " + options.output +
                                                        ": is no picture; its XYZ go into " +
                                                        npy.string() + " beside it");
  require_other_file(npy.string(), options.surface.file());
  PictureOutput output(options.output);
  evaluation::OutputFile linear(npy);

  const evaluation::Hemisphere hemisphere(options.size);
  const std::vector<DirectionPair> pairs = pairs_of(options, hemisphere);
  SurfaceColours colours = options.surface.colours(pairs, options.checkpoint, pairs_json(options));

  const bool apart = options.mirror == MirrorLobe::apart && colours.mirror_radius > 0;
  std::vector<brdf::Xyz> shown_xyz = colours.xyz, metered;
  double mirror_luminance = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!in_mirror_lobe(pairs[i], colours.mirror_radius)) {
      metered.push_back(colours.xyz[i]);
      continue;
    }
    mirror_luminance = std::max(mirror_luminance, colours.xyz[i].y);
    if (apart) shown_xyz[i] = {};
  }
  const double exposure = options.exposure.of(metered);
  const evaluation::ShownColours shown =
      shown_colours(shown_xyz, evaluation::RgbSpace::srgb, exposure);

  MapPicture picture{std::filesystem::path(options.surface.file()).filename().string(),
                     options.size,
                     {},
                     std::nullopt,
                     std::nullopt};
  if (options.arcs)
    picture.arcs = OrderArcs{*options.arcs, options.arcs_azimuth.value_or(options.phi_i)};
  if (apart) picture.mirror_radius = colours.mirror_radius;
  const std::size_t per_light = hemisphere.pixels().size();
  for (std::size_t light = 0; light < options.theta_i.size(); ++light) {
    picture.panels.push_back(panel(options, hemisphere, options.theta_i[light],
                                   std::span(shown.rgb).subspan(light * per_light, per_light)));
    picture.panels.back().caption =
        fmt::format("exposure {:.4g}{}", exposure, apart ? "; mirror lobe left out" : "");
  }
  const std::string drawn = draw(picture, output.format);

  const std::vector<double> xyz = linear_xyz(options, hemisphere, colours.xyz);
  const auto side = static_cast<std::size_t>(options.size);
  const std::string header =
      evaluation::npy_header({evaluation::NpyType::real, {options.theta_i.size(), side, side, 3}});
  evaluation::Sha256 hash;
  for (const std::string_view bytes : {std::string_view(header), evaluation::npy_bytes(xyz)}) {
    linear.write(bytes);
    hash.update(bytes);
  }

  Json sidecar = sidecar_head("map", options.surface.file(), colours.input_sha256);
  Json& parameters = sidecar["parameters"] = colours.parameters;
  parameters.update(pairs_json(options));
  parameters["projection"] = "orthographic: (sin theta_r cos phi_r, sin theta_r sin phi_r)";
  parameters["exposure"] = exposure;
  parameters["exposure_by"] = options.exposure.description();
  parameters["mirror_lobe"] = name_in(mirror_choices, options.mirror);
  parameters["mirror_radius_sine"] = colours.mirror_radius;
  parameters["mirror_luminance"] = mirror_luminance;
  parameters["pixels"] = shown.rgb.size();
  parameters["clipped"] = shown.clipped;
  sidecar["error"] = colours.error;
  sidecar["linear_xyz"] = {{"file", npy.filename().string()}, {"sha256", hash.hex()}};
  output.commit(drawn, std::move(sidecar), {&linear});
  remove(colours.checkpoint);
  message(colours.summary());
  message(options.exposure.summary(exposure));
  warn_of_clipped(shown.clipped, shown.rgb.size(), "pixels", "srgb", options.surface.file());
}

std::vector<Angle> parse_angles(const std::string& option, const std::string& text) {
  std::vector<Angle> angles;
  std::stringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');)
    angles.push_back(parse_angle(option, part));
  if (angles.empty() || text.back() == ',') angles.push_back(parse_angle(option, ""));
  return angles;
}

}  // namespace

void add_map(CLI::App& app) {
  auto options = std::make_shared<MapOptions>();
  CLI::App* map = app.add_subcommand(
      "map", "Colours over the hemisphere of viewing directions, for one light or several");
  map->footer(
      "Writes the picture, FILE.npy beside it (lights x rows x columns x 3: linear XYZ, Y = 1 for\n"
      "white, row 0 at the smallest y, 0 outside the disk) and the sidecar FILE.png.json.\n"
      "Example:\n"
      "  shedlight map scan.png --width 65um --height-range 818.69nm --theta-i 0deg,30deg,75deg "
      "\\\n"
      "    --phi-i 90deg --mirror-lobe apart -o map.png");
  options->surface.add_to(map);
  options->checkpoint.add_to(map);
  add_parsed(map, "--theta-i", options->theta_i, parse_angles,
             "angle of incidence, or several for a sheet", "ANGLE[,ANGLE...]")
      ->required();
  add_parsed(map, "--phi-i", options->phi_i, parse_angle, "azimuth of the light (default 0deg)",
             "ANGLE");
  add_parsed(map, "--size", options->size, count_between(16, 4096),
             "pixels along a side of the hemisphere (default 512)", "N");
  options->exposure.add_to(map);
  add_choice(map, "--mirror-lobe", options->mirror, mirror_choices,
             "whether the lobe around the mirror direction is drawn (default shown)");
  add_parsed(map, "--arcs", options->arcs, parse_length,
             "draw where the orders of this period are expected", "LENGTH");
  add_parsed(map, "--arcs-azimuth", options->arcs_azimuth, parse_angle,
             "azimuth of its grating vector (default: phi_i)", "ANGLE");
  add_output(map, options->output,
             "PNG, SVG or PDF, with its sidecar FILE.json and its colours as NPY")
      ->required();
  map->callback([options] { run(*options); });
}

}  // namespace apps
