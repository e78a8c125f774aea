// The parts of a Chebyshev plan, and what may be tuned.
#pragma once

#include <cstddef>
#include <functional>

namespace brdf {

/// How a plan turns pixels into amplitudes.
enum class SeriesPath {
  direct_sum,  ///< pixel by pixel: fewer queries than a transform is worth
  in_plane,    ///< one plane of incidence: the axis across it summed, 1-D transforms along it
  general,     ///< 2-D transforms
};

enum class TableStorage { single_precision, double_precision };

/// The parts of a plan, for a person to read. `Axis` 0 is x or the line in the plane of incidence.
struct SeriesPlanParts {
  struct Axis {
    int width = 1;               ///< taps of the kernel
    double oversampling = 1;     ///< grid points per sample
    std::size_t fft_length = 0;  ///< 0: summed away
    std::size_t stored = 1;      ///< grid points kept
  };
  SeriesPath path;
  TableStorage storage;
  int terms;
  Axis axes[2];
  bool projected = false;               ///< in_plane off the axes: pixels projected on a line
  std::size_t table_bytes, peak_bytes;  ///< kept; most held while planning
  double series_error, kernel_error, storage_error, rounding_error;  ///< sum: the error bound
  double plan_s, query_s;  ///< expected, one thread of about 3 GHz with vectorised kernels
};

/// Who answers requests of so few queries that a transform is not worth while.
enum class SmallRequests { by_direct_sum, by_series };

/// Calls task(i) for every i in [0, count), each once, in any order and from any threads, and
/// returns when all are done. Work is cut into the same tasks whoever runs them, and what they give
/// is put together in one order, so that plans are bit-identical for any executor.
using Executor =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

/// In the calling thread, one after the other.
inline void run_serially(std::size_t count, const std::function<void(std::size_t)>& task) {
  for (std::size_t i = 0; i < count; ++i) task(i);
}

/// What a user of the method may tune.
struct SeriesSettings {
  SmallRequests small_requests = SmallRequests::by_direct_sum;
  /// Larger tables are kept in single precision where the tolerance allows it. Sums are in double
  /// either way, and doubles are read faster than floats are converted, until memory counts.
  std::size_t double_table_bytes = std::size_t{256} << 20;
  Executor executor = run_serially;  ///< spreads the work of making a plan over threads
};

}  // namespace brdf
