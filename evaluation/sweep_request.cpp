#include "evaluation/sweep_request.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

namespace evaluation {
namespace {

/// The line that all queries lie on where the viewer moves in the plane of incidence. Empty where
/// they miss it by more than the rounding of k u and k v: azimuths of many turns are rounded more.
std::optional<brdf::LineDirection> line_through(const SweepRequest& request,
                                                std::span<const brdf::Query> queries,
                                                double largest_c_per_um) {
  const brdf::Direction along = brdf::direction(brdf::Angle::deg(45), request.phi_r);
  const double length = std::hypot(along.x(), along.y());
  const brdf::LineDirection line{along.x() / length, along.y() / length};
  double largest_q_per_um = 0, off_per_um = 0;
  for (const brdf::Query& q : queries) {
    largest_q_per_um = std::max(largest_q_per_um, std::hypot(q.qx_per_um, q.qy_per_um));
    off_per_um = std::max(
        off_per_um, std::abs(q.qy_per_um * line.cos_azimuth - q.qx_per_um * line.sin_azimuth));
  }
  const double rounding =
      2 * std::numeric_limits<double>::epsilon() * (largest_q_per_um + largest_c_per_um);
  if (!(off_per_um <= rounding)) return std::nullopt;
  return line;
}

}  // namespace

brdf::Query query(const brdf::Direction& omega_i, const brdf::Direction& omega_r,
                  brdf::Length wavelength, DepthFrequency depth) {
  brdf::Query query = brdf::query(omega_i, omega_r, wavelength);
  if (depth == DepthFrequency::unit_w) query.c_per_um = -brdf::wavenumber_per_um(wavelength);
  return query;
}

std::vector<brdf::Direction> viewing_directions(const SweepRequest& request) {
  std::vector<brdf::Direction> directions;
  for (std::size_t j = 0; j < request.theta_r_deg.size(); ++j)
    directions.push_back(request.omega_r(j));
  return directions;
}

void require_valid(const SweepRequest& request) {
  const auto refuse = [](const char* what, double value, const char* limit) {
    throw brdf::Error(brdf::Errc::invalid_argument,
                      std::string(what) + " " + number_text(value) + " " + limit);
  };
  if (!(std::abs(request.theta_i.deg()) < 90))
    refuse("incidence angle", request.theta_i.deg(), "deg must lie between -90 and 90 deg");
  for (const double theta : {request.theta_r_deg.front(), request.theta_r_deg.back()})
    if (!(std::abs(theta) < 90))
      refuse("viewing angle", theta, "deg must lie between -90 and 90 deg");
  if (!(request.lambda_nm.front() > 0 && std::isfinite(request.lambda_nm.back())))
    refuse("wavelength", request.lambda_nm.front(), "nm must be > 0");
}

std::vector<brdf::Query> queries_of_row(const SweepRequest& request, std::size_t row) {
  std::vector<brdf::Query> queries;
  for (const brdf::Direction& omega_r : viewing_directions(request))
    queries.push_back(query(request.omega_i(), omega_r, request.wavelength(row), request.depth));
  return queries;
}

brdf::QueryBounds bounds_of(const SweepRequest& request, double tolerance) {
  // Every component of a query is k times a function of the angle alone, so the extremes lie at
  // the first and the last wavelength.
  std::vector<brdf::Query> extremes = queries_of_row(request, 0);
  const std::vector<brdf::Query> last = queries_of_row(request, request.lambda_nm.size() - 1);
  extremes.insert(extremes.end(), last.begin(), last.end());
  brdf::QueryBounds bounds = brdf::bounds_of(extremes, tolerance);
  bounds.count = request.cells();
  bounds.line = line_through(request, extremes, bounds.max_abs_c_per_um());
  return bounds;
}

std::optional<NyquistExcess> nyquist_excess(const SweepRequest& request,
                                            const brdf::HeightField& field) {
  NyquistExcess excess{request.lambda_nm.front(), std::nullopt};
  bool exceeded = false;
  const std::vector<brdf::Query> queries = queries_of_row(request, 0);
  for (std::size_t j = 0; j < queries.size(); ++j) {
    if (is_beyond_nyquist(queries[j], field)) {
      exceeded = true;
      continue;
    }
    const double theta = request.theta_r_deg[j];
    excess.safe_deg = {excess.safe_deg ? excess.safe_deg->first : theta, theta};
  }
  if (!exceeded) return std::nullopt;
  return excess;
}

}  // namespace evaluation
