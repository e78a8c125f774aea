#include "apps/commands/scene_options.h"

#include <fmt/format.h>

#include "apps/options.h"
#include "apps/quantities.h"

namespace apps {

void SceneOptions::add_to(CLI::App* app) {
  add_parsed(app, "--theta-i", theta_i, parse_angle, "angle of incidence", "ANGLE")->required();
  add_parsed(app, "--phi-i", phi_i, parse_angle, "azimuth of the light (default 0deg)", "ANGLE");
  add_parsed(app, "--theta-r", theta_r_deg, parse_angle_axis,
             "viewing angles, positive on the light's side", "START:STOP:STEP")
      ->required();
  add_parsed(app, "--phi-r", phi_r, parse_angle,
             "azimuth of the half-plane where theta_r is positive (default: phi_i)", "ANGLE");
  add_parsed(app, "--lambda", lambda_nm, parse_length_axis, "wavelengths", "START:STOP:STEP")
      ->required();
}

evaluation::SweepRequest SceneOptions::request() const {
  evaluation::SweepRequest request{*theta_i, phi_i, phi_r.value_or(phi_i), *lambda_nm,
                                   *theta_r_deg};
  evaluation::require_valid(request);
  return request;
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
