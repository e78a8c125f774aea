#include "apps/commands/scene_options.h"

#include <fmt/format.h>

#include "apps/options.h"
#include "apps/quantities.h"
#include "evaluation/period/surface_periods.h"

namespace apps {
namespace {

const Choices<Along> along_choices{{"auto", Along::grating}};

}  // namespace

void SceneOptions::add_to(CLI::App* app) {
  add_parsed(app, "--theta-i", theta_i, parse_angle, "angle of incidence", "ANGLE")->required();
  add_parsed(app, "--phi-i", phi_i, parse_angle, "azimuth of the light (default 0deg)", "ANGLE");
  add_choice(app, "--along", along, along_choices,
             "lay the plane of incidence along the grating vector found in the heights")
      ->excludes(app->get_option("--phi-i"));
  add_parsed(app, "--theta-r", theta_r_deg, parse_angle_axis,
             "viewing angles, positive on the light's side", "START:STOP:STEP")
      ->required();
  add_parsed(app, "--phi-r", phi_r, parse_angle,
             "azimuth of the half-plane where theta_r is positive (default: phi_i)", "ANGLE");
  add_parsed(app, "--lambda", lambda_nm, parse_length_axis, "wavelengths", "START:STOP:STEP")
      ->required();
}

evaluation::SweepRequest SceneOptions::request() const {
  const brdf::Angle light = phi_i.value_or(brdf::Angle{});
  evaluation::SweepRequest request{*theta_i, light, phi_r.value_or(light), *lambda_nm,
                                   *theta_r_deg};
  evaluation::require_valid(request);
  return request;
}

void SceneOptions::turn(const brdf::HeightField& field, const std::string& file) {
  if (along == Along::azimuth) return;
  phi_i = brdf::at_place(file, [&] { return evaluation::grating_azimuth(field); });
}

evaluation::Json scene_json(const evaluation::SweepRequest& request) {
  return {{"theta_i_deg", request.theta_i.deg()},
          {"phi_i_deg", request.phi_i.deg()},
          {"phi_r_deg", request.phi_r.deg()},
          {"theta_r_deg", axis_json(request.theta_r_deg)},
          {"lambda_nm", axis_json(request.lambda_nm)}};
}

void check_sampling(const evaluation::SweepRequest& request, const brdf::HeightField& field,
                    const std::string& file, Attainability attainability) {
  const auto excess = evaluation::nyquist_excess(request, field);
  if (!excess) return;
  const std::string safe =
      excess->safe_deg
          ? fmt::format("safe are {} to {} deg", excess->safe_deg->first, excess->safe_deg->second)
          : "no angle asked for is safe";
  report_unattained(
      fmt::format("{}: at {} nm the viewing angles go past the Nyquist limit of its {} x {} um "
                  "pixels: {}",
                  file, excess->lambda_nm, field.dx_um(), field.dy_um(), safe),
      attainability);
}

}  // namespace apps
