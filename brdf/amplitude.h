// What a method that computes the diffraction amplitude takes, gives and promises.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
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

/// The query of a scattering vector: k times it.
inline Query query(const Eigen::Vector3d& scattering, double k_per_um) {
  const Eigen::Vector3d q = k_per_um * scattering;
  return {q.x(), q.y(), q.z()};
}

/// The query of two directions and a wavelength (Thesis 1.12).
inline Query query(const Direction& omega_i, const Direction& omega_r, Length wavelength) {
  return query(scattering_vector(omega_i, omega_r), wavenumber_per_um(wavelength));
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

  /// Whether the box holds a query; no for one that is not a number.
  bool hold(const Query& q) const {
    return lo.qx_per_um <= q.qx_per_um && q.qx_per_um <= hi.qx_per_um &&
           lo.qy_per_um <= q.qy_per_um && q.qy_per_um <= hi.qy_per_um &&
           lo.c_per_um <= q.c_per_um && q.c_per_um <= hi.c_per_um;
  }
  /// Throws Errc::invalid_argument naming a query that it does not.
  void require_holds(const Query& q) const {
    if (!hold(q))
      throw Error(Errc::invalid_argument, "query (" + text(q.qx_per_um) + ", " + text(q.qy_per_um) +
                                              ", " + text(q.c_per_um) +
                                              ") rad/um lies outside the bounds of its plan");
  }
};

/// The smallest box around some queries. Throws Errc::invalid_argument where there are none or
/// one is not finite.
inline QueryBounds bounds_of(std::span<const Query> queries, double tolerance) {
  if (queries.empty()) throw Error(Errc::invalid_argument, "a request needs at least one query");
  // Two queries fill whole vectors of any instruction set.
  static_assert(sizeof(Query) == 3 * sizeof(double));
  using Pair = Eigen::Array<double, 6, 1>;
  const Eigen::Map<const Eigen::Array3Xd> all(&queries.front().qx_per_um, 3,
                                              static_cast<Eigen::Index>(queries.size()));
  const Eigen::Array3d last = all.rightCols<1>();
  Pair lo, hi, nothing = Pair::Zero();  // NaN where one is not finite
  lo << last, last;
  hi = lo;
  for (Eigen::Index i = 0; i + 2 <= all.cols(); i += 2) {
    const Pair pair = Eigen::Map<const Pair>(all.col(i).data());
    lo = lo.min(pair);
    hi = hi.max(pair);
    nothing += 0 * pair;
  }
  if (!((nothing == 0).all() && last.isFinite().all()))
    throw Error(Errc::invalid_argument, "a query is not finite");
  const auto query = [](const Eigen::Array3d& q) { return Query{q(0), q(1), q(2)}; };
  return {query(lo.head<3>().min(lo.tail<3>())), query(hi.head<3>().max(hi.tail<3>())),
          queries.size(), tolerance};
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
