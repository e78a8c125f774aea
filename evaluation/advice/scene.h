// What advice is asked about: a surface, its light and its viewer; and what is measured of them.
#pragma once

#include <optional>
#include <vector>

#include "brdf/surface.h"
#include "evaluation/dominant_periods.h"
#include "evaluation/sweep_request.h"

namespace evaluation {

/// Where an axis of a scene comes from.
enum class AxisOrigin {
  asked,    ///< the user's
  assumed,  ///< all there is: the hemisphere, visible light
};

struct AdviceScene {
  brdf::Surface surface;  ///< its heights as the sweep would take them
  SweepRequest request;
  AxisOrigin theta_r_origin, lambda_origin;
  double tolerance;        ///< of the amplitude, > 0
  brdf::Angle resolution;  ///< of the viewer, > 0

  const brdf::HeightField& heights() const { return *surface.heights; }
  double shortest_um() const { return request.wavelength(0).um(); }
  double longest_um() const { return request.wavelength(request.lambda_nm.size() - 1).um(); }
  /// The viewing angle nearest to the mirror direction -theta_i.
  brdf::Angle nearest_to_mirror() const;
  /// The viewing angle nearest to the normal, where lobes are narrowest.
  brdf::Angle nearest_to_normal() const;
  /// Largest abs(u) = abs(sin theta_i + sin theta_r) in the plane of incidence.
  double largest_abs_u() const;
  /// Largest abs(w) = cos theta_i + cos theta_r.
  double largest_abs_w() const;
  /// abs(w) at the viewing angle nearest to the mirror direction.
  double mirror_abs_w() const;
};

/// Throws Errc::invalid_argument naming an angle, a wavelength, a tolerance or a resolution that
/// has no meaning. The viewer moves in the plane of incidence.
void require_valid(const AdviceScene& scene);

/// What is measured once of a surface, less its least-squares plane.
struct SurfaceMeasures {
  brdf::HeightField levelled;
  double peak_to_valley_um, rms_um, rms_slope;
  std::optional<double> correlation_length_um;  ///< empty: flat, or longer than a quarter
  std::vector<HeightPeriod> periods;
};
SurfaceMeasures measured(const brdf::HeightField& heights);

/// Full width at half maximum of a lobe's power in the sine of the angle, along an azimuth:
/// lambda q / pi with q of `lobe_half_width_per_um`.
double lobe_width_sine(const brdf::Surface& surface, brdf::Angle azimuth, double lambda_um);

/// Effective coherent length along an azimuth [um]: lambda over the lobe's width, pi / q; of a
/// Gaussian window 3.77 sigma, of an even length L 1.13 L. As many orders of a period d fit between
/// two lobes as it holds periods.
double coherence_length_um(const brdf::Surface& surface, brdf::Angle azimuth);

}  // namespace evaluation
