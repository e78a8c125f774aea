// Gratings made by formula, periodic along x.
#pragma once

#include <cmath>

#include "brdf/height_field.h"

namespace brdf {

enum class Profile { flat, sinusoid, blazed, lamellar, triangle };

/// Which way the height of an asymmetric profile falls. A blaze falling in +x sends light into
/// order +1.
enum class Facing { plus_x, minus_x };

struct ProfileParameters {
  Profile profile = Profile::blazed;
  Length period = Length::um(1);
  Length height = {};  ///< peak to valley
  double duty = 0.5;   ///< lamellar: part of the period that is high, 0 < duty < 1
  Facing facing = Facing::plus_x;
};

/// Height [0, 1] of a profile at the position t in periods, any real number.
///
/// sinusoid (1 + cos 2 pi t) / 2; blazed 1 - frac(t), facing -x frac(t); lamellar 1 where
/// frac(t) < duty; triangle 1 at t = 0, 0 at 1/2. A t within 1e-9 below a whole number counts as
/// that number: positions are products of decimals and carry rounding.
inline double profile_height(const ProfileParameters& p, double t) {
  double phase = t - std::floor(t);
  if (1 - phase < 1e-9) phase = 0;
  switch (p.profile) {
    case Profile::flat:
      return 0;
    case Profile::sinusoid:
      return (1 + std::cos(2 * pi * phase)) / 2;
    case Profile::blazed:
      return p.facing == Facing::plus_x ? 1 - phase : phase;
    case Profile::lamellar:
      return phase < p.duty ? 1 : 0;
    case Profile::triangle:
      return std::abs(1 - 2 * phase);
  }
  return 0;
}

/// A grating sampled at the pixel centres, phase 0 at x = 0 (the middle of the patch).
///
/// Throws Errc::invalid_argument for a period or height that is not positive, a duty outside
/// (0, 1), or an empty grid.
inline HeightField synthetic_grating(const ProfileParameters& p, Eigen::Index rows,
                                     Eigen::Index cols, Length pixel_x, Length pixel_y) {
  if (p.profile != Profile::flat) {
    if (!(p.period.um() > 0 && std::isfinite(p.period.um())))
      throw Error(Errc::invalid_argument, "period " + text(p.period.um()) + " um must be > 0");
    if (!(p.height.um() > 0 && std::isfinite(p.height.um())))
      throw Error(Errc::invalid_argument, "height " + text(p.height.um()) + " um must be > 0");
    if (!(p.duty > 0 && p.duty < 1))
      throw Error(Errc::invalid_argument, "duty " + text(p.duty) + " must lie between 0 and 1");
  }
  HeightArray heights_um(rows, cols);
  const double origin = static_cast<double>(cols - 1) / 2;
  for (Eigen::Index col = 0; col < cols; ++col)
    heights_um.col(col) = p.height.um() * profile_height(p, (static_cast<double>(col) - origin) *
                                                                pixel_x.um() / p.period.um());
  return HeightField(std::move(heights_um), pixel_x, pixel_y);
}

}  // namespace brdf
