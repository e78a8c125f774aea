// How wide the features of a surface are: the correlation length.
#pragma once

#include <optional>

#include "brdf/height_spectrum.h"

namespace brdf {

/// Autocorrelation of the heights, 1 at lag 0, at lags up to a quarter of the patch.
///
/// The transform of the power under the smooth window (Wiener and Khinchin), divided by what the
/// window makes of a constant, exp(-x^2 / (4 s^2)) along each windowed axis.
class Autocorrelation {
 public:
  /// spectrum: of a surface that is not flat.
  explicit Autocorrelation(const HeightSpectrum& spectrum)
      : rows_(spectrum.rows()),
        cols_(spectrum.cols()),
        dx_um_(spectrum.width_um() / static_cast<double>(cols_)),
        dy_um_(spectrum.height_um() / static_cast<double>(rows_)),
        fourier_(static_cast<int>(rows_), static_cast<int>(cols_)) {
    const auto samples = fourier_.samples();
    for (long j = 0; j < rows_; ++j)
      for (long l = 0; l < cols_; ++l)
        samples[static_cast<std::size_t>(j * cols_ + l)] = spectrum.power(j, l);
    fourier_.transform();
    at_zero_ = fourier_.bin(0, 0).real();
  }

  /// Linear between the pixels. Empty beyond a quarter of the patch.
  std::optional<double> at(double x_um, double y_um) const {
    const double col = x_um / dx_um_, row = y_um / dy_um_;
    if (!(std::abs(col) <= static_cast<double>(cols_ / 4) &&
          std::abs(row) <= static_cast<double>(rows_ / 4)))
      return std::nullopt;
    const double left = std::floor(col), top = std::floor(row);
    const long l = static_cast<long>(left), j = static_cast<long>(top);
    const double right_share = col - left, bottom_share = row - top;
    return (1 - bottom_share) * ((1 - right_share) * pixel(j, l) + right_share * pixel(j, l + 1)) +
           bottom_share * ((1 - right_share) * pixel(j + 1, l) + right_share * pixel(j + 1, l + 1));
  }

  /// Smaller of the two pixels: the step at which lags are worth looking at.
  double pixel_um() const { return std::min(dx_um_, dy_um_); }

 private:
  double pixel(long j, long l) const {
    return fourier_.bin(j, l).real() / at_zero_ / of_window(j, rows_) / of_window(l, cols_);
  }
  static double of_window(long lag, long count) {
    if (count < detail::smallest_windowed_axis) return 1;
    const double sigmas =
        static_cast<double>(lag) / (detail::smooth_window_share * static_cast<double>(count));
    return std::exp(-sigmas * sigmas / 4);
  }

  long rows_, cols_;
  double dx_um_, dy_um_;
  RealFourier2d fourier_;
  double at_zero_ = 0;
};

/// The shortest lag [um], over all directions, at which the autocorrelation has fallen to 1/e.
/// Empty for a flat surface, and where it has not fallen within a quarter of the patch.
///
/// A sinusoid of period d has d acos(1/e) / (2 pi) = 0.190 d, Gaussian hills exp(-r^2 / l^2) have
/// l. Directions are searched every 5 deg: the one that falls fastest is missed by at most 2.5 deg,
/// which lengthens the lag of parallel ridges by 1e-3. Measured in roughness.tests.cpp.
inline std::optional<double> correlation_length_um(const HeightSpectrum& spectrum) {
  if (!(spectrum.variance_um2() > 0)) return std::nullopt;
  const Autocorrelation correlation(spectrum);
  const double level = std::exp(-1), step_um = correlation.pixel_um();
  std::optional<double> shortest_um;
  for (int degrees = 0; degrees < 180; degrees += 5) {
    // 90 deg exactly: a patch of one column has room for nothing else.
    const double cosine = degrees == 90 ? 0 : std::cos(Angle::deg(degrees).rad());
    const double sine = std::sin(Angle::deg(degrees).rad());
    double before = 1;
    for (int n = 1;; ++n) {
      const double lag_um = n * step_um;
      const auto value = correlation.at(lag_um * cosine, lag_um * sine);
      if (!value || (shortest_um && lag_um - step_um > *shortest_um)) break;
      if (*value <= level) {
        const double crossing_um = lag_um - step_um * (level - *value) / (before - *value);
        shortest_um = std::min(crossing_um, shortest_um.value_or(crossing_um));
        break;
      }
      before = *value;
    }
  }
  return shortest_um;
}

}  // namespace brdf
