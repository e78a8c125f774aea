// What a sweep asks for: the geometry, the wavelengths and their queries.
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "brdf/amplitude.h"
#include "brdf/directions.h"
#include "evaluation/axis.h"

namespace evaluation {

/// Where the third frequency of a query comes from.
enum class DepthFrequency {
  scattering_vector,  ///< c = k w
  unit_w,             ///< c = -k, as in the sources' evaluator (Erratum E13)
};

/// The query of two directions and a wavelength.
brdf::Query query(const brdf::Direction& omega_i, const brdf::Direction& omega_r,
                  brdf::Length wavelength, DepthFrequency depth);

/// Light from one direction, the viewer on a half-circle through the normal.
struct SweepRequest {
  brdf::Angle theta_i, phi_i;
  brdf::Angle phi_r;  ///< azimuth of the half-plane where theta_r is positive
  Axis lambda_nm;
  Axis theta_r_deg;
  DepthFrequency depth = DepthFrequency::scattering_vector;

  brdf::Direction omega_i() const { return brdf::direction(theta_i, phi_i); }
  brdf::Direction omega_r(std::size_t column) const {
    return brdf::direction(brdf::Angle::deg(theta_r_deg[column]), phi_r);
  }
  brdf::Length wavelength(std::size_t row) const { return brdf::Length::nm(lambda_nm[row]); }
  std::size_t cells() const { return lambda_nm.size() * theta_r_deg.size(); }
};

/// The viewing directions, column by column.
std::vector<brdf::Direction> viewing_directions(const SweepRequest& request);

/// Throws Errc::invalid_argument for an angle of 90 deg or more or a wavelength that is not
/// positive, naming it.
void require_valid(const SweepRequest& request);

/// The queries of one row, in the order of the angles.
std::vector<brdf::Query> queries_of_row(const SweepRequest& request, std::size_t row);

/// The box that all queries of the request lie in.
brdf::QueryBounds bounds_of(const SweepRequest& request, double tolerance);

/// Whether a query lies beyond the Nyquist limit abs(k u) <= pi / pixel of a height field.
inline bool is_beyond_nyquist(const brdf::Query& query, const brdf::HeightField& field) {
  return std::abs(query.qx_per_um) * field.dx_um() > brdf::pi ||
         std::abs(query.qy_per_um) * field.dy_um() > brdf::pi;
}

/// Frequencies of a request beyond the Nyquist limit abs(k u) <= pi / pixel of a height field.
struct NyquistExcess {
  double lambda_nm;  ///< the shortest wavelength, where it is worst
  std::optional<std::pair<double, double>> safe_deg;  ///< first and last angle within the limit
};
std::optional<NyquistExcess> nyquist_excess(const SweepRequest& request,
                                            const brdf::HeightField& field);

}  // namespace evaluation
