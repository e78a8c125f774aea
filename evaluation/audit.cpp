#include "evaluation/audit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "evaluation/parallel.h"

namespace evaluation {
namespace {

/// The i-th of evenly spread cells.
std::size_t spread_cell(std::size_t i, std::size_t cells) {
  const double turns = (static_cast<double>(i) + 0.5) / std::numbers::phi;
  const double place = (turns - std::floor(turns)) * static_cast<double>(cells);
  return std::min(static_cast<std::size_t>(place), cells - 1);
}

}  // namespace

Audit audit(const SweepRequest& request, const CellSelection& cells, const brdf::Surface& surface,
            const Amplitude& amplitude, std::size_t wanted, const RunLimits& limits) {
  const std::size_t count = cells.size() > 0 ? wanted : 0;
  const auto reference =
      method_named("direct").plan(surface, bounds_of(request, /*tolerance=*/1e-12), {});
  std::vector<double> errors(count);
  parallel_for(count, limits.threads, [&](std::size_t i) {
    const auto [row, column] = cells[spread_cell(i, cells.size())];
    const brdf::Query where =
        query(request.omega_i(), request.omega_r(column), request.wavelength(row), request.depth);
    std::complex<double> exact, tested;
    reference->evaluate({&where, 1}, {&exact, 1});
    amplitude.evaluate({&where, 1}, {&tested, 1});
    const double error = std::abs(tested - exact);
    errors[i] = error <= std::numeric_limits<double>::max()
                    ? error
                    : std::numeric_limits<double>::infinity();
  });
  if (count == 0) return {0, 0, 0, 0};
  const auto worst = std::max_element(errors.begin(), errors.end());
  const auto [row, column] =
      cells[spread_cell(static_cast<std::size_t>(worst - errors.begin()), cells.size())];
  return {count, *worst, request.lambda_nm[row], request.theta_r_deg[column]};
}

}  // namespace evaluation
