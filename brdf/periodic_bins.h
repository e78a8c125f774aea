// Which Fourier bins of a periodic patch a frequency needs, and with what weights.
#pragma once

#include <cmath>
#include <complex>
#include <span>

#include "brdf/half_spectrum.h"
#include "brdf/surface.h"

namespace brdf {

/// One axis of the periodic model in the frequency domain.
///
/// A periodic patch has lines at f_j = j / L only; under the window each becomes a Gaussian
/// (Thesis 1.33, 1.34), so a(f) = sum_j (DFT_j / N) W(f - f_j) with W of peak 1. The sum runs over
/// all integers j, DFT_j repeating with period N: for the sampled surface this is exact. Neighbours
/// farther than radius sigma_f are left out.
class PeriodicBins {
 public:
  /// radius: in sigma_f, > 0.
  PeriodicBins(const GaussianWindow& window, const SurfaceAxis& axis, double radius_sigma_f)
      : window_(window),
        axis_(axis),
        length_um_(axis.length_um()),
        radius_bins_(radius_sigma_f * window.sigma_f_per_um() * length_um_) {
    double aliases = 0;
    const int reach =
        1 + static_cast<int>(detail::window_reach_sigma * axis.pixel_um * window.sigma_f_per_um());
    for (int alias = -reach; alias <= reach; ++alias) {
      const double w = window.spectral(static_cast<double>(alias) / axis.pixel_um);
      aliases += origin_between_pixels() && alias % 2 != 0 ? -w : w;
    }
    norm_ = 1 / aliases;
  }

  long first(double q_per_um) const {
    return static_cast<long>(std::ceil(position(q_per_um) - radius_bins_));
  }
  long last(double q_per_um) const {
    return static_cast<long>(std::floor(position(q_per_um) + radius_bins_));
  }
  /// Most neighbours that any frequency has.
  long max_count() const { return static_cast<long>(2 * radius_bins_) + 1; }

  /// W(f - j / L), over sum g = sum of the window's own aliases: with signs where the origin lies
  /// between two pixels.
  double weight(double q_per_um, long bin) const {
    return norm_ * window_.spectral((position(q_per_um) - static_cast<double>(bin)) / length_um_);
  }

  /// The weights of the bins from first to last, in that order.
  void weights(double q_per_um, std::span<double> weights) const {
    long bin = first(q_per_um);
    for (double& w : weights) w = weight(q_per_um, bin++);
  }

  /// Moves the transform's origin to the surface's.
  std::complex<double> origin_phase(long bin) const {
    return brdf::origin_phase(bin, origin_half_pixels(), axis_.count);
  }

  /// Bounds over all frequencies: sum of W^2 over all bins, and over those left out.
  double weight_energy() const { return energy_from(0) * 2 - 1; }
  double omitted_energy() const { return 2 * energy_from(radius_bins_); }

 private:
  long origin_half_pixels() const { return std::lround(2 * axis_.origin); }
  bool origin_between_pixels() const { return origin_half_pixels() % 2 != 0; }

  /// Frequency in bins.
  double position(double q_per_um) const { return axis_.cycles(q_per_um); }

  double energy_from(double start_bins) const {
    double energy = 0;
    for (double bin = start_bins;; ++bin) {
      const double w = window_.spectral(bin / length_um_);
      if (w * w <= 1e-40) return energy;  // far below the square of any rounding
      energy += w * w;
    }
  }

  GaussianWindow window_;
  SurfaceAxis axis_;
  double length_um_, radius_bins_, norm_;
};

/// Bound on the amplitude's error from the neighbours left out, in both axes.
///
/// The bins of a surface of unit modulus obey sum abs(DFT / N^2)^2 = 1, so by Cauchy-Schwarz the
/// part left out is at most the root of the sum of its squared weights.
inline double omitted_neighbours_bound(const PeriodicBins& x, const PeriodicBins& y) {
  return std::sqrt(x.omitted_energy() * y.weight_energy() + y.omitted_energy() * x.weight_energy());
}

}  // namespace brdf
