// K = 2 pi / d of a grating from the cells around its orders, by variable projection.
#pragma once

#include <string>
#include <vector>

#include "evaluation/period/lobe_basis.h"

namespace evaluation {

/// The grating's wavenumber that leaves least of the cells.
struct SolvedPeriod {
  double k_grating_per_um;
  bool converged;
  std::string message;  ///< of the solver
};

/// Weights and scale of an order from what is left of it at K: the scale is the median over its
/// rows of the root mean square, a row weighs 1 / (1 + (rms / (2.385 scale))^2) (Cauchy's loss at
/// 95 % efficiency, Holland and Welsch 1977). The scale is not below `least_scale`.
void reweigh(OrderProblem& problem, const WindowLobe& lobe, double k_grating_per_um);

/// Scale of a cell that rounding and the response's own error make at least: 1e-10 of the peak;
/// an error e of the amplitude, floor = e^2, moves the power by 2 e sqrt(peak).
double least_scale(const OrderCells& cells);

/// Derivative of the residuals of an order with K, by a central difference over 2e-3 of the lobe's
/// half-width at that order.
Eigen::VectorXd residual_slope(const OrderProblem& problem, const WindowLobe& lobe,
                               double k_grating_per_um);

/// Least squares over K with everything linear projected out at each step; start within a lobe's
/// half-width at the highest order.
SolvedPeriod solve_period(const std::vector<OrderProblem>& problems, const WindowLobe& lobe,
                          double start_per_um);

}  // namespace evaluation
