#include "evaluation/response_colour.h"

#include <algorithm>
#include <cmath>

namespace evaluation {
namespace {

constexpr double visible_first_nm = 380, visible_last_nm = 780;

}  // namespace

SpectralCoverage coverage_of(const Axis& lambda_nm) {
  SpectralCoverage coverage{lambda_nm.front(), lambda_nm.back(), 0};
  for (std::size_t i = 0; i + 1 < lambda_nm.size(); ++i)
    if (lambda_nm[i] < visible_last_nm && lambda_nm[i + 1] > visible_first_nm)
      coverage.largest_step_nm =
          std::max(coverage.largest_step_nm, lambda_nm[i + 1] - lambda_nm[i]);
  return coverage;
}

namespace {

void require_colour(const Axis& lambda_nm) {
  if (lambda_nm.size() < 2)
    throw brdf::Error(brdf::Errc::bad_input,
                      "has " + std::to_string(lambda_nm.size()) +
                          " wavelength; a colour needs at least 2, better 380 to 780 nm by 5 nm");
  const bool visible = std::any_of(lambda_nm.values.begin(), lambda_nm.values.end(), [](double nm) {
    return nm >= visible_first_nm && nm <= visible_last_nm;
  });
  if (!visible)
    throw brdf::Error(brdf::Errc::bad_input,
                      "has no wavelength from 380 to 780 nm: its wavelengths, " +
                          number_text(lambda_nm.front()) + " to " + number_text(lambda_nm.back()) +
                          " nm, have no colour");
}

}  // namespace

ResponseColours response_colours(const ResponseMatrix& response) {
  require_colour(response.lambda_nm);
  std::vector<brdf::Length> wavelengths;
  for (const double nm : response.lambda_nm.values) wavelengths.push_back(brdf::Length::nm(nm));
  const std::vector<brdf::Xyz> weights = brdf::colour_weights(wavelengths);

  ResponseColours colours{std::vector<brdf::Xyz>(response.theta_r_deg.size()), white_of(weights),
                          coverage_of(response.lambda_nm)};
  for (std::size_t row = 0; row < weights.size(); ++row)
    for (std::size_t column = 0; column < colours.xyz.size(); ++column)
      colours.xyz[column] =
          colours.xyz[column] +
          response.values(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) *
              weights[row];
  return colours;
}

ShownColours shown_colours(const std::vector<brdf::Xyz>& colours, RgbSpace space, double exposure) {
  if (!(exposure > 0 && std::isfinite(exposure)))
    throw brdf::Error(brdf::Errc::invalid_argument,
                      "exposure " + brdf::text(exposure) + " must be > 0 and finite");
  ShownColours shown;
  for (const brdf::Xyz& colour : colours) {
    const brdf::Xyz exposed = exposure * colour;
    const brdf::InGamut inside = clipped_to_gamut(
        space == RgbSpace::srgb ? brdf::linear_srgb(exposed) : brdf::cie_rgb(exposed));
    shown.rgb.push_back(space == RgbSpace::srgb ? srgb_encoded(inside.rgb) : inside.rgb);
    if (inside.clipped) ++shown.clipped;
  }
  return shown;
}

std::string to_csv(const Axis& theta_r_deg, const std::vector<brdf::Xyz>& xyz,
                   const std::vector<brdf::Rgb>& rgb) {
  std::string csv = "theta_r_deg,X,Y,Z,R,G,B\n";
  for (std::size_t i = 0; i < theta_r_deg.size(); ++i) {
    csv += number_text(theta_r_deg[i], theta_r_deg.decimals);
    for (const double value : {xyz[i].x, xyz[i].y, xyz[i].z, rgb[i].r, rgb[i].g, rgb[i].b})
      csv.append(",").append(number_text(value));
    csv += "\n";
  }
  return csv;
}

}  // namespace evaluation
