// Oracles in long double that share nothing with the code under test but the heights.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>

#include "brdf/amplitude.h"

namespace exact {

using Real = long double;
using Complex = std::complex<Real>;
inline constexpr Real pi = std::numbers::pi_v<Real>;

/// e^{i phase}.
inline Complex turned(Real phase) {
  return {std::cos(phase), std::sin(phase)};
}

/// P = Int Int g f exp(i (qx x + qy y)), Int Int g and A = Int Int g^2, as sums over pixels [um^2].
struct Transform {
  Complex p;
  Real g, g_squared;

  Complex amplitude() const { return p / g; }
};

/// How many times a patch is repeated on each side of itself.
struct Repeats {
  int x = 0, y = 0;
};

/// The sums over a patch and its repetitions, origin in the middle of the patch, with a window
/// g(x, y) and a function f(h) of the height.
template <class Window, class Function>
Transform transform(const brdf::HeightField& field, const brdf::Query& q, Window g, Function f,
                    Repeats repeats = {}) {
  const auto middle = [](Eigen::Index count) { return static_cast<Real>(count - 1) / 2; };
  const Real area = static_cast<Real>(field.dx_um()) * static_cast<Real>(field.dy_um());
  Transform sums{0, 0, 0};
  for (int copy_y = -repeats.y; copy_y <= repeats.y; ++copy_y)
    for (int copy_x = -repeats.x; copy_x <= repeats.x; ++copy_x)
      for (Eigen::Index row = 0; row < field.rows(); ++row)
        for (Eigen::Index col = 0; col < field.cols(); ++col) {
          const Real x = field.dx_um() *
                         (static_cast<Real>(col + copy_x * field.cols()) - middle(field.cols()));
          const Real y = field.dy_um() *
                         (static_cast<Real>(row + copy_y * field.rows()) - middle(field.rows()));
          const Real weight = g(x, y);
          const Complex value = f(static_cast<Real>(field.heights_um()(row, col)));
          sums.p += area * weight * value * turned(q.qx_per_um * x + q.qy_per_um * y);
          sums.g += area * weight;
          sums.g_squared += area * weight * weight;
        }
  return sums;
}

/// g = 1.
inline Real evenly(Real, Real) {
  return 1;
}

/// g = exp(-(x^2 + y^2) / (2 sigma^2)).
inline auto gaussian(Real sigma_um) {
  return
      [sigma_um](Real x, Real y) { return std::exp(-(x * x + y * y) / (2 * sigma_um * sigma_um)); };
}

/// f = e^{i c h}.
inline auto phase(Real c_per_um) {
  return [c_per_um](Real h) { return turned(c_per_um * h); };
}

/// Difference of a double from an exact value.
inline double difference(std::complex<double> value, Complex reference) {
  return static_cast<double>(std::abs(Complex(value) - reference));
}

/// J_m(x) as the mean of cos(m t - x sin t) over `points` angles, which errs by
/// J_{points - m}(x) only.
inline Real bessel_j(int m, Real x) {
  const int points = 64 + 2 * std::abs(m) + 4 * static_cast<int>(std::abs(x));
  Real sum = 0;
  for (int j = 0; j < points; ++j) {
    const Real t = 2 * pi * j / points;
    sum += std::cos(m * t - x * std::sin(t));
  }
  return sum / points;
}

/// sin(x) / x, 1 at 0.
inline Real sinc(Real x) {
  return x == 0 ? 1 : std::sin(x) / x;
}

}  // namespace exact
