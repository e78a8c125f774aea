// exp(i x tau s) as a double Chebyshev series.
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "brdf/units.h"

namespace brdf {

/// Functions that a double Chebyshev series is kept in.
enum class SeriesBasis {
  chebyshev,  ///< T_n(tau) themselves: nothing to compute but the recurrence
  modes,      ///< the eigenvectors of M: the fewest terms, each a sum of T_n
};

/// exp(i x tau s) = sum_{r < count} u_r(tau) a_r(s), u_r = sum_n U_nr T_n, a_r = sum_m A_mr T_m,
/// tau and s in [-1, 1], from M_nm with exp(i x tau s) = sum_{n, m < degrees} M_nm T_n(tau) T_m(s).
///
/// M_nm = sum of the samples at the Chebyshev nodes of both variables times T_n T_m: two cosine
/// transforms, which do not amplify anything; no Bessel function is needed. Real where n and m are
/// even, imaginary where both are odd, else 0. |M_nm| falls faster than any power beyond x / 2.
/// - chebyshev: U = 1, A = M, as many degrees as the tolerance needs;
/// - modes: M is symmetric, M = Q L Q^T in each parity, U = Q and A = Q L, the even ones first:
///   a fifth fewer terms at x = 1, a third at x = 10.
/// `error_bound` is the sum of the |M_nm| left out. Cost: x^3 products, microseconds below x = 30.
class ChebyshevTerms {
 public:
  /// x: >= 0.
  ChebyshevTerms(double x, double tolerance, SeriesBasis basis = SeriesBasis::chebyshev) {
    // J_m(x) at m = x + 12 x^(1/3) + 16 is below 1e-17, so the samples alias nothing.
    const int half = static_cast<int>(std::ceil((x + 12 * std::cbrt(x) + 16) / 2));
    const int nodes = 2 * half;
    Eigen::MatrixXd cosine(half, half), sine(half, half), even(half, half), odd(half, half);
    for (int j = 0; j < half; ++j) {
      const double s_j = std::cos(pi * (j + 0.5) / nodes);
      for (int k = 0; k < half; ++k) {
        const double phase = x * s_j * std::cos(pi * (k + 0.5) / nodes);
        cosine(j, k) = std::cos(phase);
        sine(j, k) = std::sin(phase);
      }
    }
    // T_m at the positive nodes; the negative ones only double the sums.
    for (int m = 0; m < half; ++m)
      for (int k = 0; k < half; ++k) {
        const double angle = pi * (k + 0.5) / nodes;
        even(m, k) = (m == 0 ? 2.0 : 4.0) / nodes * std::cos(2 * m * angle);
        odd(m, k) = 4.0 / nodes * std::cos((2 * m + 1) * angle);
      }
    const Eigen::MatrixXd even_terms = even * cosine * even.transpose();
    const Eigen::MatrixXd odd_terms = odd * sine * odd.transpose();
    const bool modes = basis == SeriesBasis::modes;
    truncate(even_terms, odd_terms, modes ? tolerance / 4 : tolerance);
    if (modes) find_modes(tolerance - error_bound_);
  }

  int count() const { return static_cast<int>(pixel_basis_.cols()); }
  int degrees() const { return static_cast<int>(pixel_basis_.rows()); }
  double error_bound() const { return error_bound_; }

  /// A_mr without the factor i of odd r.
  const Eigen::MatrixXd& pixel_basis() const { return pixel_basis_; }
  /// U_nr; empty where it is 1.
  const Eigen::MatrixXd& query_basis() const { return query_basis_; }
  /// Terms with even n come first in a basis of modes.
  int even_count() const { return even_count_; }
  /// Whether term r holds odd degrees, and the factor i.
  bool odd(int r) const { return query_basis_.size() > 0 ? r >= even_count_ : r % 2 != 0; }

