#include "evaluation/period/joint_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "brdf/error.h"
#include "evaluation/period/period_basin.h"
#include "evaluation/period/period_uncertainty.h"
#include "evaluation/period/pixel_beat.h"

namespace evaluation {
namespace {

using brdf::Errc;
using brdf::Error;

constexpr Eigen::Index most_rows = 48;
constexpr std::size_t fewest_wavelengths = 3;
constexpr double half_widths = 3, fewer_half_widths = 2.2;
constexpr int rounds = 3, reweighings = 3, choices = 2;
/// Rounds end where K moves by less than this part of the lobe's half-width.
constexpr double settled = 1e-6;
/// No step is told apart below this part of the lobe's half-width: the ridge of 1e-6 and families
/// left out below 1e-6 (lobe_basis.h) may act together.
constexpr double rounding = 1e-5;
constexpr double widest_lobe = 2.5, least_explained = 0.5;
constexpr double widest_interval = 0.1;
/// The next richer model has this much higher degrees.
constexpr int richer = 2;

double reach_of_cells(const WindowLobe& lobe, double k, double lobes) {
  return std::min(lobes * lobe.half_width_per_um(), k / 2);
}

[[noreturn]] void refuse(const std::string& what) {
  throw Error(Errc::not_attainable, what);
}

brdf::LineDirection line_of(const JointScene& scene) {
  // Also where the light stands above the patch.
  const brdf::Direction along = brdf::direction(brdf::Angle::deg(45), scene.phi_i);
  const double length = std::hypot(along.x(), along.y());
  return {along.x() / length, along.y() / length};
}

/// Orders with degrees and weights for a K.
std::vector<OrderProblem> problems_at(const PowerView& view, const WindowLobe& lobe, double k,
                                      double lobes) {
  std::vector<OrderProblem> problems;
  for (OrderCells& cells : cells_of_orders(view, lobe, k, reach_of_cells(lobe, k, lobes))) {
    OrderProblem problem{std::move(cells), {4, 1}, 1, {}};
    problem.degrees = bearable(problem.cells, problem.degrees);
    problem.scale = problem.cells.peak;
    problem.weight.assign(static_cast<std::size_t>(problem.cells.size()), 1.0);
    // Rows that do not belong are told before the degrees are chosen by what is left, and again.
    for (int choice = 0; choice < choices; ++choice) {
      for (int i = 0; i < reweighings; ++i) reweigh(problem, lobe, k);
      problem.degrees = degrees_for(problem.cells, problem.weight, lobe, k);
    }
    for (int i = 0; i < reweighings; ++i) reweigh(problem, lobe, k);
    problems.push_back(std::move(problem));
  }
  return problems;
}

/// Part of the sum of squares of the cells that is explained, rows weighted.
double explained_part(const std::vector<OrderProblem>& problems, const WindowLobe& lobe, double k) {
  double left = 0, all = 0;
  for (const OrderProblem& problem : problems) {
    const double unit = problem.scale / problem.cells.peak;  // each order by its own peak
    left += residual_left(problem, lobe, k).squaredNorm() * unit * unit;
    for (std::size_t i = 0; i < problem.weight.size(); ++i) {
      const double value = problem.cells.power(static_cast<Eigen::Index>(i)) / problem.cells.peak;
      all += problem.weight[i] * value * value;
    }
  }
  return 1 - left / all;
}

/// Where the next step of the solver would go from K.
double step_from(const std::vector<OrderProblem>& problems, const WindowLobe& lobe, double k) {
  double score = 0, information = 0;
  for (const RowScore& row : row_scores(problems, lobe, k)) {
    score += row.score;
    information += row.information;
  }
  return information > 0 ? -score / information : 0;
}

/// The larger of what higher degrees and what cells nearer to the orders would change [rad/um].
Component model_change(const std::vector<OrderProblem>& problems, const PowerView& view,
                       const WindowLobe& lobe, double k) {
  std::vector<OrderProblem> higher = problems;
  for (OrderProblem& problem : higher)
    problem.degrees = bearable(
        problem.cells, {problem.degrees.lobe + richer, problem.degrees.neighbours + richer});
  const double by_degrees = std::abs(step_from(higher, lobe, k));
  const double by_cells =
      std::abs(step_from(problems_at(view, lobe, k, fewer_half_widths), lobe, k));
  // Two differences are looked at and the larger is kept.
  return {std::max({by_degrees, by_cells, rounding * lobe.half_width_per_um()}), 2};
}

void require_single_period(const JointFit& fit) {
  const auto says = [&](const std::string& what, const std::string& limit) {
    refuse("no single period near " + brdf::text(std::round(fit.period_nm)) + " nm: " + what +
           ", " + limit + "; `shedlight ridges` shows what there is");
  };
  if (!(fit.explained >= least_explained))
    says("lobes at its orders explain " + brdf::text(std::round(100 * fit.explained)) +
             " % of the power there",
         "at least 50 % are needed");
  if (!(fit.relative_width <= widest_lobe))
    says("the lobes are " + brdf::text(std::round(10 * fit.relative_width) / 10) +
             " times as wide as the window's",
         "at most 2.5 times are one period's");
}

/// Relative deviation by the rounding of edges to pixels.
double pixel_part(const JointScene& scene, const WindowLobe& lobe, double k) {
  if (scene.relief == Relief::smooth) return 0;
  const brdf::LineDirection along = line_of(scene);
  const double pixel_um = std::max(scene.x.pixel_um * std::abs(along.cos_azimuth),
                                   scene.y.pixel_um * std::abs(along.sin_azimuth));
  return pixel_deviation(lobe, pixel_um, 2 * brdf::pi / k);
}

JointFit::Uncertainty in_nm(double nm_per_unit, const ScoreErrors& errors, double pixel,
                            double model) {
  return {nm_per_unit * errors.fit.deviation, nm_per_unit * errors.orders.deviation,
          nm_per_unit * errors.blocks.deviation, nm_per_unit * pixel, nm_per_unit * model};
}

}  // namespace

JointFit fit_period_jointly(const ResponseMatrix& response, const JointScene& scene,
                            brdf::Length start) {
  if (!(start.um() > 0 && std::isfinite(start.um())))
    throw Error(Errc::invalid_argument,
                "period to start from " + brdf::text(start.nm()) + " nm must be > 0 and finite");
  if (response.lambda_nm.size() < fewest_wavelengths)
    refuse("a period needs at least 3 wavelengths, the response has " +
           std::to_string(response.lambda_nm.size()));
  const PowerView view(response, scene, most_rows);
  const double guess = 2 * brdf::pi / start.um();
  const WindowLobe lobe({scene.model, scene.window, scene.x, scene.y, line_of(scene)});

  double k = best_start(view, lobe, guess);
  std::vector<OrderProblem> problems;
  SolvedPeriod solved{};
  bool is_settled = false;
  for (int round = 0; round < rounds && !is_settled; ++round) {
    problems = problems_at(view, lobe, k, half_widths);
    if (problems.empty())
      refuse("no order of a period near " + brdf::text(start.nm()) +
             " nm but 0 stands above the response's error in 3 wavelengths; check the range of "
             "theta_r and the period to start from");
    solved = solve_period(problems, lobe, k);
    is_settled = std::abs(solved.k_grating_per_um - k) <= settled * lobe.half_width_per_um();
    k = solved.k_grating_per_um;
  }

  JointFit fit{};
  fit.period_nm = brdf::Length::um(2 * brdf::pi / k).nm();
  fit.explained = explained_part(problems, lobe, k);
  fit.relative_width = relative_width(problems, lobe, k);
  require_single_period(fit);

  const ScoreErrors errors = score_errors(row_scores(problems, lobe, k), view.rows());
  const Component model = model_change(problems, view, lobe, k);
  const Component pixel{k * pixel_part(scene, lobe, k), std::numeric_limits<double>::infinity()};
  const Component all = combined({errors.fit, errors.orders, errors.blocks, pixel, model});
  const double nm_per_unit = fit.period_nm / k;
  fit.uncertainty_nm = in_nm(nm_per_unit, errors, pixel.deviation, model.deviation);
  fit.std_nm = nm_per_unit * all.deviation;
  const double half_nm = nm_per_unit * half_interval(all);
  fit.low_nm = fit.period_nm - half_nm;
  fit.high_nm = fit.period_nm + half_nm;

  std::set<Eigen::Index> rows;
  for (const OrderProblem& problem : problems) {
    rows.insert(problem.cells.row.begin(), problem.cells.row.end());
    fit.cells += problem.cells.size();
  }
  fit.orders = static_cast<int>(problems.size());
  fit.wavelengths = static_cast<Eigen::Index>(rows.size());
  fit.message = solved.message;
  fit.status = !(solved.converged && std::isfinite(half_nm)) ? JointStatus::not_converged
               : half_nm <= widest_interval * fit.period_nm  ? JointStatus::converged
                                                             : JointStatus::cannot_tell;
  return fit;
}

}  // namespace evaluation
