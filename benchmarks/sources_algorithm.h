// The algorithm of the sources, as fast as it goes: what the Chebyshev series has to beat.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

#include "brdf/amplitude.h"

namespace benchmarks {

/// How FFTW plans its transforms. Planning is not timed with `measure`, which takes seconds.
enum class Planning { estimate, measure };

/// Seconds of the thread's processor time spent in each part.
struct SourcesTimes {
  double planning_s = 0;      ///< of the transforms; counted with Planning::estimate only
  double transforms_s = 0;    ///< powers of the heights and their transforms
  double interleaving_s = 0;  ///< spectra to entries [bin][term]
  double gather_s = 0;        ///< all queries
};

inline constexpr int sources_terms = 30;
inline constexpr double sources_radius_sigma_f = 4;

/// a = e^{i c h_mid} sum_n (i c)^n / n! sum_bins DFT((h - h_mid)^n) / pixels W, 30 terms, every bin
/// within 4 sigma_f along each axis at every query, periodic model (Thesis 1.24, 1.34, 1.37).
///
/// What the sources do, without their detours: real transforms, half of each spectrum kept, the 30
/// terms of a bin side by side in whole cache lines, two exponentials per axis and query for all
/// weights, sums over terms in vectors. Real: float, the faster, whose rounding is far below the
/// neighbours left out; or double. One thread.
template <class Real>
class SourcesAlgorithm {
 public:
  /// Makes the tables.
  SourcesAlgorithm(const brdf::Surface& surface, Planning planning);
  ~SourcesAlgorithm();

  void evaluate(std::span<const brdf::Query> queries, std::span<std::complex<double>> amplitudes);

  /// Of the tables and of the last `evaluate`.
  const SourcesTimes& times() const { return times_; }
  /// Planning (where it is counted), tables and gather.
  double total_s() const;
  std::size_t bytes() const;

 private:
  struct Tables;
  Planning planning_;
  SourcesTimes times_;
  std::unique_ptr<Tables> tables_;
};

}  // namespace benchmarks
