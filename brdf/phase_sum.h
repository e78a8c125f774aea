// The two loops in which the direct sum spends its time.
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>

namespace brdf {

/// One row of a height field and the complex weights of its columns. All arrays have `count`
/// entries.
struct PhaseRow {
  const double* heights_um;
  const double* weight_re;
  const double* weight_im;
  std::size_t count;
  double mid_um;         ///< taken off the heights
  double half_range_um;  ///< no height lies farther than this from mid_um
  double c_per_um;
};

/// Points of one axis, in ascending order, and the illumination there.
struct PhasePoints {
  const double* x_um;
  const double* illumination;
  std::size_t count;
};

/// `row_sum` returns sum_j w_j exp(i c (h_j - mid)); `add_phasors` adds g_j exp(i q x_j) to
/// (re, im)[j]. Both are pure functions of their arguments: a sum depends on its query only.
struct PhaseKernels {
  std::complex<double> (*row_sum)(const PhaseRow&);
  void (*add_phasors)(const PhasePoints&, double q_per_um, double* re, double* im);
};

/// See PhaseKernels.
inline std::complex<double> portable_row_sum(const PhaseRow& row) {
  double re = 0, im = 0;
  for (std::size_t j = 0; j < row.count; ++j) {
    const double phase = row.c_per_um * (row.heights_um[j] - row.mid_um);
    const double cosine = std::cos(phase), sine = std::sin(phase);
    re += row.weight_re[j] * cosine - row.weight_im[j] * sine;
    im += row.weight_re[j] * sine + row.weight_im[j] * cosine;
  }
  return {re, im};
}

/// See PhaseKernels.
inline void portable_add_phasors(const PhasePoints& points, double q_per_um, double* re,
                                 double* im) {
  for (std::size_t j = 0; j < points.count; ++j) {
    const double phase = q_per_um * points.x_um[j];
    re[j] += points.illumination[j] * std::cos(phase);
    im[j] += points.illumination[j] * std::sin(phase);
  }
}

/// Plain C++, on any machine; shedlight::kernels has the vectorised ones, the same to 1e-13 of the
/// normalised amplitude.
inline constexpr PhaseKernels portable_phase_kernels{portable_row_sum, portable_add_phasors};

}  // namespace brdf
