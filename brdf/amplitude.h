// What a method that computes the diffraction amplitude takes, gives and promises.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "brdf/directions.h"
#include "brdf/surface.h"

namespace brdf {

/// One spatial frequency of the surface's transform: (k u, k v, k w) [rad/um].
struct Query {
  double qx_per_um, qy_per_um, c_per_um;
};

/// The query of two directions and a wavelength: k times the scattering vector (Thesis 1.12).
inline Query query(const Direction& omega_i, const Direction& omega_r, Length wavelength) {
  const Eigen::Vector3d q = wavenumber_per_um(wavelength) * scattering_vector(omega_i, omega_r);
  return {q.x(), q.y(), q.z()};
}

/// A line through qx = qy = 0: the plane of incidence at this azimuth. A unit vector.
struct LineDirection {
  double cos_azimuth, sin_azimuth;
};

/// Everything a request will ask, known before anything is computed; plans follow from it.
struct QueryBounds {
  Query lo, hi;       ///< the box that all queries lie in
  std::size_t count;  ///< how many queries will come
  double tolerance;   ///< largest error allowed in the normalised amplitude
  /// Where given, all queries lie on this line, to the rounding of k u and k v: methods may use it.
  std::optional<LineDirection> line = std::nullopt;

  double max_abs_c_per_um() const { return std::max(std::abs(lo.c_per_um), std::abs(hi.c_per_um)); }

  /// Throws Errc::invalid_argument for a query outside the box, or one that is not a number.
  void require_holds(const Query& q) const {
    const bool within = lo.qx_per_um <= q.qx_per_um && q.qx_per_um <= hi.qx_per_um &&
                        lo.qy_per_um <= q.qy_per_um && q.qy_per_um <= hi.qy_per_um &&
                        lo.c_per_um <= q.c_per_um && q.c_per_um <= hi.c_per_um;
    if (!within)
      throw Error(Errc::invalid_argument, "query (" + text(q.qx_per_um) + ", " + text(q.qy_per_um) +
                                              ", " + text(q.c_per_um) +
                                              ") rad/um lies outside the bounds of its plan");
  }
};

/// The smallest box around some queries. Throws Errc::invalid_argument where there are none or
/// one is not finite.
inline QueryBounds bounds_of(std::span<const Query> queries, double tolerance) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  if (queries.empty()) throw Error(Errc::invalid_argument, "a request needs at least one query");
  QueryBounds bounds{{inf, inf, inf}, {-inf, -inf, -inf}, queries.size(), tolerance};
  for (const Query& q : queries) {
    if (!(std::isfinite(q.qx_per_um) && std::isfinite(q.qy_per_um) && std::isfinite(q.c_per_um)))
      throw Error(Errc::invalid_argument, "a query is not finite");
    bounds.lo = {std::min(bounds.lo.qx_per_um, q.qx_per_um),
                 std::min(bounds.lo.qy_per_um, q.qy_per_um),
                 std::min(bounds.lo.c_per_um, q.c_per_um)};
    bounds.hi = {std::max(bounds.hi.qx_per_um, q.qx_per_um),
                 std::max(bounds.hi.qy_per_um, q.qy_per_um),
                 std::max(bounds.hi.c_per_um, q.c_per_um)};
  }
  return bounds;
}

/// What a plan knows about itself.
struct PlanReport {
  double error_bound;            ///< of the normalised amplitude, from the method alone
  double input_phase_error_rad;  ///< half a code of the stored heights, times the largest |c|
  int terms;                     ///< of the method's series; 0 where it has none
  double radius_sigma_f;         ///< neighbouring bins kept; 0 where it keeps none
  std::size_t bytes;             ///< held by the plan
};

/// A plan turns queries into normalised amplitudes a = P / Int Int g, the flat patch's peak being
/// 1. `evaluate` is const and may be called from many threads; a[i] depends on q[i] and the plan
/// only.
template <class P>
concept AmplitudePlan = std::movable<P> &&
    requires(const P& plan, std::span<const Query> q, std::span<std::complex<double>> a) {
  { plan.evaluate(q, a) } -> std::same_as<void>;
  { plan.report() } -> std::same_as<PlanReport>;
};

/// A method makes plans, for the surface models it supports. `bytes` says, before anything is
/// allocated, what the plan will hold.
template <class M>
concept AmplitudeMethod = requires(const M& method, const Surface& s, const QueryBounds& b) {
  { M::supports(s.model) } -> std::same_as<bool>;
  { method.plan(s, b) } -> AmplitudePlan;
};

/// Largest phase error [rad] that the spacing of the stored heights allows: |c| step / 2.
inline double input_phase_error_rad(const HeightField& field, const QueryBounds& bounds) {
  return bounds.max_abs_c_per_um() * field.height_step_um() / 2;
}

}  // namespace brdf
