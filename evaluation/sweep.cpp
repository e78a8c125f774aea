#include "evaluation/sweep.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <mutex>
#include <span>

#include "evaluation/parallel.h"

namespace evaluation {
namespace {

/// Cells between two looks at the clock.
constexpr std::size_t batch_cells = 32;

brdf::Query query(const SweepRequest& request, const Eigen::Vector3d& scattering, double k_per_um) {
  const double w = request.depth == DepthFrequency::unit_w ? -1.0 : scattering.z();
  return {k_per_um * scattering.x(), k_per_um * scattering.y(), k_per_um * w};
}

double gain(const SweepRequest& request, std::size_t row, std::size_t column, double area_um2) {
  switch (request.quantity) {
    case brdf::Quantity::power:
      return 1;
    case brdf::Quantity::relative:
      return brdf::relative_gain(request.omega_i(), request.omega_r(column));
    case brdf::Quantity::brdf:
      return brdf::brdf_gain(request.omega_i(), request.omega_r(column),
                             brdf::Length::nm(request.lambda_nm[row]), area_um2);
  }
  return 1;
}

/// The line that all queries lie on where the viewer moves in the plane of incidence.
std::optional<brdf::LineDirection> plane_of_queries(const SweepRequest& request) {
  // Azimuths that mean the same plane differ by their own rounding only; more would take the
  // queries off the line by more than theirs.
  constexpr double rounding_deg = 1e-12;
  const double apart_deg = std::remainder(request.phi_r.deg() - request.phi_i.deg(), 180.0);
  if (!(std::abs(apart_deg) <= rounding_deg) && request.theta_i.rad() != 0) return std::nullopt;
  const brdf::Direction along = brdf::direction(brdf::Angle::deg(45), request.phi_r);
  const double length = std::hypot(along.x(), along.y());
  return brdf::LineDirection{along.x() / length, along.y() / length};
}

}  // namespace

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
  const double k_per_um = brdf::wavenumber_per_um(brdf::Length::nm(request.lambda_nm[row]));
  const brdf::Direction omega_i = request.omega_i();
  std::vector<brdf::Query> queries(request.theta_r_deg.size());
  for (std::size_t j = 0; j < queries.size(); ++j)
    queries[j] = query(request, brdf::scattering_vector(omega_i, request.omega_r(j)), k_per_um);
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
  bounds.line = plane_of_queries(request);
  return bounds;
}

ResponseMatrix sweep(const SweepRequest& request, const Amplitude& amplitude,
                     double coherence_area_um2, const RunLimits& limits, const Progress& progress) {
  ResponseMatrix response{request.lambda_nm, request.theta_r_deg, {}};
  const std::size_t rows = request.lambda_nm.size(), columns = request.theta_r_deg.size();
  response.values.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  std::size_t rows_done = 0;
  std::mutex progress_mutex;
  parallel_for(rows, limits.threads, [&](std::size_t row) {
    const std::vector<brdf::Query> queries = queries_of_row(request, row);
    std::vector<std::complex<double>> amplitudes(columns);
    for (std::size_t start = 0; start < columns; start += batch_cells) {
      if (limits.time && limits.time->passed())
        throw brdf::Error(brdf::Errc::over_limit,
                          "the time limit of " + number_text(limits.time->length.count()) +
                              " s (--time-limit) was reached at wavelength " +
                              number_text(request.lambda_nm[row]) + " nm; nothing was written");
      const std::size_t count = std::min(batch_cells, columns - start);
      amplitude.evaluate(std::span(queries).subspan(start, count),
                         std::span(amplitudes).subspan(start, count));
    }
    for (std::size_t j = 0; j < columns; ++j) {
      const double value = gain(request, row, j, coherence_area_um2) * std::norm(amplitudes[j]);
      if (!std::isfinite(value))
        throw brdf::Error(brdf::Errc::not_attainable,
                          "response at " + number_text(request.lambda_nm[row]) + " nm, " +
                              number_text(request.theta_r_deg[j]) +
                              " deg is not finite: the method has lost all accuracy");
      response.values(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(j)) = value;
    }
    if (progress) {
      const std::scoped_lock lock(progress_mutex);
      progress(static_cast<double>(++rows_done) / static_cast<double>(rows));
    }
  });
  return response;
}

std::optional<NyquistExcess> nyquist_excess(const SweepRequest& request,
                                            const brdf::HeightField& field) {
  NyquistExcess excess{request.lambda_nm.front(), std::nullopt};
  bool exceeded = false;
  const std::vector<brdf::Query> queries = queries_of_row(request, 0);
  for (std::size_t j = 0; j < queries.size(); ++j) {
    if (std::abs(queries[j].qx_per_um) * field.dx_um() > brdf::pi ||
        std::abs(queries[j].qy_per_um) * field.dy_um() > brdf::pi) {
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
