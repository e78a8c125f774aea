// A grating vector as a spatial frequency.
#pragma once

#include <cmath>

#include "brdf/units.h"

namespace evaluation {

/// Cycles per micrometre along x and y: the grating vector over 2 pi. A frequency and its negative
/// are the same grating.
struct Frequency {
  double x_per_um = 0, y_per_um = 0;

  double length_per_um() const { return std::hypot(x_per_um, y_per_um); }
  brdf::Length period() const { return brdf::Length::um(1 / length_per_um()); }
  /// Of the grating vector, in (-90, 90] deg.
  brdf::Angle azimuth() const {
    double degrees = brdf::Angle::rad(std::atan2(y_per_um, x_per_um)).deg();
    if (degrees > 90) degrees -= 180;
    if (degrees <= -90) degrees += 180;
    return brdf::Angle::deg(degrees + 0.0);  // no -0
  }
  Frequency operator-() const { return {-x_per_um, -y_per_um}; }
  Frequency operator*(double factor) const { return {factor * x_per_um, factor * y_per_um}; }
};

inline double distance_per_um(const Frequency& a, const Frequency& b) {
  return std::hypot(a.x_per_um - b.x_per_um, a.y_per_um - b.y_per_um);
}

}  // namespace evaluation
