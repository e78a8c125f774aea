// The table a Chebyshev plan reads its amplitudes from, and the two inner loops of the method.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

#include "brdf/amplitude.h"
#include "brdf/interpolation_kernel.h"
#include "brdf/phase_sum.h"

namespace brdf {

/// One frequency axis of a table: where a query lies on its grid, and its kernel.
struct TableAxis {
  double grid_per_qx_um, grid_per_qy_um;  ///< grid position = qx ... + qy ...
  long first;                             ///< grid point of the first entry
  long count;                             ///< stored grid points
  int width;                              ///< of the kernel; 1: a single entry of weight 1
  int degree, pieces, tap_stride;         ///< see InterpolationKernel
  const double* coefficients;
  long period;       ///< grid points after which the entries repeat
  double turn_sign;  ///< times this: 1 or -1
};

/// Terms F_r at the grid points: entries[outer][inner][r] as (re, im), r < terms, rows filled up to
/// a whole number of `term_step` terms with zeros.
///
/// a = e^{i (phase_per_c c + phase_per_qx qx + phase_per_qy qy)} sum_r u_r((c - c_mid) per_c)
///     sum_taps psi psi F_r, u_r = T_r or, with a basis, sum_n basis[r][n] T_n, n < degrees, over
/// the even n where r < even_terms and over the odd ones else.
/// Sums are in double whatever the storage.
template <class Real>
struct TermTable {
  static constexpr int term_step = 4;
  static constexpr int max_degrees = 80;  ///< with a basis
  const Real* entries;
  TableAxis outer, inner;
  int terms;
  const double* basis;  ///< [r < padded_terms][n < degrees]; null: T_r
  int degrees, even_terms;
  double c_mid_per_um, per_c_um;
  double phase_per_c_um, phase_per_qx_um, phase_per_qy_um;

