#include "evaluation/period/spectral_line.h"

#include <Eigen/LU>

namespace evaluation {
namespace {

using Complex = std::complex<double>;

constexpr Eigen::Index smallest_windowed_axis = 8;
constexpr int most_steps = 30;
/// Newton's step in units of the line's own width below which it has converged: the sums carry
/// rounding of about 1e-15 of it.
constexpr double converged_step = 1e-12;
constexpr double reach_widths = 2;

/// One axis: positions and weights of its pixels.
struct WindowAxis {
  Eigen::ArrayXd position_um, weight;
  double line_width_per_um = 0;  ///< 1 / (2 pi s); 0 where the axis has no window

  WindowAxis(Eigen::Index count, double pixel_um, double share, double centre_um)
      : position_um(pixel_um * Eigen::ArrayXd::LinSpaced(count, -half(count), half(count))),
        weight(Eigen::ArrayXd::Ones(count)) {
    if (count < smallest_windowed_axis) return;
    const double s_um = share * pixel_um * static_cast<double>(count);
    weight = (-0.5 * ((position_um - centre_um) / s_um).square()).exp();
    line_width_per_um = 1 / (2 * brdf::pi * s_um);
  }

  /// w exp(-2 pi i f x) times 1, x, x^2: columns of a matrix.
  Eigen::MatrixX3cd moments(double frequency_per_um) const {
    Eigen::MatrixX3cd columns(position_um.size(), 3);
    for (Eigen::Index i = 0; i < position_um.size(); ++i) {
      const double x = position_um(i);
      const Complex wave = std::polar(weight(i), -2 * brdf::pi * frequency_per_um * x);
      columns.row(i) << wave, wave * x, wave * x * x;
    }
    return columns;
  }

 private:
  static double half(Eigen::Index count) { return static_cast<double>(count - 1) / 2; }
};

/// The windowed wave less its mean, and its moments at any frequency.
class WindowedWave {
 public:
  WindowedWave(const SurfaceWave& wave, const PatchWindow& window)
      : wave_(wave),
        x_(wave.cols(), wave.dx_um, window.share, window.centre_x_um),
        y_(wave.rows(), wave.dy_um, window.share, window.centre_y_um) {
    sum_ = x_.weight.sum() * y_.weight.sum();
    mean_ = moments_of_wave({})(0, 0) / sum_;
  }

  const WindowAxis& x() const { return x_; }
  const WindowAxis& y() const { return y_; }
  double weight_sum() const { return sum_; }

  /// Entry (i, j): sum of w (s - <s>) exp(-2 pi i f.x) y^i x^j.
  Eigen::Matrix3cd moments(const Frequency& f) const {
    const Eigen::MatrixX3cd x = x_.moments(f.x_per_um), y = y_.moments(f.y_per_um);
    const Eigen::RowVector3cd x_sums = x.colwise().sum(), y_sums = y.colwise().sum();
    return moments_of_wave(f) - mean_ * (y_sums.transpose() * x_sums);
  }

 private:
  Eigen::Matrix3cd moments_of_wave(const Frequency& f) const {
    const Eigen::MatrixX3cd x = x_.moments(f.x_per_um), y = y_.moments(f.y_per_um);
    Eigen::Matrix3cd sums = Eigen::Matrix3cd::Zero();
    for (Eigen::Index row = 0; row < wave_.rows(); ++row) {
      Eigen::RowVector3cd along = Eigen::RowVector3cd::Zero();
      for (Eigen::Index col = 0; col < wave_.cols(); ++col)
        along += Complex(wave_.real(row, col), wave_.imaginary(row, col)) * x.row(col);
      sums += y.row(row).transpose() * along;
    }
    return sums;
  }

  const SurfaceWave& wave_;
  WindowAxis x_, y_;
  double sum_ = 0;
  Complex mean_;
};

}  // namespace

std::complex<double> line_amplitude(const SurfaceWave& wave, const Frequency& frequency,
                                    const PatchWindow& window) {
  const WindowedWave windowed(wave, window);
  return windowed.moments(frequency)(0, 0) / windowed.weight_sum();
}

std::optional<Frequency> refined_line(const SurfaceWave& wave, const Frequency& start,
                                      const PatchWindow& window) {
  const WindowedWave windowed(wave, window);
  const double width_x = windowed.x().line_width_per_um, width_y = windowed.y().line_width_per_um;
  if (!(width_x > 0 || width_y > 0)) return std::nullopt;
  Frequency f = start;
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::Matrix3cd m = windowed.moments(f);
    // Derivatives of log |A|^2 = 2 Re log A along fx and fy; each moment carries -2 pi i.
    constexpr Complex factor(0, -2 * brdf::pi);
    const Complex gx = factor * m(0, 1) / m(0, 0), gy = factor * m(1, 0) / m(0, 0);
    Eigen::Matrix2d curvature;
    curvature(0, 0) = 2 * (factor * factor * m(0, 2) / m(0, 0) - gx * gx).real();
    curvature(1, 1) = 2 * (factor * factor * m(2, 0) / m(0, 0) - gy * gy).real();
    curvature(0, 1) = curvature(1, 0) = 2 * (factor * factor * m(1, 1) / m(0, 0) - gx * gy).real();
    Eigen::Vector2d slope(2 * gx.real(), 2 * gy.real());
    for (const int axis : {0, 1})
      if (!((axis == 0 ? width_x : width_y) > 0)) {  // nothing to be told along it
        slope(axis) = 0;
        curvature(axis, 1 - axis) = curvature(1 - axis, axis) = 0;
        curvature(axis, axis) = -1;
      }
    if (!(curvature(0, 0) < 0 && curvature.determinant() > 0)) return std::nullopt;
    const Eigen::Vector2d d = -curvature.inverse() * slope;
    f.x_per_um += d.x();
    f.y_per_um += d.y();
    const auto beyond = [](double moved, double width) {
      return width > 0 && !(std::abs(moved) <= reach_widths * width);
    };
    if (beyond(f.x_per_um - start.x_per_um, width_x) ||
        beyond(f.y_per_um - start.y_per_um, width_y))
      return std::nullopt;
    if (std::abs(d.x()) <= converged_step * width_x && std::abs(d.y()) <= converged_step * width_y)
      return f;
  }
  return f;
}

}  // namespace evaluation
