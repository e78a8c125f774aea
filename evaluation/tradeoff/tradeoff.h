// Speed against accuracy of every method on one request, measured.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "evaluation/tradeoff/measure.h"

namespace evaluation {

/// What was measured of a trial.
struct TradeoffRow {
  Trial trial;
  TrialTime time{};  ///< medians over the runs, each by itself
  int runs = 0;
  std::size_t cells_timed = 0;
  std::optional<std::size_t> peak_bytes = {};  ///< held at most by plan and queries, first run
  int terms_used = 0;                          ///< 0 where the method has none
  std::string storage = {};
  TrialErrors errors = {};
  bool on_frontier = false;  ///< of its surface: none is both faster and more accurate
  std::string refused = {};  ///< why the method would not; then nothing else is known
};

/// One reference, and how far it is from the direct sum.
struct ReferenceAudit {
  brdf::SurfaceModel model;
  brdf::Replicas replicas;
  double worst_error;
};

struct Tradeoff {
  std::vector<TradeoffRow> rows;
  std::vector<ReferenceAudit> references;
};

/// How trials are repeated.
struct TradeoffSchedule {
  int repeats = 5;         ///< rounds
  std::uint64_t seed = 1;  ///< of the order of the runs
  /// No further round begins after it; the first one, which finds the errors, always ends.
  std::chrono::duration<double> rounds_end = std::chrono::seconds(80);
};

/// Runs the trials of each surface model (of the replicated one also with one copy and with
/// four times as many, at the usual knobs) in rounds, each round in another order: a drift of the
/// machine's speed then meets all of them alike. A trial whose runs took 3 s is not repeated
/// further.
///
/// Freed memory is given back before each run, so that all pay for theirs. Times differ from run
/// to run, of course; errors do not.
Tradeoff tradeoff(const TradeoffRequest& request, std::span<const brdf::SurfaceModel> models,
                  brdf::Replicas replicas, const TradeoffSchedule& schedule,
                  const Progress& progress = {});

/// The most that the trials hold at once: the largest plan, and what is kept of all cells for each
/// surface.
std::size_t bytes_needed(const TradeoffRequest& request, std::span<const brdf::SurfaceModel> models,
                         brdf::Replicas replicas);

/// Marks in each group of one surface the rows that no other beats in both time and worst error.
void mark_frontier(std::vector<TradeoffRow>& rows);

/// The fastest row of a surface model whose worst error is at most that; empty where there is none.
std::optional<std::size_t> fastest_within(std::span<const TradeoffRow> rows,
                                          brdf::SurfaceModel model, brdf::Replicas replicas,
                                          double worst_error);

/// The most accurate row of a surface model that takes at most that long.
std::optional<std::size_t> most_accurate_within(std::span<const TradeoffRow> rows,
                                                brdf::SurfaceModel model, brdf::Replicas replicas,
                                                double seconds);

/// One line a row, numbered from 1: what `sweep --like` reads, and what was measured.
std::string to_csv(std::span<const TradeoffRow> rows);

/// The trial of a row. Throws Errc::bad_input naming file, line, column and value for what is no
/// such table, and Errc::invalid_argument for a row that it does not have.
Trial trial_from_csv(std::string_view csv, const std::string& name, std::size_t row);

}  // namespace evaluation
