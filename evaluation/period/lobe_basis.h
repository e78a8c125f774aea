// The power around one order of a grating as a linear model, and what it leaves of a response.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "evaluation/period/ridge_cells.h"

namespace evaluation {

/// Degrees of the Chebyshev polynomials in c = k w.
struct Degrees {
  int lobe;        ///< of P_n(c), the order's own power
  int neighbours;  ///< of what leaks in from the other orders
};

/// One order, ready to be fitted.
struct OrderProblem {
  OrderCells cells;
  Degrees degrees;
  double scale = 1;            ///< standard deviation of a cell [power]
  std::vector<double> weight;  ///< of each cell, (0, 1]; that of its row
};

/// The columns that the power of the cells is made of, for the grating's K = 2 pi / d [rad/um].
///
/// In the plane through v = 0 a grating's amplitude is sum_n A_n(c) W(q - nK), so its power is
/// sum_n P_n(c) W_n^2 + sum_{n<m} X_nm(c) W_n W_m, linear in functions of c alone that are
/// band-limited by the range of heights. Around the order n, with D = q - nK:
/// - P_n(c) W(D)^2;
/// - the cores of the orders n - 1, n + 1 and 0: W(D) G(D -+ K), W(D) G(D + nK), G(D -+ K)^2, with
/// G
///   the lobe less its sidelobes;
/// - the sidelobes of all other orders together: a cut edge makes e / (q - mK) sin or cos of q L/2,
///   whatever m: W(D) e {cos, sin}(D L/2) {1, D/K}, and their products e^2 {1, cos, sin}(D L).
/// Families that are nowhere above 1e-6 of the lobe's peak are left out. The first columns are
/// those of P_n. width: of the order's own lobe over the window's, W(D / width)^2.
Eigen::MatrixXd lobe_columns(const OrderCells& cells, const Degrees& degrees,
                             const WindowLobe& lobe, double k_grating_per_um, double width = 1);

/// What the best combination of the columns leaves of the power of the cells, over scale and times
/// the root of the weight.
///
/// The combination is held by a ridge of 1e-6 of the lobe's own column, in natural units: a
/// coefficient counts against it where it is 1e6 times the order's power, so that a sidelobe of
/// 1e-9 is not blown up into anything. Least squares by Householder QR.
Eigen::VectorXd residual_left(const OrderProblem& problem, const WindowLobe& lobe,
                              double k_grating_per_um);

/// The degrees for an order: stepped up until generalised cross-validation falls by less than a
/// fifth, within what its rows and cells can bear.
Degrees degrees_for(const OrderCells& cells, const std::vector<double>& weight,
                    const WindowLobe& lobe, double k_grating_per_um);

/// Degrees that an order's rows and cells can bear: half as many polynomials as rows.
Degrees bearable(const OrderCells& cells, Degrees degrees);

}  // namespace evaluation
