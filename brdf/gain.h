// From the normalised amplitude to what a detector sees: analytic factors of the directions.
#pragma once

#include "brdf/directions.h"
#include "brdf/units.h"

namespace brdf {

/// What one cell of a response holds.
enum class Quantity {
  power,     ///< abs(a)^2, 1 at the peak of a flat patch
  relative,  ///< relative reflectance rho = C abs(a)^2
  brdf,      ///< absolute BRDF f_r [1/sr]
  radiance,  ///< radiance per intensity of the light, L / I [1/sr]
};

/// Gain C of the relative reflectance rho = C abs(a)^2,
/// C = (1 + omega_i . omega_r)^2 / (w^2 cos theta_r) (Thesis 1.13 to 1.16 with F = F_0).
///
/// 1 for a flat patch at normal incidence, cos theta in the mirror direction, 1 / cos^3 theta in
/// the retro direction: not bounded by 1. Both directions in the upper half-space.
inline double relative_gain(const Direction& omega_i, const Direction& omega_r) {
  const double projection = one_plus_cosine(omega_i, omega_r);
  const double w = omega_i.z() + omega_r.z();
  return (projection / w) * (projection / w) / omega_r.z();
}

/// Factor between abs(a)^2 and the BRDF [1/sr]: k^2 G area / (4 pi^2 w^2) with
/// G = (1 + omega_i . omega_r)^2 / (cos theta_i cos theta_r) and F = 1 (Stam; Thesis 1.4, 1.5).
///
/// coherence_area_um2: (Int Int g)^2 / Int Int g^2 of the surface. Symmetric in the directions.
inline double brdf_gain(const Direction& omega_i, const Direction& omega_r, Length wavelength,
                        double coherence_area_um2) {
  const double projection = one_plus_cosine(omega_i, omega_r);
  const double w = omega_i.z() + omega_r.z();
  const double lambda_um = wavelength.um();
  return (projection / w) * (projection / w) / (omega_i.z() * omega_r.z()) * coherence_area_um2 /
         (lambda_um * lambda_um);
}

/// Factor between abs(a)^2 and L / I [1/sr], the radiance per intensity of the light (its
/// irradiance on a plane that faces it): L = f_r I cos theta_i, so
/// (1 + omega_i . omega_r)^2 area / (lambda^2 w^2 cos theta_r) with F = 1 (Thesis 1.5, 1.10).
///
/// coherence_area_um2: as for `brdf_gain`.
inline double radiance_gain(const Direction& omega_i, const Direction& omega_r, Length wavelength,
                            double coherence_area_um2) {
  const double lambda_um = wavelength.um();
  return relative_gain(omega_i, omega_r) * coherence_area_um2 / (lambda_um * lambda_um);
}

}  // namespace brdf
