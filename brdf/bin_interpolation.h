// Reading the transform of a tile between its bins.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "brdf/half_spectrum.h"
#include "brdf/pq_factors.h"
#include "brdf/surface.h"

namespace brdf {

/// What stands between two bins, on each axis alone; the weights of both axes are multiplied.
enum class BinInterpolation {
  nearest,  ///< the nearest bin
  linear,   ///< the two around it
  sinc,     ///< sin(pi d) / (pi d) over the nearest bin and its two neighbours (the sources; E15)
  exact,    ///< all bins, each by the Dirichlet kernel of the pixels: an identity
};

/// One axis of a tile's bins, the tile centred first (Errata E18).
///
/// Between the bins the transform of N samples is a(nu) = sum_j a_j D(nu - j) over any N bins in a
/// row, D(d) = sin(pi d) / (N sin(pi d / N)): pq_factor(d / N, N). The other choices take few bins
/// (Thesis 1.54, Implementation chapter).
class InterpolatedBins {
 public:
  InterpolatedBins(BinInterpolation interpolation, const SurfaceAxis& axis)
      : interpolation_(interpolation), axis_(axis) {
    if (interpolation != BinInterpolation::exact) return;
    // sin and cos of pi m / N times (-1)^m for one turn, from angles up to pi / 2: larger ones
    // would lose digits where the sine is small.
    for (long m = 0; m < 2 * count(); ++m) {
      const long k = m % count(), from_end = count() - k;
      const bool rising = k <= from_end;
      const double angle =
          pi * static_cast<double>(rising ? k : from_end) / static_cast<double>(count());
      const double sign = (m + m / count()) % 2 == 0 ? 1 : -1;
      sines_.push_back(sign * std::sin(angle));
      cosines_.push_back(sign * (rising ? std::cos(angle) : -std::cos(angle)));
    }
  }

  long first(double q_per_um) const { return first_at(axis_.cycles(q_per_um)); }
  long last(double q_per_um) const { return first(q_per_um) + stencil() - 1; }

  /// The weights of the bins from first to last, in that order; each within 5e-16.
  void weights(double q_per_um, std::span<double> weights) const {
    weights_at(axis_.cycles(q_per_um), weights);
  }

  std::complex<double> origin_phase(long bin) const {
    return brdf::origin_phase(bin, count() - 1, count());
  }

  /// Bins that a frequency needs.
  long stencil() const {
    switch (interpolation_) {
      case BinInterpolation::nearest:
        return 1;
      case BinInterpolation::linear:
        return 2;
      case BinInterpolation::sinc:
        return 3;
      case BinInterpolation::exact:
        break;
    }
    return count();
  }

  std::size_t bytes() const { return (sines_.size() + cosines_.size()) * sizeof(double); }

  /// sqrt(sum_j (w_j - D_j)^2) and sqrt(sum_j w_j^2), equal bins counted as one; at a frequency,
  /// and the largest over a range of them.
  struct Deviation {
    double error, norm;
  };

  /// Each times the factor of the copies, or above it, for any frequency from lo to hi. By
  /// Cauchy-Schwarz a tile of unit modulus, whose bins obey sum abs(a_j)^2 = 1, is read with at
  /// most this error along the axis. 0 and 1 for the exact sum.
  Deviation largest_deviation(double lo_per_um, double hi_per_um, int replicas) const {
    if (interpolation_ == BinInterpolation::exact) return {0, 1};
    if (lo_per_um == hi_per_um) {
      const double cycles = axis_.cycles(lo_per_um), factor = std::abs(pq_factor(cycles, replicas));
      const Deviation at = deviation(cycles);
      return {factor * at.error, factor * at.norm};
    }
    // Fractions of a bin from 1/2 downwards in steps of a twelfth of an octave: within a step the
    // factor is at most its envelope at the lower end, the error at most its largest at or below
    // the upper end. Below 2^-60 every choice reads the bin alone.
    constexpr int steps_an_octave = 12, octaves = 60;
    Deviation below{0, 1}, largest{0, 1};
    for (int step = steps_an_octave * octaves; step >= 0; --step) {
      const double lower = 0.5 * std::exp2(-(step + 1.0) / steps_an_octave);
      const double upper = 0.5 * std::exp2(-static_cast<double>(step) / steps_an_octave);
      const double envelope = std::min(1.0, 1 / (replicas * std::sin(pi * lower)));
      const Deviation at = deviation(upper);
      below = {std::max(below.error, at.error), std::max(below.norm, at.norm)};
      largest = {std::max(largest.error, envelope * below.error),
                 std::max(largest.norm, envelope * below.norm)};
    }
    return largest;
  }

