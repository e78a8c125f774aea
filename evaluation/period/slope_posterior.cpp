#include "evaluation/period/slope_posterior.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "brdf/error.h"

namespace evaluation {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

constexpr double mostly_accumulated = 300;

/// One covariance: its prior, and what it makes of the slope.
struct Hypothesis {
  double rho = 0;           ///< variance of distances against that of places
  double bow = 0;           ///< of a parabola at the ends against a place, standard deviations
  double window_width = 1;  ///< correlation of independent places, in windows
  double prior = 0;
  double slope = 0, std = 0, log_evidence = 0;
  double probability = 0;  ///< given the data
};

std::vector<Hypothesis> hypotheses() {
  constexpr double independent = 0.55, bowed = 0.12, drifting = 0.33;
  constexpr std::array drifts{3.0, 30.0, 300.0};
  constexpr std::array bows{3.0, 10.0, 30.0};
  std::vector<Hypothesis> all;
  for (const double width : {1.0, 1.5}) {
    all.push_back({.window_width = width, .prior = independent});
    for (const double rho : drifts)
      all.push_back({.rho = rho, .window_width = width, .prior = drifting / drifts.size()});
    for (const double bow : bows)
      all.push_back({.bow = bow, .window_width = width, .prior = bowed / bows.size()});
  }
  return all;
}

/// E|d + N(0, 2 s^2)| - E|N(0, 2 s^2)|: the variogram of Brownian motion of unit growth a period,
/// seen through a Gaussian window of standard deviation s at two places d apart.
double brownian_variogram(double d, double s) {
  const boost::math::normal normal;
  const double spread = std::sqrt(2.0) * s, z = std::abs(d) / spread;
  const double centre = boost::math::pdf(normal, 0.0);
  return spread *
         (2 * boost::math::pdf(normal, z) + z * (2 * boost::math::cdf(normal, z) - 1) - 2 * centre);
}

Eigen::MatrixXd overlap(const LinePhases& phases, double width) {
  const auto n = static_cast<Eigen::Index>(phases.size());
  Eigen::MatrixXd r(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const double z = (phases.line[a] - phases.line[b]) / (2 * width * line_window_periods);
      r(i, j) = std::exp(-z * z) / std::sqrt(phases.weight[a] * phases.weight[b]);
    }
  return r;
}

/// Distances vary from line to line, not within one: places are a random walk's, drawn out evenly
/// between lines, which smooths by a box one period wide, of variance 1/12, beside the window.
const double accumulated_window_periods =
    std::sqrt(line_window_periods * line_window_periods + 1.0 / 12);

/// A constant makes it positive definite; the slope's estimate, beside a free constant, does not
/// see it.
Eigen::MatrixXd brownian(const LinePhases& phases) {
  const auto n = static_cast<Eigen::Index>(phases.size());
  const double reach = phases.line.back() - phases.line.front();
  Eigen::MatrixXd k(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      k(i, j) = reach + 1 -
                brownian_variogram(phases.line[static_cast<std::size_t>(i)] -
                                       phases.line[static_cast<std::size_t>(j)],
                                   accumulated_window_periods) /
                    2;
  return k;
}

/// A parabola over the lines, 1 at the farther end.
Eigen::VectorXd parabola(const LinePhases& phases) {
  const auto n = static_cast<Eigen::Index>(phases.size());
  const Eigen::Map<const Eigen::ArrayXd> line(phases.line.data(), n);
  const Eigen::ArrayXd squares = (line - line.mean()).square();
  return squares / squares.maxCoeff();
}

/// Generalised least squares of constant and slope, with the restricted likelihood.
void evaluate(Hypothesis& h, const Eigen::MatrixXd& covariance, const Eigen::VectorXd& phase,
              const Eigen::MatrixX2d& design) {
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
  const Eigen::VectorXd y = factor.matrixL().solve(phase);
  const Eigen::MatrixX2d x = factor.matrixL().solve(design);
  const Eigen::Matrix2d normal = x.transpose() * x;
  const Eigen::Vector2d solution = normal.inverse() * (x.transpose() * y);
  const double freedom = static_cast<double>(phase.size() - 2);
  // Phases of an exact grating are right to 1e-9 rad: less scatter than that is luck.
  const double floor = freedom * 1e-18 / covariance(0, 0);
  const double scatter = std::max((y - x * solution).squaredNorm(), floor);
  h.slope = solution(1);
  h.std = std::sqrt(normal.inverse()(1, 1) * scatter / freedom);
  h.log_evidence = std::log(h.prior) - factor.matrixLLT().diagonal().array().log().sum() -
                   0.5 * std::log(normal.determinant()) - 0.5 * freedom * std::log(scatter);
}

/// Where the mixture's distribution reaches a probability.
double quantile(const std::vector<Hypothesis>& all, double freedom, double probability) {
  const boost::math::students_t student(freedom);
  // At least one member's quantile lies on each side.
  double lo = inf, hi = -inf;
  for (const Hypothesis& h : all) {
    const double q = h.slope + h.std * boost::math::quantile(student, probability);
    lo = std::min(lo, q);
    hi = std::max(hi, q);
  }
  // 60 halvings: to rounding.
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = std::midpoint(lo, hi);
    double below = 0;
    for (const Hypothesis& h : all)
      below += h.probability * boost::math::cdf(student, (middle - h.slope) / h.std);
    (below < probability ? lo : hi) = middle;
  }
  return std::midpoint(lo, hi);
}

}  // namespace

SlopePosterior slope_posterior(const LinePhases& phases) {
  if (phases.size() < least_lines)
    throw brdf::Error(brdf::Errc::not_attainable,
                      "only " + std::to_string(phases.size()) + " lines of the grating, at least " +
                          std::to_string(least_lines) + " are needed to tell how even it is");
  const auto n = static_cast<Eigen::Index>(phases.size());
  const Eigen::Map<const Eigen::VectorXd> phase(phases.phase_rad.data(), n);
  Eigen::MatrixX2d design(n, 2);
  design.col(0).setOnes();
  design.col(1) = Eigen::Map<const Eigen::VectorXd>(phases.line.data(), n);

  const Eigen::MatrixXd k = brownian(phases);
  const Eigen::VectorXd bow = parabola(phases);
  std::vector<Hypothesis> all = hypotheses();
  double best = -inf;
  for (Hypothesis& h : all) {
    const Eigen::MatrixXd r = overlap(phases, h.window_width);
    evaluate(h, r + h.rho * k + h.bow * h.bow * bow * bow.transpose(), phase, design);
    best = std::max(best, h.log_evidence);
  }
  double total = 0;
  for (Hypothesis& h : all) total += std::exp(h.log_evidence - best);
  SlopePosterior posterior{};
  for (Hypothesis& h : all) {
    h.probability = std::exp(h.log_evidence - best) / total;
    if (h.rho > 0) posterior.accumulated_share += h.probability;
    if (h.bow > 0) posterior.bowed_share += h.probability;
    if (h.window_width != 1 || h.bow > 0) continue;
    if (h.rho == 0) posterior.independent_std = h.std;
    if (h.rho == mostly_accumulated) posterior.accumulated_std = h.std;
  }
  const auto freedom = static_cast<double>(n - 2);
  posterior.median = quantile(all, freedom, 0.5);
  posterior.interval = {quantile(all, freedom, 0.025), quantile(all, freedom, 0.975)};
  return posterior;
}

}  // namespace evaluation
