// Compact kernels that carry a transform from its grid to any frequency.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

#include "brdf/chebyshev_fit.h"
#include "brdf/gauss_legendre.h"
#include "brdf/units.h"

namespace brdf {

/// A kernel psi(d) of `width` grid points, d in [-width/2, width/2), stored as polynomials.
///
/// A frequency at the grid position p takes the points k0 + i, k0 = ceil(p - width/2), i = 0 ...
/// width - 1, with the weights psi(i - width/2 + x), x = k0 - (p - width/2) in [0, 1). Each weight
/// is a polynomial in x, one per tap and, for a kernel narrower than the grid, per piece of [0, 1).
/// The polynomials *are* the kernel: transform and errors are taken from them.
class InterpolationKernel {
 public:
  static constexpr int max_width = 24;

  /// Exponential of semicircle, psi(d) = exp(beta (sqrt(1 - (2 d / width)^2) - 1)) (Barnett,
  /// Magland, af Klinteberg, SIAM J. Sci. Comput. 41, 2019). oversampling: > 1.
  static InterpolationKernel semicircle(int width, double oversampling) {
    // Their rate pi (1 - 1 / (2 sigma)), with the factor that measured best for sigma 1.25 to 4.
    const double beta = 0.976 * pi * width * (1 - 1 / (2 * oversampling));
    const auto psi = [=](double d) {
      const double z = 2 * d / width;
      return std::exp(beta * (std::sqrt(std::max(0.0, 1 - z * z)) - 1));
    };
    return InterpolationKernel(width, width + 3, 1, psi);
  }

  /// peak exp(-d^2 / (2 sigma^2)); sigma in grid points, > 0.
  static InterpolationKernel gaussian(int width, double sigma, double peak) {
    const auto psi = [=](double d) { return peak * std::exp(-0.5 * (d / sigma) * (d / sigma)); };
    // On a piece of length sigma the polynomial of degree 14 is right to 1e-15.
    return InterpolationKernel(width, 14, std::max(1, static_cast<int>(std::ceil(1 / sigma))), psi);
  }

  int width() const { return width_; }
  int degree() const { return degree_; }
  int pieces() const { return pieces_; }
  /// Doubles from one power of x to the next: the taps, filled up with zeros.
  int tap_stride() const { return tap_stride_; }
  /// [piece][power][tap]
  const std::vector<double>& coefficients() const { return coefficients_; }

  /// The same kernel with `split` pieces for each of its own and the lowest degree for which the
  /// taps change by at most `tolerance` in all, at any x: fewer products a query.
  InterpolationKernel shortened(int split, double tolerance) const {
    const ChebyshevFit fit(degree_);
    const int pieces = split * pieces_;
    std::vector<std::vector<double>> series(static_cast<std::size_t>(pieces * width_));
    // Left out of the worst piece where a degree is the last.
    std::vector<double> left_out(fit.count(), 0.0);
    for (int piece = 0; piece < pieces; ++piece) {
      std::vector<std::vector<double>> at_nodes;
      for (std::size_t k = 0; k < fit.count(); ++k)
        at_nodes.push_back(taps((piece + (1 + fit.node(k)) / 2) / pieces));
      std::vector<double> tail(fit.count(), 0.0);
      for (std::size_t tap = 0; tap < static_cast<std::size_t>(width_); ++tap) {
        std::vector<double> values;
        for (const std::vector<double>& weights : at_nodes) values.push_back(weights[tap]);
        auto& coefficients = series[static_cast<std::size_t>(piece * width_) + tap];
        coefficients = fit.chebyshev(values);
        double sum = 0;
        for (std::size_t n = fit.count(); n-- > 1;) tail[n - 1] += sum += std::abs(coefficients[n]);
      }
      for (std::size_t n = 0; n < tail.size(); ++n) left_out[n] = std::max(left_out[n], tail[n]);
    }
    int degree = degree_;
    while (degree > 1 && left_out[static_cast<std::size_t>(degree - 1)] <= tolerance) --degree;
    InterpolationKernel result(width_, degree, pieces);
    result.shortening_error_ = left_out[static_cast<std::size_t>(degree)];
    for (int piece = 0; piece < pieces; ++piece)
      for (int tap = 0; tap < width_; ++tap) {
        auto& coefficients = series[static_cast<std::size_t>(piece * width_ + tap)];
        coefficients.resize(static_cast<std::size_t>(degree) + 1);
        result.set_polynomial(piece, tap, fit.monomials(coefficients));
      }
    return result;
  }
  /// Bound on the sum over the taps of what `shortened` has changed, at any x.
  double shortening_error() const { return shortening_error_; }

  /// Weights of the taps at x in [0, 1).
  std::vector<double> taps(double x) const {
    const int piece = std::min(static_cast<int>(x * pieces_), pieces_ - 1);
    const double t = 2 * (x * pieces_ - piece) - 1;
    std::vector<double> weights(static_cast<std::size_t>(width_), 0.0);
    for (int power = degree_; power >= 0; --power)
      for (int tap = 0; tap < width_; ++tap) {
        double& weight = weights[static_cast<std::size_t>(tap)];
        weight = weight * t + coefficients_[index(piece, power, tap)];
      }
    return weights;
  }

