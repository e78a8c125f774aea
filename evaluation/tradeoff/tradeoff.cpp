#include "evaluation/tradeoff/tradeoff.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "evaluation/peak_memory.h"

namespace evaluation {
namespace {

using Clock = std::chrono::steady_clock;

/// Beyond it the median of fewer runs is steady enough.
constexpr double long_enough_s = 3;

/// A trial that takes less is repeated at once, some times: the median of a few runs of a
/// millisecond would be that of the scheduler.
constexpr double visit_s = 0.02;
constexpr int most_runs_a_visit = 8;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Fisher and Yates, by a stated generator: std::shuffle differs between libraries.
void shuffle(std::vector<std::size_t>& order, std::mt19937_64& generator) {
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[generator() % i]);
}

/// One surface and what is tried on it.
struct SurfaceTrials {
  brdf::SurfaceModel model;
  brdf::Replicas replicas;
  std::vector<Trial> trials;
};

/// The engine and the sources' own knobs, to show what the copies cost.
std::vector<Trial> trials_of_copies(brdf::Replicas replicas) {
  Trial engine{.method = "chebyshev", .model = brdf::SurfaceModel::replicated};
  engine.replicas = replicas;
  engine.tolerance = 1e-6;
  Trial pq{.method = "pq", .model = brdf::SurfaceModel::replicated};
  pq.replicas = replicas;
  pq.terms = 25;
  return {engine, pq};
}

std::vector<SurfaceTrials> all_trials(const TradeoffRequest& request,
                                      std::span<const brdf::SurfaceModel> models,
                                      brdf::Replicas replicas) {
  std::vector<SurfaceTrials> all;
  for (const brdf::SurfaceModel model : models) {
    const bool has_copies = model == brdf::SurfaceModel::replicated;
    const brdf::Replicas own = has_copies ? replicas : brdf::Replicas{};
    all.push_back({model, own, trials(request.scope(model, own))});
    if (!has_copies) continue;
    for (const brdf::Replicas other : {brdf::Replicas{1, 1}, brdf::Replicas{4 * own.x, 4 * own.y}})
      if (!(other == own)) all.push_back({model, other, trials_of_copies(other)});
  }
  return all;
}

/// The trials of all surfaces, each with its reference, and the runs they had.
class Trials {
 public:
  Trials(const TradeoffRequest& request, std::span<const brdf::SurfaceModel> models,
         brdf::Replicas replicas) {
    for (const SurfaceTrials& surface : all_trials(request, models, replicas)) {
      references_.emplace_back(request, surface.model, surface.replicas);
      audits_.push_back({surface.model, surface.replicas, references_.back().audited_error()});
      for (const Trial& trial : surface.trials) {
        rows_.push_back({.trial = trial});
        reference_of_.push_back(references_.size() - 1);
      }
    }
    plan_s_.resize(rows_.size());
    query_s_.resize(rows_.size());
  }

  std::size_t size() const { return rows_.size(); }

  /// Runs a trial, once or, where it is short, a few times.
  void visit(std::size_t i) {
    TradeoffRow& row = rows_[i];
    try {
      if (row.runs == 0) find_errors(i);
      double spent_s = 0;
      for (int run = 0; run < most_runs_a_visit && spent_s < visit_s; ++run) {
        release_freed_memory();
        spent_s += record(i, references_[reference_of_[i]].run(row.trial).time);
      }
    } catch (const brdf::Error& refusal) {
      row.refused = refusal.what();
    }
  }

  bool wants_another(std::size_t i) const {
    return rows_[i].refused.empty() && std::reduce(plan_s_[i].begin(), plan_s_[i].end()) +
                                               std::reduce(query_s_[i].begin(), query_s_[i].end()) <
                                           long_enough_s;
  }

  Tradeoff result() && {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (rows_[i].refused.empty()) rows_[i].time = {median(plan_s_[i]), median(query_s_[i])};
    mark_frontier(rows_);
    return {std::move(rows_), std::move(audits_)};
  }

 private:
  /// The first run of a trial, which finds its errors and its memory.
  void find_errors(std::size_t i) {
    TradeoffRow& row = rows_[i];
    const TradeoffReference& reference = references_[reference_of_[i]];
    const PeakMemory memory;
    const TrialRun run = reference.run(row.trial);
    row.peak_bytes = memory.bytes();
    row.cells_timed = run.timed_cells;
    row.terms_used = run.report.terms;
    row.storage = reference.storage(row.trial, run);
    row.errors = reference.errors(row.trial, run);
    record(i, run.time);
  }

