// The one loop over wavelength and viewing angle.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "evaluation/cell_selection.h"
#include "evaluation/chunk_store.h"
#include "evaluation/reflectance.h"
#include "evaluation/response_matrix.h"
#include "evaluation/sweep_request.h"

namespace evaluation {

/// How long a run may take.
struct TimeLimit {
  std::chrono::steady_clock::time_point start;
  std::chrono::duration<double> length;

  bool passed() const { return std::chrono::steady_clock::now() - start > length; }
  /// Throws Errc::over_limit. where: " at ...", or nothing.
  [[noreturn]] void refuse(const std::string& where = {},
                           const std::string& left = "nothing was written") const;
};

/// What a run may use.
struct RunLimits {
  int threads = 1;
  std::optional<TimeLimit> time = {};
  ChunkStore* chunks = nullptr;  ///< keeps what is done, where there is one

  /// Throws Errc::over_limit past the time limit. where: " at ...", or nothing.
  void check_time(const std::string& where = {}) const {
    if (!time || !time->passed()) return;
    time->refuse(where, chunks != nullptr ? chunks->kept() : "nothing was written");
  }
};

/// Called now and then with the part done, 0 to 1, never from two threads at once.
using Progress = std::function<void(double)>;

/// Evaluates the cells of the selection; the others are exactly 0. Bit-identical for any number of
/// threads, and a cell has the same bits in every selection.
///
/// Throws Errc::over_limit past the time limit; Errc::not_attainable for a cell that is not finite.
ResponseMatrix sweep(const SweepRequest& request, const Reflectance& reflectance,
                     const CellSelection& cells, const RunLimits& limits,
                     const Progress& progress = {});

/// All cells.
inline ResponseMatrix sweep(const SweepRequest& request, const Reflectance& reflectance,
                            const RunLimits& limits, const Progress& progress = {}) {
  return sweep(request, reflectance, CellSelection::all(request), limits, progress);
}

}  // namespace evaluation
