#include "evaluation/audit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "evaluation/parallel.h"

namespace evaluation {

QueryAudit audit(std::span<const brdf::Query> queries, const brdf::Surface& surface,
                 const Amplitude& amplitude, const RunLimits& limits) {
  if (queries.empty()) return {0, 0, 0};
  const auto reference =
      method_named("direct").plan(surface, brdf::bounds_of(queries, /*tolerance=*/1e-12), {});
  std::vector<double> errors(queries.size());
  parallel_for(queries.size(), limits.threads, [&](std::size_t i) {
    std::complex<double> exact, tested;
    reference->evaluate(queries.subspan(i, 1), {&exact, 1});
    amplitude.evaluate(queries.subspan(i, 1), {&tested, 1});
    const double error = std::abs(tested - exact);
    errors[i] = error <= std::numeric_limits<double>::max()
                    ? error
                    : std::numeric_limits<double>::infinity();
  });
  const auto worst = std::max_element(errors.begin(), errors.end());
  return {queries.size(), *worst, static_cast<std::size_t>(worst - errors.begin())};
}

std::size_t evenly_spread(std::size_t i, std::size_t count) {
  const double turns = (static_cast<double>(i) + 0.5) / std::numbers::phi;
  const double place = (turns - std::floor(turns)) * static_cast<double>(count);
  return std::min(static_cast<std::size_t>(place), count - 1);
}

Audit audit(const SweepRequest& request, const CellSelection& cells, const brdf::Surface& surface,
            const Amplitude& amplitude, std::size_t wanted, const RunLimits& limits) {
  std::vector<brdf::Query> queries;
  for (std::size_t i = 0; i < wanted && cells.size() > 0; ++i) {
    const auto [row, column] = cells[evenly_spread(i, cells.size())];
    queries.push_back(
        query(request.omega_i(), request.omega_r(column), request.wavelength(row), request.depth));
  }
  const QueryAudit found = audit(queries, surface, amplitude, limits);
  if (found.queries == 0) return {0, 0, 0, 0};
  const auto [row, column] = cells[evenly_spread(found.worst, cells.size())];
  return {found.queries, found.worst_error, request.lambda_nm[row], request.theta_r_deg[column]};
}

}  // namespace evaluation