  /// Returns the seconds of the run.
  double record(std::size_t i, const TrialTime& time) {
    plan_s_[i].push_back(time.plan_s);
    query_s_[i].push_back(time.query_s);
    rows_[i].runs = static_cast<int>(plan_s_[i].size());
    return time.total_s();
  }

  std::vector<TradeoffReference> references_;
  std::vector<ReferenceAudit> audits_;
  std::vector<TradeoffRow> rows_;
  std::vector<std::size_t> reference_of_;
  std::vector<std::vector<double>> plan_s_, query_s_;
};

bool same_surface(const Trial& a, const Trial& b) {
  return a.model == b.model && a.replicas == b.replicas;
}

/// The row of a surface with the least cost among those that meet the condition.
template <class Condition, class Cost>
std::optional<std::size_t> least(std::span<const TradeoffRow> rows, brdf::SurfaceModel model,
                                 brdf::Replicas replicas, Condition condition, Cost cost) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TradeoffRow& row = rows[i];
    if (!row.refused.empty() || row.trial.model != model || !(row.trial.replicas == replicas) ||
        !condition(row))
      continue;
    if (!best || cost(row) < cost(rows[*best])) best = i;
  }
  return best;
}

}  // namespace

Tradeoff tradeoff(const TradeoffRequest& request, std::span<const brdf::SurfaceModel> models,
                  brdf::Replicas replicas, const TradeoffSchedule& schedule,
                  const Progress& progress) {
  const auto start = Clock::now();
  Trials trials(request, models, replicas);
  std::mt19937_64 generator(schedule.seed);
  std::vector<std::size_t> order(trials.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int round = 0; round < schedule.repeats; ++round) {
    shuffle(order, generator);
    for (std::size_t done = 0; done < order.size(); ++done) {
      const bool late = Clock::now() - start > schedule.rounds_end;
      request.limits.check_time();
      if (round == 0 || (!late && trials.wants_another(order[done]))) trials.visit(order[done]);
      if (progress)
        progress((round + static_cast<double>(done + 1) / static_cast<double>(order.size())) /
                 schedule.repeats);
    }
  }
  return std::move(trials).result();
}

std::size_t bytes_needed(const TradeoffRequest& request, std::span<const brdf::SurfaceModel> models,
                         brdf::Replicas replicas) {
  std::size_t largest = 0, surfaces = 0;
  for (const SurfaceTrials& of : all_trials(request, models, replicas)) {
    ++surfaces;
    for (const Trial& trial : of.trials) {
      const brdf::QueryBounds bounds =
          bounds_of(request.sweep, trial.tolerance.value_or(TradeoffReference::tolerance));
      try {
        largest = std::max(largest, method_named(trial.method)
                                        .bytes(request.surface(of.model, of.replicas), bounds,
                                               trial.settings(request.limits.threads)));
      } catch (const brdf::Error&) {  // it will refuse when it runs
      }
    }
  }
  // Of each cell: an amplitude for each surface; beside them those of a run, its queries, powers
  // and responses, and their axes.
  return largest +
         request.sweep.cells() * (surfaces * sizeof(std::complex<double>) + 16 * sizeof(double));
}

void mark_frontier(std::vector<TradeoffRow>& rows) {
  const auto beats = [](const TradeoffRow& a, const TradeoffRow& b) {
    const double a_s = a.time.total_s(), b_s = b.time.total_s();
    const double a_error = a.errors.worst, b_error = b.errors.worst;
    return a.refused.empty() && same_surface(a.trial, b.trial) && a_s <= b_s &&
           a_error <= b_error && (a_s < b_s || a_error < b_error);
  };
  for (TradeoffRow& row : rows)
    row.on_frontier =
        row.refused.empty() &&
        std::ranges::none_of(rows, [&](const TradeoffRow& other) { return beats(other, row); });
}

std::optional<std::size_t> fastest_within(std::span<const TradeoffRow> rows,
                                          brdf::SurfaceModel model, brdf::Replicas replicas,
                                          double worst_error) {
  return least(
      rows, model, replicas,
      [&](const TradeoffRow& row) { return row.errors.worst <= worst_error; },
      [](const TradeoffRow& row) { return row.time.total_s(); });
}

std::optional<std::size_t> most_accurate_within(std::span<const TradeoffRow> rows,
                                                brdf::SurfaceModel model, brdf::Replicas replicas,
                                                double seconds) {
  return least(
      rows, model, replicas, [&](const TradeoffRow& row) { return row.time.total_s() <= seconds; },
      [](const TradeoffRow& row) { return row.errors.worst; });
}

}  // namespace evaluation
