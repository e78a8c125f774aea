#include "evaluation/period/lobe_basis.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace evaluation {
namespace {

constexpr double ridge = 1e-6;
constexpr double smallest_family = 1e-6;
/// A higher degree must lower the cross-validation to this part of what it was.
constexpr double worth_a_step = 0.8;
constexpr std::array degrees_tried{1, 2, 3, 4, 6, 8, 10, 12, 14, 16, 18};
constexpr int most_neighbours = 6;
constexpr int most_families = 12;  // of neighbours

/// T_0 ... T_degree of c on its range, a column each.
Eigen::ArrayXXd chebyshev(const OrderCells& cells, int degree) {
  const double range = cells.c_high_per_um - cells.c_low_per_um;
  Eigen::ArrayXXd t(cells.size(), degree + 1);
  t.col(0) = 1;
  if (degree == 0) return t;
  const Eigen::ArrayXd x =
      range > 0
          ? Eigen::ArrayXd((2 * cells.c_per_um - cells.c_low_per_um - cells.c_high_per_um) / range)
          : Eigen::ArrayXd(Eigen::ArrayXd::Zero(cells.size()));
  t.col(1) = x;
  for (int i = 2; i <= degree; ++i) t.col(i) = 2 * x * t.col(i - 1) - t.col(i - 2);
  return t;
}

/// Functions of q alone around an order; each is multiplied by the polynomials in c.
std::vector<Eigen::ArrayXd> neighbour_families(const OrderCells& cells, const Eigen::ArrayXd& w,
                                               const WindowLobe& lobe, double k) {
  const Eigen::ArrayXd d = cells.q_per_um - cells.order * k;
  const auto core = [&](double offset) {
    return Eigen::ArrayXd(d.unaryExpr([&](double q) { return lobe.core(q + offset); }));
  };
  const Eigen::ArrayXd above = core(-k), below = core(k);
  const double edge = lobe.edge_per_um() / k;
  const Eigen::ArrayXd phase = d * lobe.half_length_um();
  const Eigen::ArrayXd cosine = edge * phase.cos() * w, sine = edge * phase.sin() * w;
  const Eigen::ArrayXd even = Eigen::ArrayXd::Constant(d.size(), edge * edge);
  std::vector<Eigen::ArrayXd> families{w * above,
                                       w * below,
                                       above * above,
                                       below * below,
                                       cosine,
                                       sine,
                                       cosine * d / k,
                                       sine * d / k,
                                       even,
                                       even * (2 * phase).cos(),
                                       even * (2 * phase).sin()};
  if (std::abs(cells.order) > 1) families.push_back(w * core(cells.order * k));
  std::erase_if(families,
                [](const Eigen::ArrayXd& f) { return !(f.abs().maxCoeff() > smallest_family); });
  return families;
}

}  // namespace

Eigen::MatrixXd lobe_columns(const OrderCells& cells, const Degrees& degrees,
                             const WindowLobe& lobe, double k, double width) {
  const Eigen::ArrayXd w =
      (cells.q_per_um - cells.order * k).unaryExpr([&](double q) { return lobe(q); });
  const Eigen::ArrayXd own_lobe =
      width == 1 ? w : Eigen::ArrayXd((cells.q_per_um - cells.order * k).unaryExpr([&](double q) {
        return lobe(q / width);
      }));
  const std::vector<Eigen::ArrayXd> families = neighbour_families(cells, w, lobe, k);
  const Eigen::ArrayXXd t = chebyshev(cells, std::max(degrees.lobe, degrees.neighbours));
  const Eigen::Index own = degrees.lobe + 1, other = degrees.neighbours + 1;
  Eigen::MatrixXd columns(cells.size(), own + other * static_cast<Eigen::Index>(families.size()));
  columns.leftCols(own) = t.leftCols(own).colwise() * own_lobe.square();
  for (std::size_t i = 0; i < families.size(); ++i)
    columns.middleCols(own + other * static_cast<Eigen::Index>(i), other) =
        t.leftCols(other).colwise() * families[i];
  return columns;
}

Eigen::VectorXd residual_left(const OrderProblem& problem, const WindowLobe& lobe, double k) {
  const OrderCells& cells = problem.cells;
  const Eigen::ArrayXd root =
      Eigen::Map<const Eigen::ArrayXd>(problem.weight.data(), cells.size()).sqrt() / problem.scale;
  Eigen::MatrixXd columns = lobe_columns(cells, problem.degrees, lobe, k);
  columns.array().colwise() *= root;
  const Eigen::VectorXd target = (cells.power * root).matrix();
  const Eigen::Index n = columns.rows(), p = columns.cols();
  Eigen::MatrixXd held = Eigen::MatrixXd::Zero(n + p, p);
  held.topRows(n) = columns;
  held.bottomRows(p).diagonal().setConstant(ridge * columns.col(0).norm());
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + p);
  right.head(n) = target;
  return target - columns * held.householderQr().solve(right);
}

Degrees bearable(const OrderCells& cells, Degrees degrees) {
  const int most = static_cast<int>(cells.row_count()) / 2;
  // Three cells to a coefficient.
  const int neighbours = static_cast<int>(cells.size() / 3 - most - 1) / most_families - 1;
  return {std::clamp(degrees.lobe, 1, std::max(1, most)),
          std::clamp(degrees.neighbours, 0, std::max(0, std::min(neighbours, most / 2)))};
}

Degrees degrees_for(const OrderCells& cells, const std::vector<double>& weight,
                    const WindowLobe& lobe, double k) {
  Degrees best{};
  double least = std::numeric_limits<double>::infinity();
  int in_vain = 0;  // a polynomial that is nearly even gains nothing from an odd degree
  for (const int degree : degrees_tried) {
    const Degrees tried = bearable(cells, {degree, std::min(most_neighbours, (degree + 1) / 2)});
    OrderProblem problem{cells, tried, cells.peak, weight};
    const auto count = static_cast<double>(cells.size());
    const double free = count - static_cast<double>(lobe_columns(cells, tried, lobe, k).cols());
    const double left = residual_left(problem, lobe, k).squaredNorm();
    const double validation =
        free > 0 ? count * left / (free * free) : std::numeric_limits<double>::infinity();
    if (validation < worth_a_step * least) {
      best = tried;
      least = validation;
      in_vain = 0;
    } else if (++in_vain == 2) {
      break;
    }
  }
  return best;
}

}  // namespace evaluation
