// Profiles of gratings, by formula.
#pragma once

#include <algorithm>
#include <cmath>

#include "brdf/error.h"
#include "brdf/units.h"

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

/// Integral of profile_height over positions from 0 to `phase`, 0 <= phase <= 1, in periods.
inline double profile_integral(const ProfileParameters& p, double phase) {
  switch (p.profile) {
    case Profile::flat:
      return 0;
    case Profile::sinusoid:
      return phase / 2 + std::sin(2 * pi * phase) / (4 * pi);
    case Profile::blazed:
      return p.facing == Facing::plus_x ? phase - phase * phase / 2 : phase * phase / 2;
    case Profile::lamellar:
      return std::min(phase, p.duty);
    case Profile::triangle:
      return phase < 0.5 ? phase * (1 - phase) : 0.5 - phase * (1 - phase);
  }
  return 0;
}

/// Throws Errc::invalid_argument for a period or height that is not positive, or a duty outside
/// (0, 1); a flat profile has none of them.
inline void require_valid(const ProfileParameters& p) {
  if (p.profile == Profile::flat) return;
  if (!(p.period.um() > 0 && std::isfinite(p.period.um())))
    throw Error(Errc::invalid_argument, "period " + text(p.period.um()) + " um must be > 0");
  if (!(p.height.um() > 0 && std::isfinite(p.height.um())))
    throw Error(Errc::invalid_argument, "height " + text(p.height.um()) + " um must be > 0");
  if (!(p.duty > 0 && p.duty < 1))
    throw Error(Errc::invalid_argument, "duty " + text(p.duty) + " must lie between 0 and 1");
}

}  // namespace brdf
