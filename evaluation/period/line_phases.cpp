#include "evaluation/period/line_phases.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <complex>

namespace evaluation {
namespace {

constexpr int most_harmonics = 3;
constexpr int most_functions = 3 + 2 * most_harmonics;
/// The weight is cut at 3 standard deviations; least squares are exact under any weight.
constexpr double reach_periods = 3 * line_window_periods;
/// Of the Nyquist limit, up to which a harmonic is told from its folded image.
constexpr double resolved_share = 0.9;
constexpr double least_weight = 0.1;

using Functions = Eigen::Matrix<double, most_functions, 1>;

/// Sums of the least squares about one line.
struct LineSums {
  Eigen::Matrix<double, most_functions, most_functions> normal =
      Eigen::Matrix<double, most_functions, most_functions>::Zero();
  Functions real = Functions::Zero(), imaginary = Functions::Zero();
  double weight = 0;

  void add(const Functions& f, double w, double re, double im) {
    normal.selfadjointView<Eigen::Lower>().rankUpdate(f, w);
    real += w * re * f;
    imaginary += w * im * f;
    weight += w;
  }
};

/// The functions at a place t along and v across the grating vector; the slope's along it is set
/// per line.
Functions functions_at(double t, double v, int harmonics) {
  Functions f = Functions::Zero();
  f(0) = 1;
  f(2 + 2 * harmonics) = v;
  const std::complex<double> turn = std::polar(1.0, 2 * brdf::pi * (t - std::round(t)));
  std::complex<double> power = 1;
  for (int m = 1; m <= harmonics; ++m) {
    power *= turn;
    f(2 * m) = power.real();
    f(2 * m + 1) = power.imag();
  }
  return f;
}

/// Coefficients of 1 and of exp(2 pi i t) in a wave with real and imaginary parts a cos + b sin.
struct LocalOrders {
  std::complex<double> mirror, first;
};

LocalOrders orders(const LineSums& sums, int n) {
  const Eigen::LDLT<Eigen::MatrixXd> solver(
      Eigen::MatrixXd(sums.normal.topLeftCorner(n, n).selfadjointView<Eigen::Lower>()));
  const Eigen::VectorXd re = solver.solve(sums.real.head(n));
  const Eigen::VectorXd im = solver.solve(sums.imaginary.head(n));
  constexpr std::complex<double> i(0, 1);
  return {{re(0), im(0)}, (std::complex(re(2), im(2)) - i * std::complex(re(3), im(3))) / 2.0};
}

double wrapped(double angle_rad) {
  return std::remainder(angle_rad, 2 * brdf::pi);
}

void unwrap_from_the_middle(std::vector<double>& phase_rad) {
  const std::size_t middle = phase_rad.size() / 2;
  for (std::size_t i = middle + 1; i < phase_rad.size(); ++i)
    phase_rad[i] = phase_rad[i - 1] + wrapped(phase_rad[i] - phase_rad[i - 1]);
  for (std::size_t i = middle; i-- > 0;)
    phase_rad[i] = phase_rad[i + 1] + wrapped(phase_rad[i] - phase_rad[i + 1]);
}

}  // namespace

LinePhases line_phases(const SurfaceWave& wave, const Frequency& frequency) {
  const double along_x = frequency.x_per_um * wave.dx_um;  // periods a pixel
  const double along_y = frequency.y_per_um * wave.dy_um;
  const double pixel_periods = std::abs(along_x) + std::abs(along_y);
  const int harmonics =
      std::clamp(static_cast<int>(resolved_share * 0.5 / pixel_periods), 1, most_harmonics);
  const bool one_row = along_y == 0 && wave.is_even_along_y();
  const int functions = 2 + 2 * harmonics + (one_row ? 0 : 1);
  const Eigen::Index rows = one_row ? 1 : wave.rows();

  const double half = (std::abs(along_x) * static_cast<double>(wave.cols()) +
                       std::abs(along_y) * static_cast<double>(rows)) /
                      2;
  const long last = std::max(0L, static_cast<long>(half - 0.5 + 1e-9));
  std::vector<LineSums> sums(static_cast<std::size_t>(2 * last + 1));
  for (Eigen::Index row = 0; row < rows; ++row)
    for (Eigen::Index col = 0; col < wave.cols(); ++col) {
      const double t =
          frequency.x_per_um * wave.x_um(col) + (one_row ? 0 : frequency.y_per_um * wave.y_um(row));
      const double v =
          one_row ? 0 : frequency.x_per_um * wave.y_um(row) - frequency.y_per_um * wave.x_um(col);
      Functions f = functions_at(t, v, harmonics);
      const long from = std::max(-last, static_cast<long>(std::ceil(t - reach_periods)));
      const long to = std::min(last, static_cast<long>(std::floor(t + reach_periods)));
      for (long line = from; line <= to; ++line) {
        f(1) = t - static_cast<double>(line);
        const double z = f(1) / line_window_periods;
        sums[static_cast<std::size_t>(line + last)].add(
            f, std::exp(-0.5 * z * z), wave.real(row, col), wave.imaginary(row, col));
      }
    }

  std::vector<double> weights;
  for (const LineSums& line : sums) weights.push_back(line.weight);
  const auto middle = weights.begin() + static_cast<std::ptrdiff_t>(weights.size() / 2);
  std::nth_element(weights.begin(), middle, weights.end());
  const double enough = least_weight * *middle;
  const double most = *std::max_element(weights.begin(), weights.end());
  LinePhases phases;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (!(sums[i].weight >= enough)) continue;
    const LocalOrders z = orders(sums[i], functions);
    phases.line.push_back(static_cast<double>(i) - static_cast<double>(last));
    phases.phase_rad.push_back(std::arg(
        wave.phase_origin == PhaseOrigin::mirror_lobe ? z.first * std::conj(z.mirror) : z.first));
    phases.weight.push_back(sums[i].weight / most);
    phases.amplitude.push_back(std::abs(z.first));
  }
  unwrap_from_the_middle(phases.phase_rad);
  return phases;
}

}  // namespace evaluation
