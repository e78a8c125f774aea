// The power spectrum of a height field under a smooth window.
#pragma once

#include <vector>

#include "brdf/fourier.h"
#include "brdf/height_field.h"

namespace brdf {

namespace detail {

/// The window's standard deviation is this part of the patch. At the edge it is exp(-4.5) = 0.011,
/// so that the jump from one edge to the other leaves 1e-4 of the power; a line's width is
/// 6 / (2 pi) = 0.95 bins, so that periods one part in the number of their repetitions apart stay
/// two maxima.
inline constexpr double smooth_window_share = 1.0 / 6;
/// An axis of fewer pixels has no room for the window and goes without.
inline constexpr Eigen::Index smallest_windowed_axis = 8;

}  // namespace detail

/// Weights of peak 1 along an axis, w = exp(-x^2 / (2 s^2)) with s = smooth_window_share of it.
inline Eigen::ArrayXd smooth_window(Eigen::Index count) {
  if (count < detail::smallest_windowed_axis) return Eigen::ArrayXd::Ones(count);
  const double half = static_cast<double>(count - 1) / 2;
  const double s = detail::smooth_window_share * static_cast<double>(count);
  return (-0.5 * (Eigen::ArrayXd::LinSpaced(count, -half, half) / s).square()).exp();
}

/// |F|^2 of w (h - <h>), F(j, l) the transform over rows and columns, <h> the mean under the
/// window.
///
/// A component a cos(2 pi f.x) has the power (a sum(w) / 2)^2 at its frequency. Cost: one transform
/// of the grid, and bytes() while it is made.
class HeightSpectrum {
 public:
  explicit HeightSpectrum(const HeightField& field)
      : rows_(field.rows()),
        cols_(field.cols()),
        width_um_(field.width_um()),
        height_um_(field.height_um()),
        power_(rows_, cols_ / 2 + 1) {
    const HeightArray weights =
        (smooth_window(rows_).matrix() * smooth_window(cols_).matrix().transpose()).array();
    weight_ = weights.sum();
    const double mean_um = (weights * field.heights_um()).sum() / weight_;
    variance_um2_ = (weights * (field.heights_um() - mean_um).square()).sum() / weight_;
    RealFourier2d fourier(static_cast<int>(rows_), static_cast<int>(cols_));
    Eigen::Map<HeightArray>(fourier.samples().data(), rows_, cols_) =
        weights * (field.heights_um() - mean_um);
    fourier.transform();
    for (long j = 0; j < rows_; ++j)
      for (long l = 0; l < power_.cols(); ++l) power_(j, l) = std::norm(fourier.bin(j, l));
  }

  long rows() const { return rows_; }
  long cols() const { return cols_; }
  /// Sides of the patch: bin (j, l) has the frequency (l / width, j / height) [cycles/um].
  double width_um() const { return width_um_; }
  double height_um() const { return height_um_; }

  /// For any integers: bins repeat with the grid and are symmetric about 0.
  double power(long j, long l) const {
    long row = wrapped(j, rows_), col = wrapped(l, cols_);
    if (col >= power_.cols()) {
      row = wrapped(-row, rows_);
      col = cols_ - col;
    }
    return power_(row, col);
  }

  /// Amplitude a [um] of the component a cos(2 pi f.x) that has this power.
  double amplitude_um(double power) const { return 2 * std::sqrt(power) / weight_; }
  /// Variance of the heights under the window [um^2].
  double variance_um2() const { return variance_um2_; }

  static std::size_t bytes(std::size_t rows, std::size_t cols) {
    return 2 * RealFourier2d::bytes(rows, cols);
  }

 private:
  static long wrapped(long index, long count) { return (index % count + count) % count; }

  long rows_, cols_;
  double width_um_, height_um_;
  HeightArray power_;
  double weight_ = 0, variance_um2_ = 0;
};

}  // namespace brdf
