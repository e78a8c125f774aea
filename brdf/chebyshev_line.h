// Pixels projected on an oblique line: the plane of incidence at any azimuth.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "brdf/amplitude.h"
#include "brdf/kernel_choice.h"

namespace brdf {

/// Even samples along t = x cos + y sin that stand for all pixels of a patch, t = 0 at its centre.
///
/// e^{i q t} =~ correction(q) sum_n psi(n - t / pitch) e^{i q n pitch}, correction = 1 / psi^(q
/// pitch), for every |q| up to that of the bounds: each pixel is spread over `width` samples, and
/// what is left is a transform of even samples. `error_bound` holds for a pixel, and so for the
/// normalised amplitude; measured in chebyshev_oblique.tests.cpp.
class LineProjection {
 public:
  /// bounds.line: set. Throws Errc::invalid_argument where it is no unit vector.
  LineProjection(const Surface& surface, const QueryBounds& bounds, double tolerance)
      : direction_(*bounds.line) {
    const double c = direction_.cos_azimuth, s = direction_.sin_azimuth;
    if (!(std::abs(c * c + s * s - 1) <= 1e-12))
      throw Error(Errc::invalid_argument, "line direction (" + std::to_string(c) + ", " +
                                              std::to_string(s) + ") must be a unit vector");
    set_range(bounds);
    const HeightField& field = *surface.heights;
    const double x_um = field.dx_um() * static_cast<double>(field.cols() - 1) / 2;
    const double y_um = field.dy_um() * static_cast<double>(field.rows() - 1) / 2;
    const double reach_um = std::abs(c) * x_um + std::abs(s) * y_um;
    // At least a few samples, for however small a range of frequencies.
    largest_per_um_ = std::max({-lo_per_um_, hi_per_um_, pi / std::max(reach_um, 1e-9)});
    pitch_um_ = pi / (oversampling * largest_per_um_);
    offset_allowed_per_um_ = 4 * std::numeric_limits<double>::epsilon() *
                             (std::max(-lo_per_um_, hi_per_um_) + bounds.max_abs_c_per_um());
    offset_error_ = offset_allowed_per_um_ * (std::abs(s) * x_um + std::abs(c) * y_um);
    choose_kernel(tolerance);
    count_ = 2 * static_cast<std::size_t>(std::ceil(reach_um / pitch_um_)) +
             static_cast<std::size_t>(kernel_.width()) + 2;
  }

  LineDirection direction() const { return direction_; }
  double lo_per_um() const { return lo_per_um_; }  ///< along the line
  double hi_per_um() const { return hi_per_um_; }
  double pitch_um() const { return pitch_um_; }
  std::size_t count() const { return count_; }  ///< of samples
  const InterpolationKernel& kernel() const { return kernel_; }
  double error_bound() const { return error_bound_; }
  /// Largest sum over the samples of one pixel's weights, times the largest correction.
  double amplification() const { return amplification_; }
  /// What queries that miss the line by as much as `contains` allows may add to the error.
  double offset_error() const { return offset_error_; }

  /// In samples from the first, of a pixel at t_um.
  double position(double t_um) const {
    return t_um / pitch_um_ + static_cast<double>(count_ - 1) / 2;
  }

  /// Whether a query lies on the line, to the rounding of k u and k v.
  bool contains(const Query& q) const {
    return std::abs(q.qy_per_um * direction_.cos_azimuth - q.qx_per_um * direction_.sin_azimuth) <=
           offset_allowed_per_um_;
  }

  double correction(const Query& q) const {
    const double ratio =
        (q.qx_per_um * direction_.cos_azimuth + q.qy_per_um * direction_.sin_azimuth) /
        largest_per_um_;
    const double t = 2 * ratio * ratio - 1;
    double value = 0;
    for (std::size_t power = correction_.size(); power-- > 0;)
      value = value * t + correction_[power];
    return value;
  }

 private:
  /// Two samples would do for a period of the highest frequency; a finer grid costs little in one
  /// dimension and saves taps at every pixel.
  static constexpr double oversampling = 4;

  /// The box's stretch of the line, from the side that the line runs along.
  void set_range(const QueryBounds& bounds) {
    const bool along_x = std::abs(direction_.cos_azimuth) >= std::abs(direction_.sin_azimuth);
    const double slope = along_x ? direction_.cos_azimuth : direction_.sin_azimuth;
    lo_per_um_ = (along_x ? bounds.lo.qx_per_um : bounds.lo.qy_per_um) / slope;
    hi_per_um_ = (along_x ? bounds.hi.qx_per_um : bounds.hi.qy_per_um) / slope;
    if (lo_per_um_ > hi_per_um_) std::swap(lo_per_um_, hi_per_um_);
    // Queries within rounding of the ends.
    const double margin = 1e-14 * std::max(std::abs(lo_per_um_), std::abs(hi_per_um_));
    lo_per_um_ -= margin;
    hi_per_um_ += margin;
  }

  void choose_kernel(double tolerance) {
    constexpr double edge = pi / oversampling;
    const ChosenKernel chosen =
        choose_semicircle(edge, oversampling, tolerance, [](const std::vector<double>& errors) {
          return *std::max_element(errors.begin(), errors.end());
        });
    kernel_ = chosen.kernel;
    error_bound_ = chosen.error_bound;
    // Of the kernel's sum over its taps the transform at 0 is the mean; it falls to the edge.
    amplification_ = chosen.transform(0) * (1 + error_bound_) / chosen.transform(edge);
    // Entire in omega^2: degree 12 is exact to rounding.
    correction_ = ChebyshevFit(12)([&](double t) {
      return 1 / chosen.transform(edge * std::sqrt(std::max(0.0, (1 + t) / 2)));
    });
  }

  LineDirection direction_;
  double lo_per_um_ = 0, hi_per_um_ = 0, largest_per_um_ = 0, pitch_um_ = 0;
  double offset_allowed_per_um_ = 0, offset_error_ = 0, error_bound_ = 0, amplification_ = 1;
  std::size_t count_ = 0;
  InterpolationKernel kernel_ = InterpolationKernel::semicircle(2, 2);
  std::vector<double> correction_;
};

}  // namespace brdf
