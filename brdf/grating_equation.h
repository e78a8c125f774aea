// Where the orders of a grating lie.
#pragma once

#include <cmath>
#include <optional>

#include "brdf/error.h"
#include "brdf/units.h"

namespace brdf {

/// Signed viewing angle of an order in the plane of incidence, positive on the light's side:
/// sin theta_r = m lambda / d - sin theta_i (Thesis Algorithm 2.1). Empty where the order is
/// evanescent.
///
/// order: any integer, 0 the mirror direction. period, wavelength: > 0, else
/// Errc::invalid_argument.
inline std::optional<Angle> viewing_angle(int order, Length period, Length wavelength,
                                          Angle theta_i) {
  if (!(period.um() > 0))
    throw Error(Errc::invalid_argument, "period " + text(period.um()) + " um must be > 0");
  if (!(wavelength.um() > 0))
    throw Error(Errc::invalid_argument, "wavelength " + text(wavelength.um()) + " um must be > 0");
  if (!std::isfinite(theta_i.rad()))
    throw Error(Errc::invalid_argument, "angle of incidence must be finite");
  const double sine = order * wavelength.um() / period.um() - std::sin(theta_i.rad());
  if (!(std::abs(sine) <= 1)) return std::nullopt;
  return Angle::rad(std::asin(sine));
}

/// Period d = m lambda / (sin theta_i + sin theta_r) that puts an order at a viewing angle. Empty
/// where no positive period does (the angle lies on the other side of the mirror direction, or on
/// it). wavelength: > 0, else Errc::invalid_argument.
inline std::optional<Length> period_from_angle(int order, Length wavelength, Angle theta_i,
                                               Angle theta_r) {
  if (!(wavelength.um() > 0))
    throw Error(Errc::invalid_argument, "wavelength " + text(wavelength.um()) + " um must be > 0");
  const double sines = std::sin(theta_i.rad()) + std::sin(theta_r.rad());
  const double period_um = order * wavelength.um() / sines;
  if (!(period_um > 0 && std::isfinite(period_um))) return std::nullopt;
  return Length::um(period_um);
}

}  // namespace brdf
