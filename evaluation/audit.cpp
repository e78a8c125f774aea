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

Audit audit(const SweepRequest& request, const brdf::Surface& surface, const Amplitude& amplitude,
            std::size_t cells, const RunLimits& limits) {
  const std::size_t columns = request.theta_r_deg.size();
  const auto reference =
      method_named("direct").plan(surface, bounds_of(request, /*tolerance=*/1e-12), {});
  std::vector<double> errors(cells);
  parallel_for(cells, limits.threads, [&](std::size_t i) {
    const std::size_t cell = spread_cell(i, request.cells());
    const brdf::Query query = queries_of_row(request, cell / columns)[cell % columns];
    std::complex<double> exact, tested;
    reference->evaluate({&query, 1}, {&exact, 1});
    amplitude.evaluate({&query, 1}, {&tested, 1});
    const double error = std::abs(tested - exact);
    errors[i] = error <= std::numeric_limits<double>::max()
                    ? error
                    : std::numeric_limits<double>::infinity();
  });
  if (cells == 0) return {0, 0, 0, 0};
  const auto worst = std::max_element(errors.begin(), errors.end());
  const std::size_t cell =
      spread_cell(static_cast<std::size_t>(worst - errors.begin()), request.cells());
  return {cells, *worst, request.lambda_nm[cell / columns], request.theta_r_deg[cell % columns]};
}

}  // namespace evaluation
