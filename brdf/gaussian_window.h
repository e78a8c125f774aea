// The coherence window of the illumination.
#pragma once

#include <cmath>

#include "brdf/error.h"
#include "brdf/units.h"

namespace brdf {

/// Gaussian coherence window g(x, y) = exp(-(x^2 + y^2) / (2 sigma_s^2)) (Thesis 1.33).
///
/// Its transform, of peak 1, at the frequency f in cycles/um is exp(-f^2 / (2 sigma_f^2)) with
/// sigma_f = 1 / (2 pi sigma_s). Both factor into x and y, so the functions take one axis.
class GaussianWindow {
 public:
  /// sigma: > 0 and finite, else Errc::invalid_argument.
  explicit GaussianWindow(Length sigma) : sigma_um_(sigma.um()) {
    if (!(sigma_um_ > 0 && std::isfinite(sigma_um_)))
      throw Error(Errc::invalid_argument,
                  "coherence sigma " + text(sigma_um_) + " um must be > 0 and finite");
  }

  double sigma_um() const { return sigma_um_; }
  /// Standard deviation of the transform [cycles/um].
  double sigma_f_per_um() const { return 1 / (2 * pi * sigma_um_); }

  double spatial(double x_um) const { return std::exp(-0.5 * square(x_um / sigma_um_)); }
  double spectral(double frequency_per_um) const {
    return std::exp(-0.5 * square(2 * pi * sigma_um_ * frequency_per_um));
  }

 private:
  static double square(double value) { return value * value; }
  double sigma_um_;
};

}  // namespace brdf
