// The neighbours of a query in the sources' algorithm, and their weights.
#pragma once

#include <cmath>

#include "benchmarks/sources_algorithm.h"
#include "brdf/error.h"
#include "brdf/surface.h"
#include "brdf/units.h"

namespace benchmarks {

/// The bins of one axis within 4 sigma_f of a frequency, and their weights.
class AxisWindow {
 public:
  static constexpr int max_bins = 16;

  AxisWindow(const brdf::Surface& surface, const brdf::SurfaceAxis& axis)
      : bins_per_q_(axis.pixel_um * static_cast<double>(axis.count) / (2 * brdf::pi)) {
    const double sigma_bins = surface.window.sigma_f_per_um() * bins_per_q_ * 2 * brdf::pi;
    radius_ = sources_radius_sigma_f * sigma_bins;
    if (!(2 * radius_ + 1 < max_bins))
      throw brdf::Error(brdf::Errc::invalid_argument, "window too narrow for the benchmark");
    exponent_ = 1 / (2 * sigma_bins * sigma_bins);
    for (int j = 0; j <= max_bins; ++j)
      at_bin_[j] = std::exp(-exponent_ * (j - middle) * (j - middle));
  }

  struct Bins {
    long first;
    int count;
    double weights[max_bins];
  };

  /// exp(-e (x - j)^2) = exp(-e d^2) exp(2 e d)^m exp(-e m^2), with m = j - round(x).
  Bins at(double q_per_um) const {
    const double x = q_per_um * bins_per_q_, centre = std::nearbyint(x), d = x - centre;
    Bins bins;
    bins.first = static_cast<long>(std::ceil(x - radius_));
    bins.count = static_cast<int>(static_cast<long>(std::floor(x + radius_)) - bins.first + 1);
    const double ratio = std::exp(2 * exponent_ * d), inverse = 1 / ratio;
    int m = static_cast<int>(bins.first - static_cast<long>(centre));
    double power = std::exp(-exponent_ * d * d);
    for (int j = m; j < 0; ++j) power *= inverse;
    for (int i = 0; i < bins.count; ++i, ++m, power *= ratio)
      bins.weights[i] = power * at_bin_[m + middle];
    return bins;
  }

 private:
  static constexpr int middle = max_bins / 2;
  double bins_per_q_, radius_, exponent_, at_bin_[max_bins + 1];
};

}  // namespace benchmarks
