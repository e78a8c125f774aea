#include "evaluation/response_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brdf/error.h"

namespace evaluation {
namespace {

double smallest_step(const Axis& axis) {
  double step = std::abs(axis.front());
  for (std::size_t i = 1; i < axis.size(); ++i) step = std::min(step, axis[i] - axis[i - 1]);
  return step;
}

std::string span_of(const Axis& axis) {
  const auto [first, last] = std::minmax_element(axis.values.begin(), axis.values.end());
  return number_text(*first) + " to " + number_text(*last) + " in " + std::to_string(axis.size());
}

}  // namespace

std::optional<OutOfOrder> out_of_order(const Axis& axis, const Axis& reference,
                                       const std::string& name) {
  const double near = 1e-6 * smallest_step(reference);
  const auto same = [near](double a, double b) { return std::abs(a - b) <= near; };
  if (std::ranges::equal(axis.values, reference.values, same)) return std::nullopt;
  std::vector<double> sorted = axis.values;
  std::ranges::sort(sorted);
  if (!std::ranges::equal(sorted, reference.values, same))
    throw brdf::Error(brdf::Errc::bad_input, "the axes " + name + " differ: " + span_of(axis) +
                                                 " values against " + span_of(reference));
  const auto [found, expected] = std::ranges::mismatch(axis.values, reference.values, same);
  return OutOfOrder{*found, *expected};
}

ResponseDifference response_difference(const ResponseMatrix& response,
                                       const ResponseMatrix& reference) {
  ResponseDifference difference;
  for (Eigen::Index row = 0; row < response.values.rows(); ++row)
    for (Eigen::Index column = 0; column < response.values.cols(); ++column) {
      const double found = std::abs(response.values(row, column) - reference.values(row, column));
      if (found <= difference.worst) continue;
      difference = {std::isfinite(found) ? found : std::numeric_limits<double>::infinity(),
                    static_cast<std::size_t>(row), static_cast<std::size_t>(column)};
      if (difference.worst > std::numeric_limits<double>::max()) return difference;
    }
  return difference;
}

}  // namespace evaluation
