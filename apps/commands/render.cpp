// shedlight render: a picture of a shape that a grating covers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "apps/colour_warnings.h"
#include "apps/commands/commands.h"
#include "apps/commands/render_options.h"
#include "apps/console.h"
#include "apps/surface_colours.h"
#include "brdf/colour.h"
#include "evaluation/scene/surface_point.h"

namespace apps {
namespace {

using brdf::Errc;
using brdf::Error;
using brdf::Rgb;
using brdf::Xyz;
using evaluation::DirectionPair;
using evaluation::Json;
using evaluation::RgbCode;
using evaluation::SurfacePoint;

struct Options {
  SurfaceColourOptions surface;
  RenderOptions render;
};

/// Light and viewer in the frame of the patch; none where the patch has no direction.
std::optional<DirectionPair> directions_at(const Scene& scene, const SurfacePoint& point) {
  const auto frame = patch_frame(point, scene.orientation);
  if (!frame) return std::nullopt;
  return DirectionPair{frame->local(scene.light),
                       frame->local(scene.camera.viewer(point.position))};
}

/// The pixels whose diffraction is asked for, block by block.
struct LitPixels {
  std::vector<std::size_t> indices;
  std::vector<DirectionPair> pairs;
  std::size_t surface = 0;     ///< pixels that show the shape
  std::size_t undirected = 0;  ///< of them, without a direction of the patch
};

LitPixels lit_pixels(const Scene& scene, const evaluation::SurfaceGrid& grid) {
  LitPixels lit;
  for (const std::size_t index : block_order(grid)) {
    if (!grid.points[index]) continue;
    ++lit.surface;
    const std::optional<DirectionPair> pair = directions_at(scene, *grid.points[index]);
    if (!pair) {
      ++lit.undirected;
    } else if (is_lit(*pair)) {
      lit.indices.push_back(index);
      lit.pairs.push_back(*pair);
    }
  }
  return lit;
}

/// How diffraction and diffuse colour become light.
struct Shading {
  const Scene& scene;
  double blend, exposure;
  std::optional<Rgb> diffuse;  ///< linear

