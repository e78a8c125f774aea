// The viewing angle of the brightest response, wavelength by wavelength.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brdf/units.h"
#include "evaluation/response_matrix.h"

namespace evaluation {

/// The plane of incidence, and what is known of the illumination.
struct PlaneOfIncidence {
  brdf::Angle theta_i;
  double light_side = 1;  ///< +1 where theta_r > 0 lies on the light's side, -1 opposite to it
  std::optional<double> sigma_f_per_um;  ///< of the coherence window

  /// sin theta_i + sin theta_r = m lambda / d, for a response's angle.
  double sines(double theta_r_deg) const;
};

/// The plane of incidence for two azimuths.
///
/// Throws Errc::invalid_argument where they are neither equal nor opposite: the grating equation
/// then does not hold along the sweep. Equal to within 1e-9 deg, the rounding of azimuths up to
/// some turns.
PlaneOfIncidence plane_of_incidence(brdf::Angle theta_i, brdf::Angle phi_i, brdf::Angle phi_r);

/// Half the width of the order 0 [sigma_f] that is kept out of the search for others: the window's
/// transform there is 1.5e-8 of its peak.
inline constexpr double mirror_radius_sigma_f = 6;

enum class Refinement {
  grid,      ///< the brightest cell, as the sources do
  parabola,  ///< the vertex of a parabola through the logarithms of the brightest three cells, over
             ///< sin theta: exact for a Gaussian lobe
};

/// Where an order is looked for.
struct PeakSearch {
  int order = 1;
  std::optional<brdf::Length> period_guess;  ///< within half an order of where this period puts it
  std::optional<std::pair<brdf::Length, brdf::Length>> period_range;  ///< only these periods
  std::optional<std::pair<double, double>> theta_r_deg;               ///< only these angles
  Refinement refinement = Refinement::parabola;
  double floor = 0;  ///< a maximum must be above it: what the error of the response could make
};

/// One wavelength. `theta_r_deg` is empty where the window holds no maximum in its inside.
struct Peak {
  double lambda_nm;
  std::optional<double> theta_r_deg;  ///< refined
  double grid_theta_r_deg = 0;        ///< of the brightest cell
  double value = 0;                   ///< at the brightest cell
};

/// The peaks of all wavelengths, one each, in the order of the rows.
///
/// An order other than 0 is looked for on its own side of the mirror direction only, and outside
/// of 6 sigma_f around it where the coherence window is known: there the order 0 shines. A maximum
/// on the edge of the window is no peak. Throws Errc::invalid_argument for a guess or a range that
/// is not positive.
std::vector<Peak> find_peaks(const ResponseMatrix& response, const PlaneOfIncidence& plane,
                             const PeakSearch& search);

/// m lambda / (sin theta_i + sin theta_r) [nm]; empty for order 0.
std::optional<double> period_nm(const PlaneOfIncidence& plane, int order, double lambda_nm,
                                double theta_r_deg);

/// lambda_nm,order,theta_peak_deg,value,period_nm; the last three empty where there is no peak.
std::string to_csv(const std::vector<Peak>& peaks, const PlaneOfIncidence& plane, int order,
                   const ResponseMatrix& response);

}  // namespace evaluation
