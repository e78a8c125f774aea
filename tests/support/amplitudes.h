// Short ways from a method and a geometry to amplitudes.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "brdf/amplitude.h"
#include "brdf/directions.h"
#include "tests/support/worst_error.h"

using Amplitudes = std::vector<std::complex<double>>;

/// The query in the plane of incidence y = 0 with signed angles.
inline brdf::Query query_in_plane(brdf::Angle theta_i, brdf::Angle theta_r,
                                  brdf::Length wavelength) {
  return query(brdf::direction(theta_i, {}), brdf::direction(theta_r, {}), wavelength);
}

/// Where order m of a grating along x lies, at a given |c|.
inline brdf::Query order_query(int order, double period_um, double c_per_um) {
  return {-2 * brdf::pi * order / period_um, 0, -c_per_um};
}

/// Bounds of so many queries that a table is worth while.
inline brdf::QueryBounds many(std::span<const brdf::Query> queries, double tolerance) {
  brdf::QueryBounds bounds = brdf::bounds_of(queries, tolerance);
  bounds.count = 10'000'000;
  return bounds;
}

template <class Plan>
Amplitudes amplitudes_of(const Plan& plan, std::span<const brdf::Query> queries) {
  Amplitudes result(queries.size());
  plan.evaluate(queries, result);
  return result;
}

/// NaN if any amplitude is, or if there are none.
inline double largest_difference(const Amplitudes& a, const Amplitudes& b) {
  WorstError worst;
  for (std::size_t i = 0; i < a.size(); ++i) worst.see(std::abs(a[i] - b[i]));
  return worst.value();
}

template <class Method>
Amplitudes amplitudes(const Method& method, const brdf::Surface& surface,
                      const std::vector<brdf::Query>& queries, double tolerance = 2e-14) {
  Amplitudes result(queries.size());
  method.plan(surface, brdf::bounds_of(queries, tolerance)).evaluate(queries, result);
  return result;
}

template <class Method>
std::complex<double> amplitude(const Method& method, const brdf::Surface& surface,
                               const brdf::Query& query, double tolerance = 2e-14) {
  return amplitudes(method, surface, {query}, tolerance).front();
}
