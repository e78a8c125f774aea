// Directions at a surface and the scattering vector: the only place where their signs are set.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "brdf/error.h"
#include "brdf/units.h"

namespace brdf {

/// Unit vector away from the surface; z is the mean surface normal, x runs along the columns of
/// the height field, y along its rows as stored.
using Direction = Eigen::Vector3d;

/// The direction (sin theta cos phi, sin theta sin phi, cos theta).
///
/// theta: angle from the normal, |theta| < 90 deg; a negative theta lies at the azimuth phi + 180
///        deg (the signed viewing angle).
/// phi:   azimuth from +x towards +y, any finite value.
/// Sines and cosines of phi below the rounding of phi itself are exactly zero, so that multiples of
/// 90 deg lie in the coordinate planes.
/// Throws Errc::invalid_argument where theta is not inside (-90, 90) deg or phi is not finite.
inline Direction direction(Angle theta, Angle phi) {
  if (!(std::abs(theta.rad()) < pi / 2))
    throw Error(Errc::invalid_argument,
                "polar angle " + text(theta.deg()) + " deg must lie between -90 and 90 deg");
  if (!std::isfinite(phi.rad())) throw Error(Errc::invalid_argument, "azimuth must be finite");
  const double rounding =
      std::numeric_limits<double>::epsilon() * std::max(1.0, std::abs(phi.rad()));
  const auto snapped = [rounding](double component) {
    return std::abs(component) < rounding ? 0.0 : component;
  };
  const double sin_theta = std::sin(theta.rad());
  return {sin_theta * snapped(std::cos(phi.rad())), sin_theta * snapped(std::sin(phi.rad())),
          std::cos(theta.rad())};
}

/// Scattering vector (u, v, w) = -omega_i - omega_r (Thesis 1.12); w <= 0.
inline Eigen::Vector3d scattering_vector(const Direction& omega_i, const Direction& omega_r) {
  return -(omega_i + omega_r);
}

/// 1 + omega_i . omega_r as |omega_i + omega_r|^2 / 2, which does not cancel at grazing angles.
inline double one_plus_cosine(const Direction& omega_i, const Direction& omega_r) {
  return (omega_i + omega_r).squaredNorm() / 2;
}

}  // namespace brdf
