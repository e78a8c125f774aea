// A sample of a request's cells, computed again by definition.
#pragma once

#include <cstddef>
#include <span>

#include "evaluation/cell_selection.h"
#include "evaluation/methods.h"
#include "evaluation/sweep.h"

namespace evaluation {

/// Some queries held against the direct sum: the largest error of the normalised amplitude, and
/// which of them has it. An error that is no number counts as infinite.
struct QueryAudit {
  std::size_t queries;
  double worst_error;
  std::size_t worst;
};
QueryAudit audit(std::span<const brdf::Query> queries, const brdf::Surface& surface,
                 const Amplitude& amplitude, const RunLimits& limits);

/// The i-th of things spread evenly over `count` of them by the golden-ratio sequence; i = 0, 1,
/// ...
std::size_t evenly_spread(std::size_t i, std::size_t count);

/// What an audit of a sweep found: the largest error of the normalised amplitude, and where.
struct Audit {
  std::size_t cells;
  double worst_error;
  double lambda_nm, theta_r_deg;
};

/// Holds `wanted` of the evaluated cells against the direct sum.
///
/// The cells follow the golden-ratio sequence over the selection: spread evenly, the same in every
/// run. Cost: one direct sum each.
Audit audit(const SweepRequest& request, const CellSelection& cells, const brdf::Surface& surface,
            const Amplitude& amplitude, std::size_t wanted, const RunLimits& limits);

}  // namespace evaluation
