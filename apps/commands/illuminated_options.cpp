#include "apps/commands/illuminated_options.h"

#include <algorithm>

#include "apps/quantities.h"

namespace apps {

using brdf::SurfaceModel;

namespace {

const Choices<SurfaceModel> surface_choices{{"isolated", SurfaceModel::isolated},
                                            {"periodic", SurfaceModel::periodic},
                                            {"replicated", SurfaceModel::replicated}};

}  // namespace

void IlluminatedOptions::add_to(CLI::App* app) {
  add_parsed(app, "--sigma", sigma, parse_length,
             "standard deviation of the coherence window (default a quarter of the shorter side)",
             "LENGTH");
  add_choice(app, "--surface", model, surface_choices,
             "how the surface goes on beyond the patch (default isolated; periodic for taylor)");
  add_parsed(
      app, "--replicas", replicas,
      [](const std::string& option, const std::string& text) {
        return parse_count_pair(option, text, 1, 1000000);
      },
      "copies of the patch side by side, evenly lit, for --surface replicated", "N[,N]");
}

void IlluminatedOptions::resolve(const evaluation::Method& method) {
  if (replicas && !model) model = SurfaceModel::replicated;
  model = surface_model(method, model);
  if (replicas && *model != SurfaceModel::replicated)
    throw brdf::Error(brdf::Errc::invalid_argument,
                      "--replicas goes with --surface replicated, not " +
                          std::string(evaluation::name_of(*model)));
}

brdf::Surface IlluminatedOptions::surface(const brdf::HeightField& field,
                                          brdf::Origin origin) const {
  const auto quarter = brdf::Length::um(std::min(field.width_um(), field.height_um()) / 4);
  const auto [across, down] = replicas.value_or(std::pair(1, 1));
  return {&field, brdf::GaussianWindow(sigma.value_or(quarter)), *model, origin, {across, down}};
}

evaluation::Json illuminated_json(const brdf::Surface& surface) {
  evaluation::Json json{{"surface", evaluation::name_of(surface.model)}};
  if (surface.model == SurfaceModel::replicated)
    json["replicas"] = {surface.replicas.x, surface.replicas.y};
  else
    json["sigma_um"] = surface.window.sigma_um();
  return json;
}

}  // namespace apps
