// The slope of phases over lines whose disorder is not known beforehand.
#pragma once

#include "evaluation/period/line_phases.h"

namespace evaluation {

/// An interval that holds the truth with the probability stated where it was made.
struct Interval {
  double lo, hi;

  bool holds(double value) const { return lo <= value && value <= hi; }
  double width() const { return hi - lo; }
  bool overlaps(const Interval& other) const { return lo <= other.hi && other.lo <= hi; }
};

/// Change of phase per line [rad].
struct SlopePosterior {
  double median;
  Interval interval;         ///< 95 %
  double independent_std;    ///< standard error were the lines' places independent
  double accumulated_std;    ///< and were their distances independent, so that places drift
  double accumulated_share;  ///< probability that distances vary, and places drift
  double bowed_share;        ///< probability that places lie on a bow, as a scanner makes it
};

/// Fewer lines say nothing about their own disorder.
inline constexpr std::size_t least_lines = 5;

/// Line i has the phase a + b i + e_i. How the e_i hang together decides how well b is known:
/// independent places (disorder of the first kind, noise) make b right to 12^(1/2) n^(-3/2), and
/// independent distances (of the second kind, a drifting scanner) to n^(-1/2). The data tell which,
/// but not surely, so these and a scanner's bow, a parabola that leaves the slope in the middle as
/// it is, are kept with the probability that the data leave each: the restricted likelihood of a
/// Gaussian process with the covariance R + rho K + b^2 q q^T, times a prior (0.55 independent;
/// 0.33 drifting, rho = 3, 30, 300; 0.12 bowed, b = 3, 10, 30). q: the parabola, 1 at the ends; R:
/// overlap of the windows of line_phases, and once 1.5 times as wide; K: Brownian motion seen
/// through that window. Given a covariance b follows Student's t with n - 2 degrees of freedom; the
/// interval is from the 2.5 % to the 97.5 % quantile of the mixture.
///
/// Coverage over 500 gratings of 41 lines for each of three kinds of disorder, 92 to 98 %:
/// surface_periods.tests.cpp. With fewer than some 20 lines the two kinds are hard to tell, and
/// drift is covered less. Throws Errc::not_attainable below `least_lines`. Cost: 14 Cholesky
/// factors of n x n.
SlopePosterior slope_posterior(const LinePhases& phases);

}  // namespace evaluation
