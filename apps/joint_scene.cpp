#include "apps/joint_scene.h"

#include <cmath>

#include "apps/commands/optics_options.h"
#include "apps/options.h"

namespace apps {
namespace {

using brdf::Angle;
using brdf::Length;
using brdf::SurfaceModel;
using evaluation::Json;

/// The numbers and names of a sidecar, each refused by name where it is missing.
struct Parameters {
  const Json& sidecar;
  const std::string& file;

  [[noreturn]] void refuse(const std::string& what) const {
    throw brdf::Error(brdf::Errc::bad_input, evaluation::sidecar_path(file).string() + ": " + what);
  }
  double number(const std::string& key) const {
    const auto value = sidecar_number(sidecar, "/parameters/" + key);
    if (!value || !std::isfinite(*value)) refuse("parameter " + key + " is missing or no number");
    return *value;
  }
  template <class T>
  T choice(const std::string& key, const Choices<T>& choices) const {
    const std::string name = sidecar_text(sidecar, "/parameters/" + key, "");
    for (const auto& [known, value] : choices)
      if (known == name) return value;
    refuse("parameter " + key + " '" + name + "' is not known");
  }
  int count(const std::string& key) const {
    const double value = number(key);
    if (!(value >= 1 && value <= 1 << 20 && value == std::round(value)))
      refuse("parameter " + key + " " + brdf::text(value) + " must be a count");
    return static_cast<int>(value);
  }
};

SurfaceModel model_of(const Parameters& p) {
  static const Choices<SurfaceModel> models{{"isolated", SurfaceModel::isolated},
                                            {"periodic", SurfaceModel::periodic},
                                            {"replicated", SurfaceModel::replicated}};
  return p.choice("surface", models);
}

}  // namespace

evaluation::JointScene joint_scene(const ResponseInput& input, const std::string& file) {
  const Parameters p{input.sidecar, file};
  const SurfaceModel model = model_of(p);
  const Length pixel_x = Length::um(p.number("pixel_um/0"));
  const Length pixel_y = Length::um(p.number("pixel_um/1"));
  const int cols = p.count("columns"), rows = p.count("rows");
  // What the window and the axes do not say, the replicated model has no window, takes any value.
  const bool windowed = model != SurfaceModel::replicated;
  const brdf::GaussianWindow window(Length::um(windowed ? p.number("sigma_um") : 1.0));
  const brdf::Replicas replicas =
      windowed ? brdf::Replicas{} : brdf::Replicas{p.count("replicas/0"), p.count("replicas/1")};
  // Only its sides matter.
  const brdf::HeightField patch(brdf::HeightArray::Zero(rows, cols), pixel_x, pixel_y);
  const brdf::Surface surface{&patch, window, model, brdf::Origin::patch_centre, replicas};
  evaluation::Optics optics;
  optics.quantity = p.choice("quantity", quantity_choices);
  const Json::json_pointer fresnel("/parameters/fresnel");
  if (!input.sidecar.contains(fresnel)) p.refuse("parameter fresnel is missing");
  optics.fresnel = brdf::at_place(evaluation::sidecar_path(file).string(),
                                  [&] { return fresnel_from_json(input.sidecar[fresnel]); });
  optics.shadowing = p.choice("shadowing", shadowing_choices);
  optics.coherence_area_um2 = coherence_area_um2(surface);
  return {.theta_i = input.plane.theta_i,
          .phi_i = Angle::deg(p.number("phi_i_deg")),
          .phi_r = Angle::deg(p.number("phi_r_deg")),
          .optics = optics,
          .model = model,
          .window = window,
          .x = x_axis(surface),
          .y = y_axis(surface),
          .floor = input.search.floor};
}

bool has_joint_scene(const ResponseInput& input, const std::string& file) {
  const bool of_sweep = sidecar_text(input.sidecar, "/command", "") == "sweep" &&
                        sidecar_text(input.sidecar, "/parameters/preset", "") == "physical" &&
                        // Cells that were left out are 0, which is no measurement of a lobe.
                        !input.sidecar.contains(Json::json_pointer("/parameters/orders_only"));
  if (!of_sweep) return false;
  try {
    joint_scene(input, file);
    return true;
  } catch (const brdf::Error&) {
    return false;
  }
}

}  // namespace apps