  /// blend exposure XYZ -> linear sRGB + (1 - blend) diffuse cos theta_i; neither is there below
  /// the horizon of the light.
  brdf::InGamut operator()(const SurfacePoint& point, const Xyz& diffraction) const {
    Rgb light = linear_srgb(blend * exposure * diffraction);
    const double share = (1 - blend) * std::max(0.0, point.normal.dot(scene.light));
    const Rgb colour = scene.texture
                           ? texture_at(*scene.texture, point.texture.x(), point.texture.y())
                           : diffuse.value_or(Rgb{});
    light = {light.r + share * colour.r, light.g + share * colour.g, light.b + share * colour.b};
    return clipped_to_gamut(light);
  }
};

Shading shading(const RenderOptions& options, const Scene& scene, double exposure) {
  Shading shading{scene, options.resolved_blend(), exposure, std::nullopt};
  if (options.diffuse) {
    const Rgb& c = *options.diffuse;
    shading.diffuse =
        Rgb{brdf::srgb_decoded(c.r), brdf::srgb_decoded(c.g), brdf::srgb_decoded(c.b)};
  }
  return shading;
}

struct Picture {
  evaluation::RgbImage image;
  std::size_t clipped = 0;
};

Picture picture_of(const evaluation::SurfaceGrid& grid, const std::vector<Xyz>& diffraction,
                   const Shading& shading, const Rgb& background) {
  Picture picture{{grid.cols, grid.rows, {}}};
  picture.image.pixels.assign(grid.points.size(), evaluation::to_code(background));
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    if (!grid.points[i]) continue;
    const brdf::InGamut shown = shading(*grid.points[i], diffraction[i]);
    picture.image.pixels[i] = evaluation::to_code(srgb_encoded(shown.rgb));
    if (shown.clipped) ++picture.clipped;
  }
  return picture;
}

void put_files(const Scene& scene, Json& sidecar) {
  for (const SceneFile& file : scene.files) sidecar["scene_files"].push_back(file.json());
}

void run_picture(const Options& options, const Scene& scene,
                 evaluation::OutputWithSidecar& output) {
  const evaluation::SurfaceGrid grid = scene.visible();
  const LitPixels lit = lit_pixels(scene, grid);
  if (lit.pairs.empty())
    throw Error(Errc::invalid_argument,
                fmt::format("{}: none of its {} pixels has light and viewer above its horizon and "
                            "a direction of the grating; turn --light, --rotate or --along",
                            options.render.shape, lit.surface));
  const SurfaceColours colours = options.surface.colours(lit.pairs);
  const double exposure = options.render.exposure.of(colours.xyz);
  std::vector<Xyz> diffraction(grid.points.size());
  for (std::size_t i = 0; i < lit.indices.size(); ++i) diffraction[lit.indices[i]] = colours.xyz[i];
  const Picture picture = picture_of(grid, diffraction, shading(options.render, scene, exposure),
                                     options.render.background);

  Json sidecar = sidecar_head("render", options.surface.file(), colours.input_sha256);
  put_files(scene, sidecar);
  sidecar["parameters"] = options.render.parameters();
  sidecar["parameters"].update(Json{{"exposure", exposure},
                                    {"exposure_by", options.render.exposure.description()},
                                    {"surface_pixels", lit.surface},
                                    {"lit_pixels", lit.pairs.size()},
                                    {"undirected_pixels", lit.undirected},
                                    {"clipped", picture.clipped},
                                    {"surface", colours.parameters}});
  sidecar["error"] = colours.error;
  output.commit(to_png(picture.image), std::move(sidecar));

  message(colours.summary());
  message(options.render.exposure.summary(exposure));
  if (lit.undirected > 0)
    message(
        fmt::format("warning: {}: {} of {} pixels have no direction of the grating and show no "
                    "diffraction",
                    options.render.shape, lit.undirected, lit.surface));
  warn_of_clipped(picture.clipped, lit.surface, "pixels", "srgb", options.render.output);
}

double degrees(double rad) {
  return brdf::Angle::rad(rad).deg();
}

Json angles_json(const DirectionPair& pair) {
  const auto theta = [](const brdf::Direction& d) {
    return degrees(std::atan2(std::hypot(d.x(), d.y()), d.z()));
  };
  const auto phi = [](const brdf::Direction& d) { return degrees(std::atan2(d.y(), d.x())); };
  return {{"theta_i_deg", theta(pair.omega_i)},
          {"phi_i_deg", phi(pair.omega_i)},
          {"theta_r_deg", theta(pair.omega_r)},
          {"phi_r_deg", phi(pair.omega_r)}};
}

/// What one pixel shows.
Json probed(const Options& options, const Scene& scene) {
  const auto [col, row] = *options.render.probe;
  const double exposure = options.render.exposure.factor.value_or(1);
  Json json{{"pixel", {col, row}}, {"shows", "background"}};
  const std::optional<SurfacePoint> point = scene.visible().at(col, row);
  if (!point) {
    json["rgb"] = evaluation::to_code(options.render.background);
    return json;
  }
  json["shows"] = "no direction of the grating";
  json["texture"] = {point->texture.x(), point->texture.y()};
  Xyz colour;
  if (const auto pair = directions_at(scene, *point)) {
    json.update(angles_json(*pair));
    json["shows"] = is_lit(*pair) ? "lit" : "unlit";
    if (is_lit(*pair)) colour = options.surface.colours(std::span(&*pair, 1)).xyz.front();
  }
  const brdf::InGamut shown = shading(options.render, scene, exposure)(*point, colour);
  json["xyz"] = {colour.x, colour.y, colour.z};
  json["exposure"] = exposure;
  json["blend"] = options.render.resolved_blend();
  json["clipped"] = shown.clipped;
  json["rgb"] = evaluation::to_code(srgb_encoded(shown.rgb));
  return json;
}

void run(const Options& options) {
  options.render.require_consistent();
  if (options.render.probe) {
    print(evaluation::json_text(probed(options, options.render.read())));
    return;
  }
  require_other_file(options.render.output, options.surface.file());
  for (const std::string& input : options.render.inputs())
    require_other_file(options.render.output, input);
  evaluation::OutputWithSidecar output(options.render.output);
  run_picture(options, options.render.read(), output);
}

}  // namespace

void add_render(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* render =
      app.add_subcommand("render", "Picture of a shape that the grating covers, as PNG");
  render->footer(
      "x of the patch runs along the parallels of a sphere, around a cylinder, along u of a mesh.\n"
      "The light is one direction seen from the camera; 0deg,0deg is behind the viewer.\n"
      "Example:\n"
      "  shedlight render g.gsf --shape sphere --light 40deg,90deg --rotate 20deg,0deg,0deg "
      "-o sphere.png\n"
      "  shedlight render g.gsf --light 40deg,90deg --probe 256,100 --exposure 2");
  options->surface.add_to(render);
  options->render.add_to(render);
  render->callback([options] { run(*options); });
}

}  // namespace apps