 private:
  long count() const { return static_cast<long>(axis_.count); }

  long first_at(double position) const {
    switch (interpolation_) {
      case BinInterpolation::nearest:
        return std::lround(position);
      case BinInterpolation::linear:
        return static_cast<long>(std::floor(position));
      case BinInterpolation::sinc:
        return std::lround(position) - 1;
      case BinInterpolation::exact:
        break;
    }
    return -(count() / 2);
  }

  void weights_at(double position, std::span<double> weights) const {
    if (interpolation_ == BinInterpolation::exact) return dirichlet_weights(position, weights);
    long bin = first_at(position);
    for (double& weight : weights) weight = near_weight(position - static_cast<double>(bin++));
  }

  double near_weight(double distance) const {
    if (interpolation_ == BinInterpolation::nearest) return 1;
    if (interpolation_ == BinInterpolation::linear) return 1 - std::abs(distance);
    return distance == 0 ? 1 : std::sin(pi * distance) / (pi * distance);
  }

  /// D(m + t) = (-1)^m sin(pi t) / (N sin(pi (m + t) / N)), m = nearest - bin: one sine for all
  /// bins, those of m / N from a table with their sign (-1)^m.
  void dirichlet_weights(double position, std::span<double> weights) const {
    const double nearest = std::round(position), t = position - nearest;
    const auto n = static_cast<double>(count());
    const double top = std::sin(pi * t) / n;
    const double sine = std::sin(pi * t / n), cosine = std::cos(pi * t / n);
    const double on_bin = pq_factor(t / n, static_cast<int>(count()));
    const long turn = 2 * count();
    long m = (static_cast<long>(nearest) - first_at(position)) % turn;
    if (m < 0) m += turn;
    for (double& weight : weights) {
      if (m % count() == 0)
        weight = m == 0 || count() % 2 != 0 ? on_bin : -on_bin;
      else
        weight = top / (sines_[m] * cosine + cosines_[m] * sine);
      m = m == 0 ? turn - 1 : m - 1;
    }
  }

  /// By the products of the kernels, sum_n D(n - i) D(n - k) = D(i - k).
  Deviation deviation(double position) const {
    const auto kernel = [&](double bins) {
      return pq_factor(bins / static_cast<double>(count()), static_cast<int>(count()));
    };
    std::vector<double> w(static_cast<std::size_t>(stencil()));
    weights_at(position, w);
    double norm_squared = 0, overlap = 0;
    for (std::size_t i = 0; i < w.size(); ++i) {
      const auto bin = static_cast<double>(first_at(position) + static_cast<long>(i));
      overlap += w[i] * kernel(position - bin);
      for (std::size_t k = 0; k < w.size(); ++k)
        norm_squared += w[i] * w[k] * kernel(static_cast<double>(i) - static_cast<double>(k));
    }
    // Rounding may bring the difference below 0.
    return {std::sqrt(std::abs(norm_squared - 2 * overlap + 1)), std::sqrt(norm_squared)};
  }

  BinInterpolation interpolation_;
  SurfaceAxis axis_;
  std::vector<double> sines_, cosines_;
};

}  // namespace brdf
