#include "evaluation/period/period_solver.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace evaluation {
namespace {

constexpr double cauchy_scale = 2.385;
constexpr double least_of_peak = 1e-10;
constexpr double difference_of_half_width = 1e-3;

/// The residuals of all orders over one parameter, the shift of K from its start in units in
/// which the highest order moves by the lobe's half-width.
class ProjectedResidual final : public ceres::CostFunction {
 public:
  ProjectedResidual(const std::vector<OrderProblem>& problems, const WindowLobe& lobe,
                    double start_per_um, double unit_per_um)
      : problems_(problems), lobe_(lobe), start_per_um_(start_per_um), unit_per_um_(unit_per_um) {
    mutable_parameter_block_sizes()->push_back(1);
    Eigen::Index count = 0;
    for (const OrderProblem& problem : problems) count += problem.cells.size();
    set_num_residuals(static_cast<int>(count));
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const double k = start_per_um_ + unit_per_um_ * parameters[0][0];
    if (!(k > 0)) return false;
    Eigen::Index at = 0;
    for (const OrderProblem& problem : problems_) {
      const Eigen::Index size = problem.cells.size();
      Eigen::Map<Eigen::VectorXd>(residuals + at, size) = residual_left(problem, lobe_, k);
      if (jacobians != nullptr && jacobians[0] != nullptr)
        Eigen::Map<Eigen::VectorXd>(jacobians[0] + at, size) =
            unit_per_um_ * residual_slope(problem, lobe_, k);
      at += size;
    }
    return true;
  }

 private:
  const std::vector<OrderProblem>& problems_;
  const WindowLobe& lobe_;
  double start_per_um_, unit_per_um_;
};

}  // namespace

double least_scale(const OrderCells& cells) {
  return std::max(least_of_peak * cells.peak,
                  2 * std::sqrt(cells.peak * std::max(0.0, cells.floor)));
}

void reweigh(OrderProblem& problem, const WindowLobe& lobe, double k) {
  const Eigen::VectorXd left = residual_left(problem, lobe, k);
  const std::vector<Eigen::Index>& row = problem.cells.row;
  std::vector<double> rms;  // of each row
  for (std::size_t i = 0; i < row.size();) {
    double squares = 0;
    std::size_t end = i;
    for (; end < row.size() && row[end] == row[i]; ++end) {
      const double unweighted = left(static_cast<Eigen::Index>(end)) * problem.scale;
      squares += unweighted * unweighted / problem.weight[end];
    }
    rms.push_back(std::sqrt(squares / static_cast<double>(end - i)));
    i = end;
  }
  std::vector<double> sorted = rms;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  problem.scale = std::max(*middle, least_scale(problem.cells));
  std::size_t at = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0 && row[i] != row[i - 1]) ++at;
    const double far = rms[at] / (cauchy_scale * problem.scale);
    problem.weight[i] = 1 / (1 + far * far);
  }
}

Eigen::VectorXd residual_slope(const OrderProblem& problem, const WindowLobe& lobe, double k) {
  const double step =
      difference_of_half_width * lobe.half_width_per_um() / std::abs(problem.cells.order);
  return (residual_left(problem, lobe, k + step) - residual_left(problem, lobe, k - step)) /
         (2 * step);
}

SolvedPeriod solve_period(const std::vector<OrderProblem>& problems, const WindowLobe& lobe,
                          double start_per_um) {
  int highest = 1;
  for (const OrderProblem& problem : problems)
    highest = std::max(highest, std::abs(problem.cells.order));
  const double unit_per_um = lobe.half_width_per_um() / highest;
  double shift = 0;
  ceres::Problem problem;
  problem.AddResidualBlock(new ProjectedResidual(problems, lobe, start_per_um, unit_per_um),
                           nullptr, &shift);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 25;
  // 1e-7 of the lobe's width, whatever the residuals are.
  options.parameter_tolerance = 1e-7;
  options.function_tolerance = 1e-9;
  options.gradient_tolerance = 0;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return {start_per_um + unit_per_um * shift,
          summary.termination_type == ceres::CONVERGENCE && std::isfinite(shift), summary.message};
}

}  // namespace evaluation
