#include "evaluation/sweep.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <mutex>
#include <span>

#include "evaluation/parallel.h"

namespace evaluation {
namespace {

/// Cells between two looks at the clock.
constexpr std::size_t batch_cells = 32;

double gain(const SweepRequest& request, std::size_t row, std::size_t column, double area_um2) {
  switch (request.quantity) {
    case brdf::Quantity::power:
      return 1;
    case brdf::Quantity::relative:
      return brdf::relative_gain(request.omega_i(), request.omega_r(column));
    case brdf::Quantity::brdf:
      return brdf::brdf_gain(request.omega_i(), request.omega_r(column),
                             brdf::Length::nm(request.lambda_nm[row]), area_um2);
    case brdf::Quantity::radiance:
      return brdf::radiance_gain(request.omega_i(), request.omega_r(column),
                                 brdf::Length::nm(request.lambda_nm[row]), area_um2);
  }
  return 1;
}

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
  const brdf::Length wavelength = brdf::Length::nm(request.lambda_nm[row]);
  const brdf::Direction omega_i = request.omega_i();
  std::vector<brdf::Query> queries(request.theta_r_deg.size());
  for (std::size_t j = 0; j < queries.size(); ++j) {
    queries[j] = brdf::query(omega_i, request.omega_r(j), wavelength);
    if (request.depth == DepthFrequency::unit_w)
      queries[j].c_per_um = -brdf::wavenumber_per_um(wavelength);
  }
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
