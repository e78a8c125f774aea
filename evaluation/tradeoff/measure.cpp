#include "evaluation/tradeoff/measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "brdf/gain.h"
#include "evaluation/audit.h"
#include "evaluation/parallel.h"
#include "evaluation/worst_error.h"

namespace evaluation {
namespace {

using Amplitudes = std::vector<std::complex<double>>;
using Clock = std::chrono::steady_clock;

/// Bands as wide as the sources' window: 4 sigma_f, or zeros of a replicated surface's lobe.
constexpr double band_radius = 4;

/// As many phasors of a sum over every pixel are timed: some tenths of a second.
constexpr double timed_phasors = 4e8;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<brdf::Query> queries_of(const SweepRequest& request, const CellSelection& cells) {
  std::vector<brdf::Query> queries;
  queries.reserve(cells.size());
  for (std::size_t row = 0; row < request.lambda_nm.size(); ++row) {
    const std::vector<brdf::Query> all = queries_of_row(request, row);
    for (const std::size_t column : cells.columns_of_row(row)) queries.push_back(all[column]);
  }
  return queries;
}

Amplitudes evaluated(const Amplitude& amplitude, std::span<const brdf::Query> queries,
                     int threads) {
  constexpr std::size_t block = 1024;  // as long as a row of a sweep
  Amplitudes amplitudes(queries.size());
  parallel_for((queries.size() + block - 1) / block, threads, [&](std::size_t i) {
    const std::size_t first = i * block, count = std::min(block, queries.size() - first);
    amplitude.evaluate(queries.subspan(first, count), std::span(amplitudes).subspan(first, count));
  });
  return amplitudes;
}

/// Queries that go through every pixel are thinned to what takes a moment; all others are
/// evaluated.
std::vector<std::size_t> timed(const Trial& trial, std::size_t queries,
                               const brdf::HeightField& field) {
  std::size_t count = queries;
  if (method_named(trial.method).query_cost == QueryCost::every_pixel)
    count =
        std::min(count, 64 + static_cast<std::size_t>(
                                 timed_phasors / static_cast<double>(field.heights_um().size())));
  std::vector<std::size_t> chosen(count);
  for (std::size_t i = 0; i < count; ++i)
    chosen[i] = count == queries ? i : evenly_spread(i, queries);
  return chosen;
}

/// Between the power and the relative reflectance.
Eigen::Array<double, 1, Eigen::Dynamic> relative_gains(const SweepRequest& request) {
  const brdf::Direction omega_i = request.omega_i();
  Eigen::Array<double, 1, Eigen::Dynamic> gains(
      static_cast<Eigen::Index>(request.theta_r_deg.size()));
  Eigen::Index column = 0;
  for (const brdf::Direction& omega_r : viewing_directions(request))
    gains[column++] = brdf::relative_gain(omega_i, omega_r);
  return gains;
}

/// abs(a)^2 of the rows between the steps, linear in the wavelength.
brdf::HeightArray interpolated(const brdf::HeightArray& power, const Axis& steps_nm,
                               const Axis& lambda_nm) {
  brdf::HeightArray full(static_cast<Eigen::Index>(lambda_nm.size()), power.cols());
  for (std::size_t i = 0; i < lambda_nm.size(); ++i) {
    const auto above =
        std::upper_bound(steps_nm.values.begin(), steps_nm.values.end() - 1, lambda_nm[i]);
    const auto hi = std::max<std::ptrdiff_t>(above - steps_nm.values.begin(), 1);
    const double lo_nm = steps_nm[static_cast<std::size_t>(hi - 1)];
    const double hi_nm = steps_nm[static_cast<std::size_t>(hi)];
    const double part = std::min((lambda_nm[i] - lo_nm) / (hi_nm - lo_nm), 1.0);
    full.row(static_cast<Eigen::Index>(i)) = (1 - part) * power.row(hi - 1) + part * power.row(hi);
  }
  return full;
}

brdf::HeightArray power_of(const Amplitudes& amplitudes, const SweepRequest& request,
                           const CellSelection& cells) {
  brdf::HeightArray power =
      brdf::HeightArray::Zero(static_cast<Eigen::Index>(request.lambda_nm.size()),
                              static_cast<Eigen::Index>(request.theta_r_deg.size()));
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    const auto [row, column] = cells[i];
    power(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
        std::norm(amplitudes[i]);
  }
  return power;
}

/// Largest and root of the mean square; what is no number counts as infinite.
class ErrorSum {
 public:
  void add(double error) {
    worst_.see(error);
    squares_ += error * error;
    ++count_;
  }
  /// With the error of the reference itself: by the triangle's inequality no smaller than that of
  /// the trial.
  void finish(TrialErrors& errors, double reference_error) const {
    errors.worst = number_or_infinite(worst_.value()) + reference_error;
    errors.rms =
        number_or_infinite(std::sqrt(squares_ / static_cast<double>(count_))) + reference_error;
  }

 private:
  static double number_or_infinite(double value) {
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  }

