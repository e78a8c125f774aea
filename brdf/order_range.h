// Nmin and Nmax: which orders of a grating a band of wavelengths can show in one direction.
#pragma once

#include <algorithm>
#include <cmath>

#include "brdf/amplitude.h"
#include "brdf/surface.h"

namespace brdf {

/// Whole orders from first to last, without their sign: that of u.
struct OrderRange {
  double first, last;  ///< whole numbers; empty where last < first
  bool empty() const { return !(first <= last); }
};

namespace detail {

/// Orders whose lobe of the given halfwidth touches frequencies from lo to hi [cycles/um].
inline OrderRange orders_within(double lo_per_um, double hi_per_um, double period_um,
                                double halfwidth_per_um) {
  return {std::max(0.0, std::ceil(period_um * (lo_per_um - halfwidth_per_um))),
          std::floor(period_um * (hi_per_um + halfwidth_per_um))};
}

}  // namespace detail

/// The orders n >= 0 with a wavelength lambda_n = d abs(u) / n near the band:
/// ceil(d (abs(u) / lambda_max - b)) <= n <= floor(d (abs(u) / lambda_min + b)), b the halfwidth of
/// a lobe (Implementation chapter, "Nmin/Nmax", corrected by Erratum E8: the same for both signs of
/// u, and with n = 0, which holds all wavelengths where abs(u) <= b lambda).
///
/// u: component of the scattering vector along the grating vector, finite.
/// lambda_min <= lambda_max, period: > 0; halfwidth_per_um: >= 0, cycles/um. Else
/// Errc::invalid_argument.
inline OrderRange order_range(double u, Length lambda_min, Length lambda_max, Length period,
                              double halfwidth_per_um) {
  if (!(lambda_min.um() > 0 && lambda_min <= lambda_max))
    throw Error(Errc::invalid_argument, "wavelengths " + text(lambda_min.um()) + " to " +
                                            text(lambda_max.um()) + " um must be > 0 and ascend");
  if (!(period.um() > 0 && std::isfinite(period.um())))
    throw Error(Errc::invalid_argument, "period " + text(period.um()) + " um must be > 0");
  if (!(halfwidth_per_um >= 0 && std::isfinite(u)))
    throw Error(Errc::invalid_argument, "halfwidth " + text(halfwidth_per_um) +
                                            " /um must be >= 0, u " + text(u) + " finite");
  return detail::orders_within(std::abs(u) / lambda_max.um(), std::abs(u) / lambda_min.um(),
                               period.um(), halfwidth_per_um);
}

/// Where a grating of known period can send light: around its orders, as far as the coherence
/// window widens them. A selection of queries, not a method: what lies outside is not zero, only
/// far down the lobes.
class OrderBands {
 public:
  /// Periods along the grating vector and across it; a grating of lines has only the first, and
  /// its orders lie where the frequency across is within one halfwidth of 0.
  struct Lattice {
    Length along;
    Length across = {};  ///< 0: a grating of lines
    Angle azimuth = {};  ///< of the grating vector, from +x towards +y
  };

  /// radius: > 0, in sigma_f of the window; in the replicated model, which has none, in zeros of
  /// its lobes, 1 / length of the whole surface. Errc::invalid_argument for a period that is not
  /// positive and finite, or a radius that is not positive.
  OrderBands(const Surface& surface, const Lattice& lattice, double radius)
      : lattice_(lattice),
        cosine_(std::cos(lattice.azimuth.rad())),
        sine_(std::sin(lattice.azimuth.rad())) {
    if (!(lattice.along.um() > 0 && std::isfinite(lattice.along.um()) && lattice.across.um() >= 0 &&
          std::isfinite(lattice.across.um())))
      throw Error(Errc::invalid_argument, "period " + text(lattice.along.um()) + "," +
                                              text(lattice.across.um()) +
                                              " um must be > 0 and finite");
    if (!(radius > 0 && std::isfinite(radius)))
      throw Error(Errc::invalid_argument, "band radius " + text(radius) + " must be > 0");
    const double x_per_um = radius * lobe_per_um(surface, x_axis(surface)),
                 y_per_um = radius * lobe_per_um(surface, y_axis(surface));
    resolution_per_um_ = std::min(x_per_um, y_per_um) / radius;
    if (surface.model == SurfaceModel::replicated) {
      resolution_per_um_ /= 2;
      // A lobe is the rectangle of both halfwidths.
      along_per_um_ = std::abs(cosine_) * x_per_um + std::abs(sine_) * y_per_um;
      across_per_um_ = std::abs(sine_) * x_per_um + std::abs(cosine_) * y_per_um;
    } else {
      along_per_um_ = across_per_um_ = x_per_um;  // the window is round
    }
  }

  /// Halfwidths of an order's lobe [cycles/um].
  double along_per_um() const { return along_per_um_; }
  double across_per_um() const { return across_per_um_; }

  /// Steps of frequency that resolve a lobe of power [cycles/um]: sigma_f, by which the trapezoid
  /// leaves out 2 exp(-pi^2) = 1e-4 of a Gaussian lobe; half a zero where there is no window.
  double resolution_per_um() const { return resolution_per_um_; }

  bool contains(const Query& q) const {
    return reaches(cosine_ * q.qx_per_um + sine_ * q.qy_per_um, lattice_.along, along_per_um_) &&
           reaches(cosine_ * q.qy_per_um - sine_ * q.qx_per_um, lattice_.across, across_per_um_);
  }

 private:
  /// A period of 0 has order 0 alone.
  static bool reaches(double q_per_um, Length period, double halfwidth_per_um) {
    const double f = std::abs(q_per_um) / (2 * pi);
    if (period.um() == 0) return f <= halfwidth_per_um;
    return !detail::orders_within(f, f, period.um(), halfwidth_per_um).empty();
  }

  static double lobe_per_um(const Surface& surface, const SurfaceAxis& axis) {
    if (surface.model != SurfaceModel::replicated) return surface.window.sigma_f_per_um();
    return 1 / (axis.pixel_um * static_cast<double>(axis.count) * (axis.last_copy + 1));
  }

  Lattice lattice_;
  double cosine_, sine_, along_per_um_ = 0, across_per_um_ = 0, resolution_per_um_ = 0;
};

}  // namespace brdf
