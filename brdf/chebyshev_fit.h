// Polynomials through a function at the Chebyshev nodes.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "brdf/units.h"

namespace brdf {

/// Fits polynomials of one degree on [-1, 1] to any number of functions.
class ChebyshevFit {
 public:
  explicit ChebyshevFit(int degree)
      : count_(static_cast<std::size_t>(degree) + 1),
        turn_(4 * count_),
        powers_(count_ * count_, 0.0) {
    for (std::size_t n = 0; n < turn_.size(); ++n)
      turn_[n] = std::cos(pi * static_cast<double>(n) / static_cast<double>(2 * count_));
    for (std::size_t n = 0; n < count_; ++n)
      for (std::size_t power = 0; power <= n; ++power) {
        if (n < 2)
          powers_[n * count_ + power] = power == n ? 1 : 0;
        else  // T_n = 2 t T_{n-1} - T_{n-2}
          powers_[n * count_ + power] =
              (power > 0 ? 2 * powers_[(n - 1) * count_ + power - 1] : 0) -
              powers_[(n - 2) * count_ + power];
      }
  }

  std::size_t count() const { return count_; }  ///< degree + 1
  double node(std::size_t k) const { return turn_[2 * k + 1]; }

  /// values: of the function at the nodes. Coefficients of T_0, T_1, ...
  std::vector<double> chebyshev(const std::vector<double>& values) const {
    std::vector<double> coefficients(count_, 0.0);
    for (std::size_t n = 0; n < count_; ++n) {
      for (std::size_t k = 0; k < count_; ++k)
        coefficients[n] += values[k] * turn_[n * (2 * k + 1) % turn_.size()];
      coefficients[n] *= (n == 0 ? 1.0 : 2.0) / static_cast<double>(count_);
    }
    return coefficients;
  }

  /// Coefficients of t^0, t^1, ... from those of T_0 ... T_{size - 1}, size <= count.
  std::vector<double> monomials(const std::vector<double>& chebyshev) const {
    std::vector<double> result(chebyshev.size(), 0.0);
    for (std::size_t n = 0; n < chebyshev.size(); ++n)
      for (std::size_t power = 0; power <= n; ++power)
        result[power] += chebyshev[n] * powers_[n * count_ + power];
    return result;
  }

  /// Coefficients of t^0 ... t^degree.
  template <class Function>
  std::vector<double> operator()(Function f) const {
    std::vector<double> values;
    for (std::size_t k = 0; k < count_; ++k) values.push_back(f(node(k)));
    return monomials(chebyshev(values));
  }

 private:
  std::size_t count_;
  std::vector<double> turn_;    // cosines of a whole turn
  std::vector<double> powers_;  // [n][power] of T_n
};

/// sum_n coefficients[n] T_n(t), by Clenshaw.
inline double chebyshev_sum(const std::vector<double>& coefficients, double t) {
  double next = 0, current = 0;
  for (std::size_t n = coefficients.size(); n-- > 1;) {
    const double previous = coefficients[n] + 2 * t * current - next;
    next = current;
    current = previous;
  }
  return coefficients[0] + t * current - next;
}

}  // namespace brdf
