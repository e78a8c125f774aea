// The period of a grating from its whole response at once, with an interval that holds the truth.
#pragma once

#include <string>

#include "evaluation/period/ridge_cells.h"

namespace evaluation {

enum class JointStatus {
  converged,
  not_converged,  ///< the solver gave up
  cannot_tell,    ///< the interval is wider than a tenth of the period
};

/// A period with what it may be off by, and what it rests on.
struct JointFit {
  double period_nm;
  /// Standard deviations of the period [nm], each from another source. Those that are 0 could not
  /// be told, or are nothing: `orders` of a single order, `pixel` of a smooth relief.
  struct Uncertainty {
    double fit;     ///< residuals, correlated within an order and a block of wavelengths
    double orders;  ///< disagreement of the orders and sides
    double blocks;  ///< disagreement of the blocks of wavelengths
    double pixel;   ///< sharp edges sampled at the pixel; profiles without edges have none
    double model;   ///< what a richer model, or cells nearer to the orders, would change
  } uncertainty_nm;
  double std_nm;             ///< root of their sum of squares
  double low_nm, high_nm;    ///< 95 % interval, by Student's t
  double relative_width;     ///< of the lobes found, the window's own being 1
  double explained;          ///< part of the sum of squares on the ridges that the model explains
  int orders;                ///< used, both sides
  Eigen::Index wavelengths;  ///< used
  Eigen::Index cells;        ///< used
  JointStatus status;
  std::string message;  ///< of the solver
};

/// Fits d to all orders, wavelengths and cells around the ridges of a response.
///
/// The model is exact for a grating in the plane of incidence (lobe_basis.h): the power is linear
/// in functions of c = k w alone, which are fitted as polynomials, so neither the slope of an
/// order's efficiency nor the sidelobes of its neighbours move the period. Only K = 2 pi / d is
/// nonlinear (variable projection, with Cauchy weights of the rows). Up to 48 wavelengths and 15
/// cells of a row are used.
///
/// scene: the window, model and patch that made the response; sizes of the axes as of
/// `brdf::x_axis`. start: right to a tenth of the spacing of the orders at the highest order in
/// view, or to 3 %. Cost: 0.1 to 2 s. Bit-identical from run to run.
///
/// Measured on noise-free gratings of 0.8 to 5 um (benchmarks/results/period_study.md): smooth
/// profiles to some 1e-6, sharp ones to what their pixels bear.
///
/// The interval held the truth in 20 of 20 trials with noise of 2 % of the strongest cell on every
/// cell (joint_fit.tests.cpp). Noise in proportion to the cells themselves (evenly up to 5 %) moved
/// a period by 3e-5 to one side and 14 of 20 intervals of a smooth relief held it: such noise is
/// not modelled.
///
/// Throws Errc::invalid_argument for a start that is not positive; Errc::not_attainable for fewer
/// than 3 wavelengths, where no order but 0 stands above the floor in 3 of them, and where there is
/// no single period: lobes more than 2.5 times as wide as the window's, or less than half
/// explained.
JointFit fit_period_jointly(const ResponseMatrix& response, const JointScene& scene,
                            brdf::Length start);

}  // namespace evaluation