  int padded_terms() const { return (terms + term_step - 1) / term_step * term_step; }
};

/// Pixels to be summed along one axis: lane l of step j is first[j * stride + l].
struct PixelStrip {
  static constexpr int lanes = 8;
  const double* first_um;
  std::ptrdiff_t stride;
  std::size_t steps;
  const double* weights;             ///< one per step
  double mid_um, per_half_range_um;  ///< s = (h - mid) per_half_range
};

/// Where pixels are spread to: samples[n * stride + m] of degree m at grid point n, stride at least
/// `degrees` and a whole number of `step`.
struct SpreadLine {
  static constexpr int step = 8;
  TableAxis axis;  ///< of the grid points, from 0
  int degrees;
  std::size_t stride;
  double* samples;
};

/// The loops that take the time. `moments` sets sums[m][lane] = sum_j w_j T_m(s) for m < degrees;
/// `spread` adds moments[m][lane] of `count` pixels at grid positions, times weights, to the grid
/// points about them; moments up to the stride, positions and weights of all lanes can be read.
/// `phases` are those of the direct sum of small requests. All are pure functions of their
/// arguments: an amplitude depends on its query and the table only.
struct SeriesKernels {
  void (*gather_float)(const TermTable<float>&, const Query*, std::size_t, std::complex<double>*);
  void (*gather_double)(const TermTable<double>&, const Query*, std::size_t, std::complex<double>*);
  void (*moments)(const PixelStrip&, int degrees, double* sums);
  void (*spread)(const SpreadLine&, const double* positions, const double* weights, int count,
                 const double* moments);
  PhaseKernels phases;
  double direct_pixel_s;  ///< expected time of the direct sum per pixel and query
};

namespace detail {

/// Weights of one query along one axis and the first entry that they belong to.
///
/// Whole periods are taken off the grid point, a sign per period goes to the weights.
inline std::size_t axis_taps(const TableAxis& axis, const Query& q, std::vector<double>& taps) {
  if (axis.width == 1) {
    taps[0] = 1;
    return 0;
  }
  const double start =
      q.qx_per_um * axis.grid_per_qx_um + q.qy_per_um * axis.grid_per_qy_um - 0.5 * axis.width;
  const double k0 = std::ceil(start), scaled = (k0 - start) * axis.pieces;
  const double piece = std::min(std::floor(scaled), axis.pieces - 1.0),
               t = 2 * (scaled - piece) - 1;
  const double* coefficients =
      axis.coefficients + static_cast<long>(piece) * (axis.degree + 1) * axis.tap_stride;
  std::fill(taps.begin(), taps.end(), 0.0);
  for (int power = axis.degree; power >= 0; --power)
    for (int tap = 0; tap < axis.width; ++tap) {
      double& weight = taps[static_cast<std::size_t>(tap)];
      weight = weight * t + coefficients[power * axis.tap_stride + tap];
    }
  const double last = static_cast<double>(axis.count - axis.width);
  const double period = static_cast<double>(axis.period);
  const double local = k0 - static_cast<double>(axis.first), turns = std::floor(local / period);
  if (axis.turn_sign < 0 && std::fmod(turns, 2) != 0)
    for (double& weight : taps) weight = -weight;
  return static_cast<std::size_t>(std::clamp(local - turns * period, 0.0, last));
}

}  // namespace detail

/// Amplitudes of some queries from a table; one query after the other.
template <class Real>
void portable_gather(const TermTable<Real>& table, const Query* queries, std::size_t count,
                     std::complex<double>* amplitudes) {
  const auto row = static_cast<std::size_t>(2 * table.padded_terms());
  std::vector<double> sums(row), chebyshev(static_cast<std::size_t>(table.degrees)),
      outer_taps(InterpolationKernel::max_width), inner_taps(InterpolationKernel::max_width);
  for (std::size_t i = 0; i < count; ++i) {
    const Query& q = queries[i];
    const std::size_t outer = detail::axis_taps(table.outer, q, outer_taps);
    const std::size_t inner = detail::axis_taps(table.inner, q, inner_taps);
    std::fill(sums.begin(), sums.end(), 0.0);
    for (int o = 0; o < table.outer.width; ++o)
      for (int k = 0; k < table.inner.width; ++k) {
        const double weight =
            outer_taps[static_cast<std::size_t>(o)] * inner_taps[static_cast<std::size_t>(k)];
        const Real* entry = table.entries + ((outer + static_cast<std::size_t>(o)) *
                                                 static_cast<std::size_t>(table.inner.count) +
                                             inner + static_cast<std::size_t>(k)) *
                                                row;
        for (std::size_t n = 0; n < row; ++n) sums[n] += weight * static_cast<double>(entry[n]);
      }
    const double tau = (q.c_per_um - table.c_mid_per_um) * table.per_c_um;
    double previous = tau;  // T_{-1} = T_1
    chebyshev[0] = 1;
    for (std::size_t n = 1; n < chebyshev.size(); ++n) {
      chebyshev[n] = 2 * tau * chebyshev[n - 1] - previous;
      previous = chebyshev[n - 1];
    }
    double re = 0, im = 0;
    for (int r = 0; r < table.terms; ++r) {
      double u = table.basis == nullptr ? chebyshev[static_cast<std::size_t>(r)] : 0;
      if (table.basis != nullptr)
        for (int n = r < table.even_terms ? 0 : 1; n < table.degrees; n += 2)
          u += table.basis[r * table.degrees + n] * chebyshev[static_cast<std::size_t>(n)];
      re += u * sums[static_cast<std::size_t>(2 * r)];
      im += u * sums[static_cast<std::size_t>(2 * r + 1)];
    }
    const double phase = table.phase_per_c_um * q.c_per_um + table.phase_per_qx_um * q.qx_per_um +
                         table.phase_per_qy_um * q.qy_per_um;
    const double cosine = std::cos(phase), sine = std::sin(phase);
    amplitudes[i] = {re * cosine - im * sine, re * sine + im * cosine};
  }
}

/// See SeriesKernels.
inline void portable_moments(const PixelStrip& strip, int degrees, double* sums) {
  constexpr int lanes = PixelStrip::lanes;
  std::fill(sums, sums + lanes * degrees, 0.0);
  for (std::size_t j = 0; j < strip.steps; ++j) {
    double s[lanes], previous[lanes], current[lanes];  // times the weight
    for (int l = 0; l < lanes; ++l) {
      s[l] = (strip.first_um[static_cast<std::ptrdiff_t>(j) * strip.stride + l] - strip.mid_um) *
             strip.per_half_range_um;
      previous[l] = strip.weights[j] * s[l];  // T_{-1} = T_1
      current[l] = strip.weights[j];
    }
    for (int m = 0; m < degrees; ++m)
      for (int l = 0; l < lanes; ++l) {
        sums[m * lanes + l] += current[l];
        previous[l] = std::exchange(current[l], 2 * s[l] * current[l] - previous[l]);
      }
  }
}

/// See SeriesKernels.
inline void portable_spread(const SpreadLine& line, const double* positions, const double* weights,
                            int count, const double* moments) {
  std::vector<double> taps(InterpolationKernel::max_width);
  for (int l = 0; l < count; ++l) {
    double* to =
        line.samples + detail::axis_taps(line.axis, {positions[l], 0, 0}, taps) * line.stride;
    for (int tap = 0; tap < line.axis.width; ++tap, to += line.stride) {
      const double share = weights[l] * taps[static_cast<std::size_t>(tap)];
      for (int m = 0; m < line.degrees; ++m) to[m] += share * moments[m * PixelStrip::lanes + l];
    }
  }
}

/// Plain C++, on any machine; shedlight::kernels has the vectorised ones, the same to 1e-13.
inline constexpr SeriesKernels portable_kernels{portable_gather<float>, portable_gather<double>,
                                                portable_moments,       portable_spread,
                                                portable_phase_kernels, 15e-9};

}  // namespace brdf
