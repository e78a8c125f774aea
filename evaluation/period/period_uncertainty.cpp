#include "evaluation/period/period_uncertainty.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <map>

namespace evaluation {
namespace {

/// Enough to tell their spread (a quantile of 2.4), few enough for neighbours to differ.
constexpr Eigen::Index most_blocks = 8;

template <class Key>
Component grouped(const std::vector<RowScore>& scores, Key key_of) {
  std::map<decltype(key_of(scores.front())), double> groups;
  double information = 0;
  for (const RowScore& score : scores) {
    groups[key_of(score)] += score.spread;
    information += score.information;
  }
  const auto count = static_cast<double>(groups.size());
  if (groups.size() < 2) return {0, std::numeric_limits<double>::infinity()};
  double squares = 0;
  for (const auto& group : groups) squares += group.second * group.second;
  return {std::sqrt(squares * count / (count - 1)) / information, count - 1};
}

}  // namespace

std::vector<RowScore> row_scores(const std::vector<OrderProblem>& problems, const WindowLobe& lobe,
                                 double k) {
  std::vector<RowScore> scores;
  for (const OrderProblem& problem : problems) {
    const Eigen::VectorXd left = residual_left(problem, lobe, k);
    const Eigen::VectorXd slope = residual_slope(problem, lobe, k);
    const std::vector<Eigen::Index>& row = problem.cells.row;
    // What the columns took of the noise is missing in what they left.
    const auto count = static_cast<double>(problem.cells.size());
    const auto taken =
        static_cast<double>(lobe_columns(problem.cells, problem.degrees, lobe, k).cols());
    const double missing = std::sqrt(count / std::max(1.0, count - taken));
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i == 0 || row[i] != row[i - 1]) scores.push_back({problem.cells.order, row[i], 0, 0, 0});
      const auto at = static_cast<Eigen::Index>(i);
      scores.back().score += left(at) * slope(at);
      scores.back().spread += missing * left(at) * slope(at);
      scores.back().information += slope(at) * slope(at);
    }
  }
  return scores;
}

ScoreErrors score_errors(const std::vector<RowScore>& scores, Eigen::Index rows) {
  const Eigen::Index blocks = std::min(most_blocks, rows);
  const auto block = [&](const RowScore& score) { return score.row * blocks / rows; };
  return {
      grouped(scores, [&](const RowScore& score) { return std::pair(score.order, block(score)); }),
      grouped(scores, [](const RowScore& score) { return score.order; }), grouped(scores, block)};
}

Component combined(const std::vector<Component>& components) {
  double variance = 0, fourth = 0;
  for (const Component& component : components) {
    const double square = component.deviation * component.deviation;
    variance += square;
    fourth += square * square / component.freedom;
  }
  return {std::sqrt(variance),
          fourth > 0 ? variance * variance / fourth : std::numeric_limits<double>::infinity()};
}

double half_interval(const Component& component) {
  constexpr double upper = 0.975;  // of a two-sided interval of 95 %
  // Beyond 1e6 degrees of freedom the quantile is the normal's to 1e-6.
  const boost::math::students_t distribution(std::clamp(component.freedom, 1.0, 1e6));
  return component.deviation * boost::math::quantile(distribution, upper);
}

}  // namespace evaluation
