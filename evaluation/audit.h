// A sample of a request's cells, computed again by definition.
#pragma once

#include <cstddef>

#include "evaluation/cell_selection.h"
#include "evaluation/methods.h"
#include "evaluation/sweep.h"

namespace evaluation {

/// What an audit found: the largest error of the normalised amplitude, and where.
struct Audit {
  std::size_t cells;
  double worst_error;
  double lambda_nm, theta_r_deg;
};

/// Holds `wanted` of the evaluated cells against the direct sum.
///
/// The cells follow the golden-ratio sequence over the selection: spread evenly, the same in every
/// run. Cost: one direct sum each. An error that is no number counts as infinite.
Audit audit(const SweepRequest& request, const CellSelection& cells, const brdf::Surface& surface,
            const Amplitude& amplitude, std::size_t wanted, const RunLimits& limits);

}  // namespace evaluation