  /// Int psi(d) cos(omega d) dd for each omega [rad per grid point].
  std::vector<double> transform(const std::vector<double>& omegas) const {
    // Degree of the polynomial plus that of a cosine over half a turn to rounding.
    const QuadratureRule rule = gauss_legendre((degree_ + 22) / 2);
    std::vector<std::vector<double>> values;
    for (const double x : rule.nodes) values.push_back(taps(x));
    // The nodes x and 1 - x share a sine and cosine, and the taps lie one grid point apart.
    const std::size_t half = (rule.nodes.size() + 1) / 2;
    std::vector<std::complex<double>> waves(rule.nodes.size());
    std::vector<double> result;
    result.reserve(omegas.size());
    for (const double omega : omegas) {
      const std::complex<double> step = std::polar(1.0, omega);
      std::complex<double> wave = std::polar(1.0, -omega * (width_ / 2.0));
      for (std::size_t node = 0; node < half; ++node) {
        const std::size_t mirror = rule.nodes.size() - 1 - node;
        waves[node] = std::polar(1.0, omega * rule.nodes[node]);
        if (mirror != node) waves[mirror] = multiplied(step, std::conj(waves[node]));
      }
      double sum = 0;
      for (std::size_t tap = 0; tap < static_cast<std::size_t>(width_); ++tap) {
        double re = 0, im = 0;
        for (std::size_t node = 0; node < waves.size(); ++node) {
          const double weight = rule.weights[node] * values[node][tap];
          re += weight * waves[node].real();
          im += weight * waves[node].imag();
        }
        sum += re * wave.real() - im * wave.imag();
        wave = multiplied(wave, step);
      }
      result.push_back(sum);
    }
    return result;
  }

  /// Largest error over all x of one sample's term, abs(sum_i psi(d_i) e^{i omega d_i} /
  /// psi^(omega) - 1), for each omega. x is taken on a mesh, and a fifth added for what lies
  /// between its points.
  std::vector<double> relative_errors(const std::vector<double>& omegas) const {
    return relative_errors(omegas, transform(omegas));
  }
  /// transforms: those of the omegas.
  std::vector<double> relative_errors(const std::vector<double>& omegas,
                                      const std::vector<double>& transforms) const {
    constexpr int x_count = 24;
    std::vector<std::vector<double>> weights;
    // The kernel is even: the errors at 1 - x are those at x.
    for (int n = 0; n <= x_count / 2; ++n) weights.push_back(taps(n / double{x_count}));
    std::vector<double> worst(omegas.size(), 0.0);
    std::vector<std::complex<double>> waves(static_cast<std::size_t>(width_));
    for (std::size_t m = 0; m < omegas.size(); ++m) {
      for (int tap = 0; tap < width_; ++tap)
        waves[static_cast<std::size_t>(tap)] =
            std::polar(1 / transforms[m], omegas[m] * (tap - width_ / 2.0));
      double largest_square = 0;
      for (int n = 0; n <= x_count / 2; ++n) {
        std::complex<double> sum = 0;
        for (std::size_t tap = 0; tap < waves.size(); ++tap)
          sum += waves[tap] * weights[static_cast<std::size_t>(n)][tap];
        const std::complex<double> exact = std::polar(1.0, -omegas[m] * n / x_count);
        largest_square = std::max(largest_square, std::norm(sum - exact));
      }
      worst[m] = 1.2 * std::sqrt(largest_square);
    }
    return worst;
  }

 private:
  template <class Function>
  InterpolationKernel(int width, int degree, int pieces, Function psi)
      : InterpolationKernel(width, degree, pieces) {
    const ChebyshevFit fit(degree);
    for (int piece = 0; piece < pieces; ++piece)
      for (int tap = 0; tap < width; ++tap)
        set_polynomial(piece, tap, fit([&](double t) {
                         return psi(tap - width / 2.0 + (piece + (1 + t) / 2) / pieces);
                       }));
  }

  InterpolationKernel(int width, int degree, int pieces)
      : width_(width),
        degree_(degree),
        pieces_(pieces),
        tap_stride_((width + 7) / 8 * 8),
        coefficients_(static_cast<std::size_t>(pieces * (degree + 1) * tap_stride_), 0.0) {}

  void set_polynomial(int piece, int tap, const std::vector<double>& monomials) {
    for (std::size_t power = 0; power < monomials.size(); ++power)
      coefficients_[index(piece, static_cast<int>(power), tap)] = monomials[power];
  }

  /// a b of finite numbers, without the checks for infinity that std::complex makes.
  static std::complex<double> multiplied(std::complex<double> a, std::complex<double> b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
  }

  std::size_t index(int piece, int power, int tap) const {
    return static_cast<std::size_t>((piece * (degree_ + 1) + power) * tap_stride_ + tap);
  }

  int width_, degree_, pieces_, tap_stride_;
  double shortening_error_ = 0;
  std::vector<double> coefficients_;
};

}  // namespace brdf
