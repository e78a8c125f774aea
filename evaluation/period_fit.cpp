#include "evaluation/period_fit.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "brdf/error.h"

namespace evaluation {
namespace {

using brdf::Errc;
using brdf::Error;

/// One peak, ready for the fit: the residual is (sines - m lambda / d) / cos theta_r.
struct Observation {
  double lambda_nm, sines, order_lambda_um, cos_theta_r;
};

struct GratingResidual {
  Observation observed;

  template <class T>
  bool operator()(const T* period_um, T* residual) const {
    residual[0] = (observed.sines - observed.order_lambda_um / period_um[0]) / observed.cos_theta_r;
    return true;
  }
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

std::vector<Observation> observations(const std::vector<Peak>& peaks, const PlaneOfIncidence& plane,
                                      int order) {
  std::vector<Observation> observed;
  for (const Peak& peak : peaks)
    if (peak.theta_r_deg)
      observed.push_back({peak.lambda_nm, plane.sines(*peak.theta_r_deg),
                          order * brdf::Length::nm(peak.lambda_nm).um(),
                          std::cos(brdf::Angle::deg(*peak.theta_r_deg).rad())});
  return observed;
}

std::vector<double> residuals_rad(const std::vector<Observation>& observed, double period_um) {
  std::vector<double> residuals;
  for (const Observation& o : observed) {
    double residual = 0;
    GratingResidual{o}(&period_um, &residual);
    residuals.push_back(residual);
  }
  return residuals;
}

/// Standard deviation of a normal distribution with the same median absolute value.
double robust_deviation(std::vector<double> residuals, double floor) {
  for (double& residual : residuals) residual = std::abs(residual);
  constexpr double normal_consistency = 1.482602218505602;  // 1 / quantile(3/4) of the normal
  return std::max(normal_consistency * median(std::move(residuals)), floor);
}

/// Scale of Cauchy's loss in standard deviations that keeps 95 % of the efficiency of least squares
/// on normal residuals (Holland and Welsch 1977).
constexpr double cauchy_scale = 2.385;

/// A residual farther out than this many robust deviations is named.
constexpr double outlier_deviations = 3;

/// Standard error of an M-estimate of one parameter, sqrt(sum (psi d)^2 / (sum psi' d^2)^2) with
/// Huber's n / (n - 1) (Huber, Robust Statistics, 1981, eq. 7.6.10 for one parameter).
double standard_error(const std::vector<Observation>& observed,
                      const std::vector<double>& residuals, double period_um, double scale) {
  double influence = 0, information = 0;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    const double derivative =
        observed[i].order_lambda_um / (period_um * period_um * observed[i].cos_theta_r);
    const double squared = (residuals[i] / scale) * (residuals[i] / scale);
    const double psi = residuals[i] / (1 + squared);
    influence += psi * psi * derivative * derivative;
    information += (1 - squared) / ((1 + squared) * (1 + squared)) * derivative * derivative;
  }
  const auto count = static_cast<double>(observed.size());
  return std::sqrt(influence * count / (count - 1)) / information;
}

[[noreturn]] void refuse_too_few(std::size_t count) {
  throw Error(Errc::not_attainable,
              "only " + std::to_string(count) +
                  " wavelengths have a peak inside the searched angles, at least 2 are needed; "
                  "check --order, --period-guess and the range of theta_r");
}

}  // namespace

PeriodSpread period_spread(const std::vector<Peak>& peaks, const PlaneOfIncidence& plane,
                           int order) {
  std::vector<double> periods;
  for (const Peak& peak : peaks)
    if (peak.theta_r_deg)
      if (const auto period = period_nm(plane, order, peak.lambda_nm, peak.grid_theta_r_deg))
        periods.push_back(*period);
  if (periods.size() < 2) refuse_too_few(periods.size());
  const auto count = static_cast<double>(periods.size());
  double sum = 0, squares = 0;
  for (const double period : periods) sum += period;
  for (const double period : periods) squares += (period - sum / count) * (period - sum / count);
  return {sum / count, std::sqrt(squares / (count - 1)), periods.size()};
}

std::string_view side_of(int order) {
  if (order == 0) return "mirror";
  return order > 0 ? "towards the light" : "away from the light";
}

PeriodFit fit_period(const std::vector<Peak>& peaks, const PlaneOfIncidence& plane, int order,
                     double angle_step_deg) {
  if (order == 0)
    throw Error(Errc::not_attainable,
                "order 0 lies in the mirror direction for every period: no period can be fitted");
  const std::vector<Observation> observed = observations(peaks, plane, order);
  if (observed.size() < 2) refuse_too_few(observed.size());

  std::vector<double> periods_um;
  for (const Observation& o : observed) periods_um.push_back(o.order_lambda_um / o.sines);
  double period_um = median(periods_um);
  const double floor = std::max(1e-9, brdf::Angle::deg(angle_step_deg).rad() / std::sqrt(12.0));
  const double deviation = robust_deviation(residuals_rad(observed, period_um), floor);
  const double scale = cauchy_scale * deviation;

  ceres::Problem problem;
  for (const Observation& o : observed)
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<GratingResidual, 1, 1>(new GratingResidual{o}),
        new ceres::CauchyLoss(scale), &period_um);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  // The residuals are angles of 1e-3 rad and less: stop at the rounding of the period instead.
  options.function_tolerance = 1e-16;
  options.gradient_tolerance = 1e-16;
  options.parameter_tolerance = 1e-12;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  const std::vector<double> residuals = residuals_rad(observed, period_um);
  PeriodFit fit{};
  for (std::size_t i = 0; i < observed.size(); ++i) {
    fit.residuals_deg.push_back(brdf::Angle::rad(residuals[i]).deg());
    if (std::abs(residuals[i]) > outlier_deviations * deviation)
      fit.outlier_lambdas_nm.push_back(observed[i].lambda_nm);
  }
  const double error_um = standard_error(observed, residuals, period_um, scale);
  fit.period_nm = brdf::Length::um(period_um).nm();
  fit.std_error_nm = brdf::Length::um(error_um).nm();
  fit.status = summary.termination_type == ceres::CONVERGENCE && period_um > 0 && error_um >= 0
                   ? FitStatus::converged
                   : FitStatus::not_converged;
  fit.message = summary.message;
  fit.order = order;
  return fit;
}

}  // namespace evaluation
