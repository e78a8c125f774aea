#include "evaluation/sweep.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <span>
#include <string>

#include "evaluation/parallel.h"

namespace evaluation {
namespace {

/// Cells between two looks at the clock.
constexpr std::size_t batch_cells = 32;

void require_finite(double value, double lambda_nm, double theta_r_deg) {
  if (std::isfinite(value)) return;
  throw brdf::Error(brdf::Errc::not_attainable,
                    "response at " + number_text(lambda_nm) + " nm, " + number_text(theta_r_deg) +
                        " deg is not finite: the method has lost all accuracy");
}

}  // namespace

void TimeLimit::refuse(const std::string& where, const std::string& left) const {
  throw brdf::Error(brdf::Errc::over_limit, "the time limit of " + number_text(length.count()) +
                                                " s (--time-limit) was reached" + where + "; " +
                                                left);
}

ResponseMatrix sweep(const SweepRequest& request, const Reflectance& reflectance,
                     const CellSelection& cells, const RunLimits& limits,
                     const Progress& progress) {
  const std::size_t rows = request.lambda_nm.size();
  const std::vector<brdf::Direction> directions = viewing_directions(request);
  const brdf::Direction omega_i = request.omega_i();
  ResponseMatrix response{request.lambda_nm, request.theta_r_deg,
                          brdf::HeightArray::Zero(static_cast<Eigen::Index>(rows),
                                                  static_cast<Eigen::Index>(directions.size()))};
  std::size_t rows_done = 0;
  std::mutex progress_mutex;
  const auto compute_row = [&](std::size_t row) {
    std::span<const std::size_t> columns = cells.columns_of_row(row);
    while (!columns.empty()) {
      limits.check_time(" at wavelength " + number_text(request.lambda_nm[row]) + " nm");
      const auto batch = columns.first(std::min(batch_cells, columns.size()));
      std::vector<Sample> samples;
      for (const std::size_t column : batch)
        samples.push_back({{omega_i, directions[column]}, request.wavelength(row)});
      std::vector<double> values(batch.size());
      reflectance.evaluate(samples, values);
      for (std::size_t j = 0; j < batch.size(); ++j) {
        require_finite(values[j], request.lambda_nm[row], request.theta_r_deg[batch[j]]);
        response.values(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(batch[j])) =
            values[j];
      }
      columns = columns.subspan(batch.size());
    }
  };
  if (limits.chunks != nullptr) limits.chunks->open(rows, directions.size() * sizeof(double));
  parallel_for(rows, limits.threads, [&](std::size_t row) {
    const std::span values(response.values.data() + row * directions.size(), directions.size());
    once(limits.chunks, row, values, [&] { compute_row(row); });
    if (progress) {
      const std::scoped_lock lock(progress_mutex);
      progress(static_cast<double>(++rows_done) / static_cast<double>(rows));
    }
  });
  return response;
}

}  // namespace evaluation
