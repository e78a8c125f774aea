// How far a jointly fitted period may be off.
#pragma once

#include <vector>

#include "evaluation/period/period_solver.h"

namespace evaluation {

/// Standard deviations of K, relative, and the degrees of freedom each is known by.
struct Component {
  double deviation;
  double freedom;
};

/// What the rows of an order say of K: the weighted score J r, the same times sqrt(n / (n - p)) for
/// p columns fitted to n cells, and the information J^2.
struct RowScore {
  int order;
  Eigen::Index row;
  double score, spread, information;
};

std::vector<RowScore> row_scores(const std::vector<OrderProblem>& problems, const WindowLobe& lobe,
                                 double k_grating_per_um);

/// Standard errors of K [rad/um] from scores that are independent only between groups: root of the
/// sum of the groups' squared scores over the information, times G / (G - 1) for G groups (Liang
/// and Zeger 1986). No deviation where there is one group only.
struct ScoreErrors {
  Component fit;     ///< groups of one order in one block of wavelengths
  Component orders;  ///< groups of all wavelengths of one order
  Component blocks;  ///< groups of all orders in one block of wavelengths
};

/// blocks: consecutive rows of the view are put into so many, or into as many as there are rows.
ScoreErrors score_errors(const std::vector<RowScore>& scores, Eigen::Index rows);

/// Root of the sum of squares; its degrees of freedom by Welch (1947) and Satterthwaite (1946).
Component combined(const std::vector<Component>& components);

/// Half of the 95 % interval: the deviation times Student's quantile.
double half_interval(const Component& component);

}  // namespace evaluation
