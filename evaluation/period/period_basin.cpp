#include "evaluation/period/period_basin.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace evaluation {
namespace {

constexpr double order_spacings = 0.1, least_relative_range = 0.03;
constexpr double steps_of_half_width = 3;
constexpr double half_widths = 3;  // of the lobe, where cells are taken
constexpr Degrees coarse{2, 1};
/// Of the mirror's peak: an order beside it may be weaker than what is left of that.
constexpr double mirror_power = 1e-6;
constexpr double least_power = 1e-300;  // no division by 0
constexpr double narrowest = 0.6, widest = 8;
constexpr int widths = 32;

/// What the columns leave of a target [sum of squares].
double left_of(const Eigen::VectorXd& target, const Eigen::MatrixXd& columns) {
  if (columns.cols() == 0) return target.squaredNorm();
  return (target - columns * columns.colPivHouseholderQr().solve(target)).squaredNorm();
}

/// Whether the mirror's lobe reaches into the cells of an order.
bool is_beside_mirror(const OrderCells& cells, const WindowLobe& lobe, double k, double half) {
  return std::pow(lobe.core(std::abs(cells.order) * k - half), 2) > mirror_power;
}

/// What an order's cells leave unexplained.
double left_of_order(const OrderCells& cells, const WindowLobe& lobe, double k, bool is_separate) {
  const Degrees degrees = bearable(cells, coarse);
  if (is_separate)  // sidelobes alone could pass for any lobe
    return left_of(cells.power.matrix(),
                   lobe_columns(cells, degrees, lobe, k).leftCols(degrees.lobe + 1));
  const OrderProblem problem{cells, degrees, 1,
                             std::vector<double>(static_cast<std::size_t>(cells.size()), 1.0)};
  return residual_left(problem, lobe, k).squaredNorm();
}

double explained_by_lobes(const PowerView& view, const WindowLobe& lobe, double k) {
  struct Sums {
    double explained = 0, all = 0;
  };
  Sums apart, beside;
  const double wanted = half_widths * lobe.half_width_per_um();
  const bool is_separate = wanted < k / 2;
  const double half = std::min(wanted, k / 2);
  for (const OrderCells& cells : cells_of_orders(view, lobe, k, half)) {
    Sums& sums = is_beside_mirror(cells, lobe, k, half) ? beside : apart;
    const double all = cells.power.square().sum();
    sums.explained += all - left_of_order(cells, lobe, k, is_separate);
    sums.all += all;
  }
  const Sums& sums = apart.all > 0 ? apart : beside;
  // Cells that do not cover all between the orders count by what they catch.
  return is_separate ? sums.explained : sums.explained / std::max(sums.all, least_power);
}

}  // namespace

double best_start(const PowerView& view, const WindowLobe& lobe, double start_per_um) {
  double highest_q = 0;
  for (Eigen::Index row = 0; row < view.rows(); ++row)
    highest_q = std::max(
        {highest_q, std::abs(view.lowest_q_per_um(row)), std::abs(view.highest_q_per_um(row))});
  const double highest_order = std::max(1.0, std::floor(highest_q / start_per_um));
  const double range =
      start_per_um * std::max(least_relative_range, order_spacings / highest_order);
  const double step = lobe.half_width_per_um() / (steps_of_half_width * highest_order);
  const auto steps = static_cast<int>(std::ceil(range / step));
  double best = start_per_um, most = -1;
  for (int i = -steps; i <= steps; ++i) {
    const double k = start_per_um + range * i / std::max(1, steps);
    const double explained = explained_by_lobes(view, lobe, k);
    if (explained > most) {
      most = explained;
      best = k;
    }
  }
  return best;
}

double relative_width(const std::vector<OrderProblem>& problems, const WindowLobe& lobe, double k) {
  const double ratio = std::pow(widest / narrowest, 1.0 / (widths - 1));
  std::vector<double> left(widths, 0);
  for (int i = 0; i < widths; ++i)
    for (const OrderProblem& problem : problems) {
      const Degrees degrees = bearable(problem.cells, coarse);
      const double width = narrowest * std::pow(ratio, i);
      left[static_cast<std::size_t>(i)] += left_of(
          problem.cells.power.matrix(), lobe_columns(problem.cells, degrees, lobe, k, width));
    }
  const auto least = std::min_element(left.begin(), left.end());
  auto at = static_cast<double>(least - left.begin());
  if (least != left.begin() && least + 1 != left.end()) {
    const double rise = *(least + 1) - *(least - 1);
    const double curvature = *(least + 1) + *(least - 1) - 2 * *least;
    if (curvature > 0) at -= rise / (2 * curvature);
  }
  return narrowest * std::pow(ratio, at);
}

}  // namespace evaluation
