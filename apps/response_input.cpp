#include "apps/response_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "apps/options.h"
#include "apps/quantities.h"
#include "brdf/gaussian_window.h"
#include "evaluation/readers/file_bytes.h"

namespace apps {
namespace {

using brdf::Angle;
using brdf::Length;
using evaluation::Json;
using evaluation::Refinement;

const Choices<Refinement> refinement_choices{{"grid", Refinement::grid},
                                             {"parabola", Refinement::parabola}};

std::optional<Angle> angle(const std::optional<Angle>& option, const Json& sidecar,
                           const std::string& key) {
  if (option) return option;
  if (const auto value = sidecar_number(sidecar, "/parameters/" + key)) return Angle::deg(*value);
  return std::nullopt;
}

/// The response that the error of the amplitude could make where there is none: its square, for
/// quantities whose gain is about 1; 0 where nothing is known. A bound above a hundredth, such as
/// that of an interpolation which holds for any surface, gives way to what the audit found on this
/// one.
double response_floor(const Json& sidecar) {
  constexpr double telling_bound = 1e-2;
  const std::string quantity = sidecar_text(sidecar, "/parameters/quantity", "");
  if (quantity == "brdf" || quantity == "radiance") return 0;
  double error = sidecar_number(sidecar, "/error/amplitude_bound").value_or(0);
  const auto found = sidecar_number(sidecar, "/error/audit/worst_error");
  if (error > telling_bound && found) error = std::min(error, *found);
  return error * error;
}

}  // namespace

std::optional<double> sidecar_number(const Json& sidecar, const std::string& pointer) {
  const Json::json_pointer at(pointer);
  if (!sidecar.contains(at) || !sidecar[at].is_number()) return std::nullopt;
  return sidecar[at].get<double>();
}

std::string sidecar_text(const Json& sidecar, const std::string& pointer,
                         const std::string& otherwise) {
  const Json::json_pointer at(pointer);
  return sidecar.contains(at) && sidecar[at].is_string() ? sidecar[at].get<std::string>()
                                                         : otherwise;
}

std::string value_label(const Json& sidecar) {
  const std::string quantity = sidecar_text(sidecar, "/parameters/quantity", "");
  if (quantity == "power") return "abs(a)^2";
  if (quantity == "relative") return "relative reflectance";
  if (quantity == "brdf") return "BRDF [1/sr]";
  if (quantity == "radiance") return "radiance per intensity I [1/sr]";
  return "response";
}

std::string picture_title(const ResponseInput& input, const std::string& file) {
  const std::filesystem::path scan = sidecar_text(input.sidecar, "/input/file", file);
  return fmt::format("{}, light at {:.6g} deg", scan.filename().string(),
                     input.plane.theta_i.deg());
}

ResponseFile read_response(const std::string& file) {
  const std::string bytes = evaluation::read_file_bytes(file);
  const std::string sha256 = evaluation::sha256_hex(bytes);
  return {evaluation::response_from_csv(bytes, file), sha256,
          evaluation::read_sidecar(file, sha256)};
}

double ResponseInput::angle_step_deg() const {
  const evaluation::Axis& theta = response.theta_r_deg;
  if (search.refinement != Refinement::grid || theta.size() < 2) return 0;
  return (theta.back() - theta.front()) / static_cast<double>(theta.size() - 1);
}

Json ResponseInput::parameters() const {
  Json p{{"theta_i_deg", plane.theta_i.deg()},
         {"viewer_positive_side", plane.light_side > 0 ? "light" : "opposite to the light"},
         {"order", search.order},
         {"side", evaluation::side_of(search.order)},
         {"refine", name_in(refinement_choices, search.refinement)}};
  if (plane.sigma_f_per_um) p["sigma_um"] = 1 / (2 * brdf::pi * *plane.sigma_f_per_um);
  if (search.period_guess) p["period_guess_nm"] = search.period_guess->nm();
  if (search.period_range)
    p["period_range_nm"] = {search.period_range->first.nm(), search.period_range->second.nm()};
  if (search.theta_r_deg) p["window_deg"] = {search.theta_r_deg->first, search.theta_r_deg->second};
  return p;
}

void ResponseOptions::add_to(CLI::App* app) {
  add_parsed(app, "response", file, parse_path, "CSV written by sweep", "FILE")->required();
  add_settings_to(app);
}

void ResponseOptions::add_settings_to(CLI::App* app) {
  add_parsed(app, "--order", search.order, count_between(-1000, 1000),
             "order of diffraction, positive towards the light (default 1)", "M");
  add_parsed(app, "--period-guess", search.period_guess, parse_length,
             "look within half an order of where this period puts the order", "LENGTH");
  add_parsed(app, "--period-range", search.period_range, parse_length_interval,
             "look only where these periods put the order", "LOW:HIGH");
  add_parsed(app, "--window", window, parse_angle_interval, "look only at these viewing angles",
             "LOW:HIGH");
  add_choice(app, "--refine", refinement, refinement_choices,
             "peak angle on the grid, or refined (default parabola; grid for the thesis preset)");
  add_parsed(app, "--theta-i", theta_i, parse_angle, "angle of incidence (default: the sidecar's)",
             "ANGLE");
  add_parsed(app, "--phi-i", phi_i, parse_angle, "azimuth of the light (default: the sidecar's)",
             "ANGLE");
  add_parsed(app, "--phi-r", phi_r, parse_angle, "azimuth of the viewer (default: the sidecar's)",
             "ANGLE");
  add_parsed(app, "--sigma", sigma, parse_length, "coherence window (default: the sidecar's)",
             "LENGTH");
}

ResponseInput ResponseOptions::read() const {
  ResponseFile read = read_response(file);
  ResponseInput input{
      std::move(read.response), {}, search, std::move(read.sidecar), std::move(read.sha256)};
  const Json& sidecar = input.sidecar;
  const std::optional<Angle> incidence = angle(theta_i, sidecar, "theta_i_deg");
  if (!incidence)
    throw brdf::Error(brdf::Errc::bad_input,
                      file + ": has no sidecar " + evaluation::sidecar_path(file).string() +
                          " that gives the angle of incidence; give --theta-i");
  if (!(std::abs(incidence->deg()) < 90))
    throw brdf::Error(brdf::Errc::invalid_argument, "angle of incidence " +
                                                        brdf::text(incidence->deg()) +
                                                        " deg must lie between -90 and 90 deg");
  const Angle light = angle(phi_i, sidecar, "phi_i_deg").value_or(Angle{});
  const Angle viewer = angle(phi_r, sidecar, "phi_r_deg").value_or(light);
  input.plane = evaluation::plane_of_incidence(*incidence, light, viewer);
  const std::optional<double> sigma_um =
      sigma ? std::optional(sigma->um()) : sidecar_number(sidecar, "/parameters/sigma_um");
  if (sigma_um)
    input.plane.sigma_f_per_um = brdf::GaussianWindow(Length::um(*sigma_um)).sigma_f_per_um();
  input.search.floor = response_floor(sidecar);
  if (window) input.search.theta_r_deg = {window->first.deg(), window->second.deg()};
  input.search.refinement = refinement.value_or(
      sidecar_text(sidecar, "/parameters/preset", "") == "thesis" ? Refinement::grid
                                                                  : Refinement::parabola);
  return input;
}

}  // namespace apps
