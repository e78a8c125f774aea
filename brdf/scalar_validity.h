// How deep a grating may be for scalar diffraction theory to keep the strengths of its orders.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "brdf/error.h"
#include "brdf/units.h"

namespace brdf {

/// Where a grating lies in the table of rigorous limits.
enum class TablePlace {
  below,   ///< period under 1.63 wavelengths: no strength is right
  inside,  ///< between tabulated periods
  beyond,  ///< period over 6.13 wavelengths: the last row is the guide
};

/// What lies above a limit.
enum class LimitKind {
  measured,  ///< the error was seen to grow above 0.02
  untested,  ///< the error was below 0.02 up to the deepest grating that was computed
};

/// Largest depth / lambda with scalar strengths within 0.02 of the rigorous ones.
struct ScalarLimit {
  double depth_over_lambda;  ///< 0 below the table
  TablePlace place;
  LimitKind kind;
  Angle theta_i;  ///< tabulated angle used; 75 deg stands for what is beyond
};

namespace detail {

struct ScalarLimitRow {
  double period_over_lambda, deepest_tested;
  std::array<double, 4> depth_over_lambda;  ///< at scalar_limit_angles_deg
};

inline constexpr std::array scalar_limit_angles_deg{0.0, 30.0, 60.0, 75.0};

/// Rigorous efficiencies of perfectly conducting sinusoids, the mean of both polarisations, against
/// the scalar e = g |a|^2, g = cos^2((ti + tr) / 2) / (cos ti cos tr cos^2((ti - tr) / 2)): largest
/// h0 / lambda, h0 peak to valley, up to which they differ by at most 0.02. Computed outside this
/// code; the whole table is tests/oracles/scalar_validity.txt, column "e=g|a|^2 vs unpol".
inline constexpr std::array<ScalarLimitRow, 6> scalar_limits{{
    {1.63, 0.228, {0.228, 0.069, 0.074, 0.047}},
    {2.21, 0.310, {0.310, 0.229, 0.111, 0.060}},
    {2.86, 0.401, {0.374, 0.401, 0.212, 0.071}},
    {3.57, 0.500, {0.500, 0.269, 0.346, 0.087}},
    {4.55, 0.637, {0.637, 0.546, 0.193, 0.102}},
    {6.13, 0.859, {0.859, 0.706, 0.134, 0.134}},
}};

/// Indices of the values around one: the same twice where it is tabulated or outside.
struct Neighbours {
  std::size_t first, last;
};

template <std::size_t n>
Neighbours neighbours(const std::array<double, n>& rising, double value) {
  const auto above = static_cast<std::size_t>(
      std::lower_bound(rising.begin(), rising.end(), value) - rising.begin());
  if (above == n) return {n - 1, n - 1};
  if (above == 0 || rising[above] == value) return {above, above};
  return {above - 1, above};
}

}  // namespace detail

/// The limit for a period and an angle of incidence: the smallest of the tabulated neighbours.
///
/// The table does not rise evenly with period or angle (orders pass the horizon), so that no single
/// neighbour is the safe one. |theta_i| beyond 75 deg counts as 75.
/// period_over_lambda: > 0, else Errc::invalid_argument.
inline ScalarLimit scalar_limit(double period_over_lambda, Angle theta_i) {
  if (!(period_over_lambda > 0))
    throw Error(Errc::invalid_argument,
                "period / wavelength " + text(period_over_lambda) + " must be > 0");
  const auto& rows = detail::scalar_limits;
  std::array<double, rows.size()> periods{};
  std::transform(rows.begin(), rows.end(), periods.begin(),
                 [](const detail::ScalarLimitRow& row) { return row.period_over_lambda; });
  const auto angles = detail::neighbours(detail::scalar_limit_angles_deg, std::abs(theta_i.deg()));
  const Angle tabulated = Angle::deg(detail::scalar_limit_angles_deg[angles.last]);
  if (period_over_lambda < periods.front())
    return {0, TablePlace::below, LimitKind::measured, tabulated};

  const auto around = detail::neighbours(periods, period_over_lambda);
  ScalarLimit limit{std::numeric_limits<double>::infinity(),
                    period_over_lambda > periods.back() ? TablePlace::beyond : TablePlace::inside,
                    LimitKind::measured, tabulated};
  for (std::size_t row = around.first; row <= around.last; ++row)
    for (std::size_t angle = angles.first; angle <= angles.last; ++angle)
      if (rows[row].depth_over_lambda[angle] < limit.depth_over_lambda) {
        limit.depth_over_lambda = rows[row].depth_over_lambda[angle];
        limit.kind = limit.depth_over_lambda < rows[row].deepest_tested ? LimitKind::measured
                                                                        : LimitKind::untested;
      }
  return limit;
}

/// Whether scalar strengths can be trusted.
enum class ScalarVerdict { valid, doubtful, invalid };

/// The verdict on a grating whose depth lies between `shallowest` and `deepest` peak to valley, as
/// two estimates of it say: valid where the deepest keeps the limit, invalid where the shallowest
/// does not, or the period is below the table. Doubtful between, deeper than was tested, and beyond
/// the table, where deeper gratings may be right.
inline ScalarVerdict scalar_verdict(const ScalarLimit& limit, double shallowest_over_lambda,
                                    double deepest_over_lambda) {
  if (limit.place == TablePlace::below) return ScalarVerdict::invalid;
  if (deepest_over_lambda <= limit.depth_over_lambda) return ScalarVerdict::valid;
  if (limit.place == TablePlace::inside && limit.kind == LimitKind::measured &&
      shallowest_over_lambda > limit.depth_over_lambda)
    return ScalarVerdict::invalid;
  return ScalarVerdict::doubtful;
}

}  // namespace brdf