  /// Bound on sum over r of abs(u_r(tau)) abs(a_r(s)), from a mesh.
  double norm() const {
    constexpr int mesh = 32;
    Eigen::MatrixXd t(mesh + 1, degrees());
    for (int j = 0; j <= mesh; ++j)
      for (int m = 0; m < degrees(); ++m) t(j, m) = std::cos(m * pi * j / (2 * mesh));
    const Eigen::MatrixXd a = (t * pixel_basis_).cwiseAbs();
    if (query_basis_.size() == 0) return a.rowwise().sum().maxCoeff();  // abs(T_n) <= 1
    return ((t * query_basis_).cwiseAbs().colwise().maxCoeff() * a.transpose()).maxCoeff();
  }

 private:
  void truncate(const Eigen::MatrixXd& even, const Eigen::MatrixXd& odd_terms, double tolerance) {
    constexpr double rounding = 4e-16;  // of the coefficients: not part of the series' tail
    const auto at = [&](Eigen::Index n, Eigen::Index m) {
      if ((n + m) % 2 != 0) return 0.0;
      return n % 2 == 0 ? even(n / 2, m / 2) : odd_terms(n / 2, m / 2);
    };
    Eigen::Index count = 2 * even.rows();
    for (; count > 1; --count) {
      double shell = 0;  // coefficients of which the larger index is count - 1
      for (Eigen::Index m = 0; m < count; ++m)
        shell += (m + 1 < count ? 2 : 1) * std::max(0.0, std::abs(at(count - 1, m)) - rounding);
      if (!(error_bound_ + shell <= tolerance)) break;
      error_bound_ += shell;
    }
    pixel_basis_.resize(count, count);
    for (Eigen::Index n = 0; n < count; ++n)
      for (Eigen::Index m = 0; m < count; ++m) pixel_basis_(n, m) = at(n, m);
  }

  /// Keeps the eigenvectors of largest eigenvalue until the rest sums to the tolerance.
  void find_modes(double tolerance) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(pixel_basis_);
    const Eigen::MatrixXd& q = solver.eigenvectors();
    std::vector<Eigen::Index> order(static_cast<std::size_t>(q.cols()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
      return std::abs(solver.eigenvalues()(a)) < std::abs(solver.eigenvalues()(b));
    });
    Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(q.rows(), q.rows());
    double dropped = 0;
    std::size_t first = 0;
    for (; first + 1 < order.size(); ++first) {
      const Eigen::Index r = order[first];
      rest += solver.eigenvalues()(r) * q.col(r) * q.col(r).transpose();
      const double sum = rest.cwiseAbs().sum();
      if (!(sum <= tolerance)) break;
      dropped = sum;
    }
    error_bound_ += dropped;
    order.erase(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(first));
    // An eigenvector has one parity; what it holds of the other is rounding, except where two
    // eigenvalues coincide: those are far below any tolerance.
    const auto even_part = [&](Eigen::Index r) {
      double sum = 0;
      for (Eigen::Index n = 0; n < q.rows(); n += 2) sum += q(n, r) * q(n, r);
      return sum;
    };
    const auto odd_first = std::stable_partition(
        order.begin(), order.end(), [&](Eigen::Index r) { return even_part(r) > 0.5; });
    even_count_ = static_cast<int>(odd_first - order.begin());
    query_basis_ = Eigen::MatrixXd::Zero(q.rows(), static_cast<Eigen::Index>(order.size()));
    Eigen::MatrixXd pixels = query_basis_;
    for (std::size_t r = 0; r < order.size(); ++r)
      for (Eigen::Index n = static_cast<int>(r) < even_count_ ? 0 : 1; n < q.rows(); n += 2) {
        const auto column = static_cast<Eigen::Index>(r);
        query_basis_(n, column) = q(n, order[r]);
        pixels(n, column) = solver.eigenvalues()(order[r]) * q(n, order[r]);
      }
    pixel_basis_ = std::move(pixels);
  }

  Eigen::MatrixXd pixel_basis_, query_basis_;
  int even_count_ = 0;
  double error_bound_ = 0;
};

}  // namespace brdf
