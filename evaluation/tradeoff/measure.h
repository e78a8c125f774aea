// One trial of a trade-off, run and held against the right answer.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/cell_selection.h"
#include "evaluation/sweep.h"
#include "evaluation/tradeoff/findings.h"
#include "evaluation/tradeoff/trial.h"

namespace evaluation {

/// What is asked of every trial. The heights must outlive it.
struct TradeoffRequest {
  SweepRequest sweep;
  const brdf::HeightField* heights;
  brdf::GaussianWindow window;
  std::optional<brdf::Length> period;  ///< along the plane of incidence
  int order = 1;                       ///< whose peaks and period are compared
  RunLimits limits;

  brdf::Surface surface(brdf::SurfaceModel model, brdf::Replicas replicas) const {
    return {heights, window, model, brdf::Origin::patch_centre, replicas};
  }
  TrialScope scope(brdf::SurfaceModel model, brdf::Replicas replicas) const;
};

/// How long one run of a trial took.
struct TrialTime {
  double plan_s, query_s;
  double total_s() const { return plan_s + query_s; }
};

/// A trial that ran.
struct TrialRun {
  TrialTime time;            ///< of all cells, scaled up where fewer were timed
  std::size_t timed_cells;   ///< of a sum over every pixel a sample stands for all
  brdf::QueryBounds bounds;  ///< that the plan was made for
  brdf::PlanReport report;
  std::vector<std::complex<double>> amplitudes;  ///< of the timed cells
};

/// Errors against the reference of the same surface model.
struct TrialErrors {
  /// Of the amplitude, flat patch's peak = 1, over the cells of the request. Where a trial has only
  /// some wavelengths: of its modulus, the power between them taken linearly. The reference's own
  /// error, as its audit found it, is added.
  double worst = 0, rms = 0;
  FindingErrors findings;
};

/// The right answer of a request on one surface: the expansion at 1e-12, itself held against the
/// direct sum at some cells. Refers to the request.
class TradeoffReference {
 public:
  TradeoffReference(const TradeoffRequest& request, brdf::SurfaceModel model,
                    brdf::Replicas replicas);

  /// Runs a trial. Throws brdf::Error where the method refuses.
  TrialRun run(const Trial& trial) const;
  TrialErrors errors(const Trial& trial, const TrialRun& run) const;
  /// Of the numbers in the plan's tables; empty where the method says none.
  std::string storage(const Trial& trial, const TrialRun& run) const;

  static constexpr double tolerance = 1e-12;
  /// Largest error of the amplitude against the direct sum, and the cells that were looked at.
  double audited_error() const { return audited_error_; }
  static constexpr std::size_t audited_cells = 32;

 private:
  CellSelection cells_of(const Trial& trial, const SweepRequest& request) const;
  Findings findings_of(const SweepRequest& request, const brdf::HeightArray& power) const;

  const TradeoffRequest& request_;
  brdf::Surface surface_;
  std::vector<std::complex<double>> amplitudes_;  ///< row by row
  Eigen::Array<double, 1, Eigen::Dynamic> gain_;  ///< of each viewing angle, for any wavelength
  Findings findings_;
  double audited_error_ = 0;
};

}  // namespace evaluation
