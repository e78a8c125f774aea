// The one loop over wavelength and viewing angle.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "brdf/amplitude.h"
#include "brdf/directions.h"
#include "brdf/gain.h"
#include "evaluation/methods.h"
#include "evaluation/response_matrix.h"

namespace evaluation {

/// Where the third frequency of a query comes from.
enum class DepthFrequency {
  scattering_vector,  ///< c = k w
  unit_w,             ///< c = -k, as in the sources' evaluator (Erratum E13)
};

/// Light from one direction, the viewer on a half-circle through the normal.
struct SweepRequest {
  brdf::Angle theta_i, phi_i;
  brdf::Angle phi_r;  ///< azimuth of the half-plane where theta_r is positive
  Axis lambda_nm;
  Axis theta_r_deg;
  DepthFrequency depth = DepthFrequency::scattering_vector;
  brdf::Quantity quantity = brdf::Quantity::relative;

  brdf::Direction omega_i() const { return brdf::direction(theta_i, phi_i); }
  brdf::Direction omega_r(std::size_t column) const {
    return brdf::direction(brdf::Angle::deg(theta_r_deg[column]), phi_r);
  }
  std::size_t cells() const { return lambda_nm.size() * theta_r_deg.size(); }
};

/// How long a run may take.
struct TimeLimit {
  std::chrono::steady_clock::time_point start;
  std::chrono::duration<double> length;

  bool passed() const { return std::chrono::steady_clock::now() - start > length; }
};

/// What a run may use.
struct RunLimits {
  int threads = 1;
  std::optional<TimeLimit> time;
};

/// Called now and then with the part done, 0 to 1, never from two threads at once.
using Progress = std::function<void(double)>;

/// Throws Errc::invalid_argument for an angle of 90 deg or more or a wavelength that is not
/// positive, naming it.
void require_valid(const SweepRequest& request);

/// The queries of one row, in the order of the angles.
std::vector<brdf::Query> queries_of_row(const SweepRequest& request, std::size_t row);

/// The box that all queries of the request lie in.
brdf::QueryBounds bounds_of(const SweepRequest& request, double tolerance);

/// Evaluates every cell. Bit-identical for any number of threads.
///
/// Throws Errc::over_limit past the time limit; Errc::not_attainable for a cell that is not finite.
ResponseMatrix sweep(const SweepRequest& request, const Amplitude& amplitude,
                     double coherence_area_um2, const RunLimits& limits,
                     const Progress& progress = {});

/// Frequencies of a request beyond the Nyquist limit abs(k u) <= pi / pixel of a height field.
struct NyquistExcess {
  double lambda_nm;  ///< the shortest wavelength, where it is worst
  std::optional<std::pair<double, double>> safe_deg;  ///< first and last angle within the limit
};
std::optional<NyquistExcess> nyquist_excess(const SweepRequest& request,
                                            const brdf::HeightField& field);

}  // namespace evaluation
