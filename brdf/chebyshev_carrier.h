// The terms of a Chebyshev plan, carrier included, as polynomials of the height.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "brdf/chebyshev_terms.h"
#include "brdf/units.h"

namespace brdf {

/// e^{i phase s} a_r(s) =~ sum_{p < degrees} C_pr T_p(s), s in [-1, 1], for every term of a series
/// in T_r(tau): sums over pixels then need the real moments sum w T_p(s) only, two products a
/// degree, and neither a sine nor a cosine.
///
/// C_pr is real where p + r is even and imaginary else. It falls faster than any power beyond
/// phase + x / 2. `error_bound` is the sum of the |C_pr| left out, r without its factor i. Cost:
/// (phase + x / 2)^2 x / 2 products, microseconds below phase = 10.
class CarriedTerms {
 public:
  /// terms: in a basis of T_n.
  CarriedTerms(const ChebyshevTerms& terms, double phase_rad, double tolerance) {
    // As in ChebyshevTerms; a term holds frequencies up to that of its degrees.
    const double size = std::abs(phase_rad);
    const double reach = size + 12 * std::cbrt(size) + 16 + terms.degrees();
    const auto half = static_cast<Eigen::Index>(std::ceil(reach / 2));
    const Eigen::Index nodes = 2 * half;
    Eigen::VectorXd cosines(4 * nodes);  // of a whole turn
    for (Eigen::Index n = 0; n < cosines.size(); ++n)
      cosines(n) = std::cos(pi * static_cast<double>(n) / static_cast<double>(2 * nodes));
    // T_p at the positive nodes: even p in the rows of `even`, odd ones in those of `odd`.
    Eigen::MatrixXd even(half, half), odd(half, half);
    for (Eigen::Index k = 0; k < half; ++k)
      for (Eigen::Index p = 0; p < half; ++p) {
        even(p, k) = cosines(2 * p * (2 * k + 1) % cosines.size());
        odd(p, k) = cosines((2 * p + 1) * (2 * k + 1) % cosines.size());
      }
    const Eigen::Index count = terms.count();
    Eigen::MatrixXd of_even(half, count), of_odd(half, count);  // parts of that parity, at nodes
    for (Eigen::Index r = 0; r < count; ++r)
      for (Eigen::Index k = 0; k < half; ++k) {
        double term = 0;
        for (Eigen::Index m = r % 2; m < terms.degrees(); m += 2)
          term += terms.pixel_basis()(m, r) * (r % 2 == 0 ? even : odd)(m / 2, k);
        const double phase = phase_rad * cosines(2 * k + 1);
        of_even(k, r) = term * (r % 2 == 0 ? std::cos(phase) : std::sin(phase));
        of_odd(k, r) = term * (r % 2 == 0 ? std::sin(phase) : std::cos(phase));
      }
    const Eigen::MatrixXd even_rows = even * of_even * (4.0 / static_cast<double>(nodes)),
                          odd_rows = odd * of_odd * (4.0 / static_cast<double>(nodes));
    coefficients_.resize(nodes, count);
    for (Eigen::Index p = 0; p < nodes; ++p)
      coefficients_.row(p) = p % 2 == 0 ? even_rows.row(p / 2) : odd_rows.row(p / 2);
    coefficients_.row(0) /= 2;
    truncate(tolerance);
  }

  int degrees() const { return static_cast<int>(coefficients_.rows()); }
  double error_bound() const { return error_bound_; }

  /// C_pr, or C_pr / i where it is imaginary.
  double coefficient(int p, int r) const { return coefficients_(p, r); }
  static bool imaginary(int p, int r) { return (p + r) % 2 != 0; }

  /// Bound on the sum over p of abs(sum_r T_r(tau) C_pr), by Cauchy and Schwarz: the mean square of
  /// exp(i c r s) over the Chebyshev weight is 1.
  double norm() const { return std::sqrt(2.0 * degrees()); }

 private:
  void truncate(double tolerance) {
    constexpr double rounding = 4e-16;  // of the coefficients: not part of the series' tail
    Eigen::Index count = coefficients_.rows();
    for (; count > 1; --count) {
      const double row = (coefficients_.row(count - 1).array().abs() - rounding).max(0.0).sum();
      if (!(error_bound_ + row <= tolerance)) break;
      error_bound_ += row;
    }
    coefficients_ = Eigen::MatrixXd(coefficients_.topRows(count));
  }

  Eigen::MatrixXd coefficients_;
  double error_bound_ = 0;
};

}  // namespace brdf