  WorstError worst_;
  double squares_ = 0;
  std::size_t count_ = 0;
};

}  // namespace

TrialScope TradeoffRequest::scope(brdf::SurfaceModel model, brdf::Replicas replicas) const {
  const double bins_per_sigma_f =
      window.sigma_f_per_um() * std::max(heights->width_um(), heights->height_um());
  return {model, replicas, 1.5 / bins_per_sigma_f, sweep.lambda_nm, period};
}

TradeoffReference::TradeoffReference(const TradeoffRequest& request, brdf::SurfaceModel model,
                                     brdf::Replicas replicas)
    : request_(request),
      surface_(request.surface(model, replicas)),
      gain_(relative_gains(request.sweep)) {
  const brdf::QueryBounds bounds = bounds_of(request.sweep, tolerance);
  MethodSettings settings;
  settings.threads = request.limits.threads;
  const auto amplitude = method_named("chebyshev").plan(surface_, bounds, settings);
  const CellSelection all = CellSelection::all(request.sweep);
  amplitudes_ = evaluated(*amplitude, queries_of(request.sweep, all), request.limits.threads);
  findings_ = findings_of(request.sweep, power_of(amplitudes_, request.sweep, all));
  audited_error_ = audit(request.sweep, all, surface_, *amplitude,
                         std::min(audited_cells, all.size()), request.limits)
                       .worst_error;
}

CellSelection TradeoffReference::cells_of(const Trial& trial, const SweepRequest& request) const {
  if (trial.cells == Cells::all) return CellSelection::all(request);
  return CellSelection::within(
      brdf::OrderBands(surface_, {*request_.period, {}, request.phi_i}, band_radius), request);
}

Findings TradeoffReference::findings_of(const SweepRequest& request,
                                        const brdf::HeightArray& power) const {
  const ResponseMatrix response{request.lambda_nm, request.theta_r_deg, power.rowwise() * gain_};
  PeakSearch search;
  search.order = request_.order;
  search.period_guess = request_.period;
  const bool has_window = surface_.model != brdf::SurfaceModel::replicated;
  return findings(response, request, search,
                  has_window ? std::optional(surface_.window.sigma_f_per_um()) : std::nullopt);
}

TrialRun TradeoffReference::run(const Trial& trial) const {
  const SweepRequest request = thinned(request_.sweep, trial.lambda_step_nm);
  const std::vector<brdf::Query> all = queries_of(request, cells_of(trial, request));
  if (all.empty()) throw brdf::Error(brdf::Errc::not_attainable, "no cell lies near an order");
  std::vector<brdf::Query> queries;
  for (const std::size_t i : timed(trial, all.size(), *request_.heights)) queries.push_back(all[i]);
  brdf::QueryBounds bounds = bounds_of(request, trial.tolerance.value_or(1e-6));
  bounds.count = all.size();
  const Method& method = method_named(trial.method);
  const MethodSettings settings = trial.settings(request_.limits.threads);

  TrialRun run;
  const auto start = Clock::now();
  const auto amplitude = method.plan(surface_, bounds, settings);
  run.time.plan_s = seconds_since(start);
  const auto planned = Clock::now();
  run.amplitudes = evaluated(*amplitude, queries, request_.limits.threads);
  run.time.query_s = seconds_since(planned) * static_cast<double>(all.size()) /
                     static_cast<double>(queries.size());
  run.timed_cells = queries.size();
  run.bounds = bounds;
  run.report = amplitude->report();
  return run;
}

std::string TradeoffReference::storage(const Trial& trial, const TrialRun& run) const {
  const nlohmann::ordered_json plan =
      method_named(trial.method)
          .explain(surface_, run.bounds, trial.settings(request_.limits.threads));
  return plan.value("storage", "");
}

TrialErrors TradeoffReference::errors(const Trial& trial, const TrialRun& run) const {
  const SweepRequest request = thinned(request_.sweep, trial.lambda_step_nm);
  const CellSelection cells = cells_of(trial, request);
  const std::size_t columns = request.theta_r_deg.size();
  ErrorSum sum;
  TrialErrors errors;
  if (run.timed_cells != cells.size()) {  // a sample
    const std::vector<std::size_t> chosen = timed(trial, cells.size(), *request_.heights);
    for (std::size_t i = 0; i < chosen.size(); ++i)
      sum.add(std::abs(run.amplitudes[i] - amplitudes_[chosen[i]]));
    sum.finish(errors, audited_error_);
    return errors;
  }
  const brdf::HeightArray power = power_of(run.amplitudes, request, cells);
  errors.findings = difference(findings_of(request, power), findings_);
  if (trial.lambda_step_nm) {
    const brdf::HeightArray full = interpolated(power, request.lambda_nm, request_.sweep.lambda_nm);
    for (Eigen::Index i = 0; i < full.size(); ++i)
      sum.add(
          std::abs(std::sqrt(full.data()[i]) - std::abs(amplitudes_[static_cast<std::size_t>(i)])));
  } else {
    Amplitudes all(amplitudes_.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
      all[cells[i].row * columns + cells[i].column] = run.amplitudes[i];
    for (std::size_t i = 0; i < all.size(); ++i) sum.add(std::abs(all[i] - amplitudes_[i]));
  }
  sum.finish(errors, audited_error_);
  return errors;
}

}  // namespace evaluation
