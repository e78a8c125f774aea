// The colour that a response has at each viewing angle.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "brdf/colour.h"
#include "evaluation/response_matrix.h"

namespace evaluation {

/// How well the wavelengths of a response cover what the eye sees.
struct SpectralCoverage {
  double first_nm = 0, last_nm = 0;
  double largest_step_nm = 0;  ///< of the steps that reach into 380 to 780 nm

  /// 400 to 700 nm, outside which lie 0.03 % of Y and 0.2 % of X and Z of the white.
  bool spans_visible() const { return first_nm <= 400 && last_nm >= 700; }
  /// Steps up to 10 nm: the white is then within 7e-4 of D65 in x and y.
  bool is_fine() const { return largest_step_nm <= 10 * (1 + 1e-9); }
};

SpectralCoverage coverage_of(const Axis& lambda_nm);

/// Colours under D65, one for each viewing angle.
struct ResponseColours {
  std::vector<brdf::Xyz> xyz;
  brdf::Xyz white;  ///< what rho = 1 has at these wavelengths: Y = 1
  SpectralCoverage coverage;
};

/// The colours of a relative reflectance rho: X = sum over wavelengths of weight.x rho, with the
/// weights of `brdf::colour_weights`; Y = 1 for rho = 1, and not bounded by 1 as rho is not.
///
/// Throws Errc::bad_input for fewer than 2 wavelengths, and where none lies in 380 to 780 nm.
/// What covers the visible badly has a colour all the same, and `coverage` says so.
ResponseColours response_colours(const ResponseMatrix& response);

enum class RgbSpace {
  srgb,  ///< IEC 61966-2-1, with its transfer curve
  cie,   ///< CIE RGB of the sources, linear
};

/// Colours as they are shown, each component 0 to 1.
struct ShownColours {
  std::vector<brdf::Rgb> rgb;
  std::size_t clipped = 0;  ///< how many did not fit (`brdf::clipped_to_gamut`)
};

/// Colours times the exposure, in a space, clipped, and for sRGB through the transfer curve.
///
/// exposure: factor of the light, > 0. Throws Errc::invalid_argument otherwise.
ShownColours shown_colours(const std::vector<brdf::Xyz>& colours, RgbSpace space, double exposure);

/// theta_r_deg,X,Y,Z,R,G,B: colours of a response's angles without exposure, and as shown.
std::string to_csv(const Axis& theta_r_deg, const std::vector<brdf::Xyz>& xyz,
                   const std::vector<brdf::Rgb>& rgb);

}  // namespace evaluation
