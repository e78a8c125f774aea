#include "evaluation/period/period_basin.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace evaluation {
namespace {

constexpr double order_spacings = 0.1, least_relative_range = 0.03;
constexpr double steps_of_half_width = 3;
constexpr double lobe_half_widths = 2;  // sidelobes lie beyond
constexpr double narrowest = 0.6, widest = 8;
constexpr int widths = 32;
constexpr int width_degree = 4;  // of the polynomials in c

/// Normal equations of the powers of c of one order.
struct Parabola {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
};

double explained_power(const PowerView& view, const WindowLobe& lobe, double k, double middle_c,
                       double half_c) {
  std::map<int, Parabola> orders;
  const double half = std::min(lobe_half_widths * lobe.half_width_per_um(), k / 2);
  for (Eigen::Index row = 0; row < view.rows(); ++row)
    for (Eigen::Index col = 0; col < view.cols(); ++col) {
      const double order = std::round(view.q_per_um(row, col) / k);
      const double apart = view.q_per_um(row, col) - order * k;
      if (order == 0 || !(std::abs(apart) <= half)) continue;
      const double x = (view.c_per_um(row, col) - middle_c) / half_c;
      const double own = lobe(apart) * lobe(apart);
      const Eigen::Vector3d column = own * Eigen::Vector3d(1, x, x * x);
      Parabola& parabola = orders[static_cast<int>(order)];
      parabola.products += column * column.transpose();
      parabola.right += view.power(row, col) * column;
    }
  double explained = 0;
  for (const auto& entry : orders) {
    const Parabola& parabola = entry.second;
    // Few cells may not determine a parabola: held by 1e-9 of the first column.
    const Eigen::Matrix3d held =
        parabola.products + 1e-9 * parabola.products(0, 0) * Eigen::Matrix3d::Identity();
    if (parabola.products(0, 0) > 0)
      explained += parabola.right.dot(held.ldlt().solve(parabola.right));
  }
  return explained;
}

/// What lobes of a width leave of an order's power, of its peak.
double left_by_width(const OrderCells& cells, const WindowLobe& lobe, double k, double width) {
  const Eigen::ArrayXd own = (cells.q_per_um - cells.order * k).unaryExpr([&](double q) {
    const double w = lobe(q / width);
    return w * w;
  });
  const double range = std::max(cells.c_high_per_um - cells.c_low_per_um, 1e-12);
  const Eigen::ArrayXd x = (2 * cells.c_per_um - cells.c_low_per_um - cells.c_high_per_um) / range;
  const int degree = std::min(width_degree, static_cast<int>(cells.row_count()) / 2);
  Eigen::MatrixXd columns(cells.size(), degree + 1);
  Eigen::ArrayXd power = own;
  for (int i = 0; i <= degree; ++i, power *= x) columns.col(i) = power;
  const Eigen::VectorXd target = (cells.power / cells.peak).matrix();
  return (target - columns * columns.colPivHouseholderQr().solve(target)).squaredNorm();
}

}  // namespace

double best_start(const PowerView& view, const WindowLobe& lobe, double start_per_um) {
  double low_c = view.c_per_um(0, 0), high_c = low_c;
  double highest_q = 0;
  for (Eigen::Index row = 0; row < view.rows(); ++row) {
    highest_q = std::max(
        {highest_q, std::abs(view.lowest_q_per_um(row)), std::abs(view.highest_q_per_um(row))});
    for (Eigen::Index col = 0; col < view.cols(); ++col) {
      low_c = std::min(low_c, view.c_per_um(row, col));
      high_c = std::max(high_c, view.c_per_um(row, col));
    }
  }
  const double middle_c = std::midpoint(low_c, high_c);
  const double half_c = std::max((high_c - low_c) / 2, 1e-12);
  const double highest_order = std::max(1.0, std::floor(highest_q / start_per_um));
  const double range =
      start_per_um * std::max(least_relative_range, order_spacings / highest_order);
  const double step = lobe.half_width_per_um() / (steps_of_half_width * highest_order);
  const auto steps = static_cast<int>(std::ceil(range / step));
  double best = start_per_um, most = -1;
  for (int i = -steps; i <= steps; ++i) {
    const double k = start_per_um + range * i / std::max(1, steps);
    const double explained = explained_power(view, lobe, k, middle_c, half_c);
    if (explained > most) {
      most = explained;
      best = k;
    }
  }
  return best;
}

double relative_width(const std::vector<OrderCells>& orders, const WindowLobe& lobe, double k) {
  const double ratio = std::pow(widest / narrowest, 1.0 / (widths - 1));
  std::vector<double> left(widths, 0);
  for (int i = 0; i < widths; ++i)
    for (const OrderCells& cells : orders)
      left[static_cast<std::size_t>(i)] +=
          left_by_width(cells, lobe, k, narrowest * std::pow(ratio, i));
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
