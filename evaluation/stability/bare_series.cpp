// exp(i x s), s in [-1, 1], by the two series alone. The program sums in double; the sums in float
// show what single precision would do, as on a graphics card.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <complex>
#include <concepts>
#include <limits>

#include "brdf/chebyshev_fit.h"
#include "brdf/taylor_bounds.h"
#include "evaluation/stability/groups.h"

namespace evaluation::stability {
namespace {

constexpr const char* depths = "phase depth 1e-6 to 200 rad";
constexpr double all_depths_rad[] = {1e-6, 1e-3, 0.1, 1,  2,  5,   10,  15,
                                     20,   30,   40,  50, 70, 100, 150, 200};
constexpr int steps = 32;

template <std::floating_point Real>
constexpr double unit_roundoff = std::numeric_limits<Real>::epsilon() / 2.0;

template <std::floating_point Real>
constexpr const char* precision = std::same_as<Real, float> ? "float" : "double";

double error_at(double x, double s, std::complex<double> value) {
  using Wide = boost::multiprecision::cpp_bin_float_50;
  const Wide phase = Wide(x) * Wide(s);
  const Wide re = Wide(value.real()) - cos(phase), im = Wide(value.imag()) - sin(phase);
  return static_cast<double>(sqrt(re * re + im * im));
}

/// sum (i y)^n / n! until the terms no longer count.
template <std::floating_point Real>
std::complex<double> taylor_sum(Real y) {
  Real term = 1, parts[2] = {1, 0};
  for (int n = 1; n <= brdf::max_taylor_terms; ++n) {
    term *= y / static_cast<Real>(n);
    parts[n % 2] += (n & 2) != 0 ? -term : term;
    if (std::abs(y) < static_cast<Real>(n) && std::abs(term) < unit_roundoff<Real> / 4) break;
  }
  return {parts[0], parts[1]};
}

template <std::floating_point Real>
CheckRow taylor_row() {
  CheckTally tally(std::string("bare Taylor sum in ") + precision<Real>, depths, "of 1",
                   "the terms grow to e^x before they cancel, each with the rounding of those "
                   "before: 2 e^x (1 + x) unit roundoffs; refused where e^x of them exceed 1");
  for (const double depth_rad : all_depths_rad) {
    const double x = depth_rad / 2;
    const std::string where = "depth " + brdf::text(depth_rad) + " rad";
    const double rounding = unit_roundoff<Real> * std::exp(x);
    if (!(rounding <= 1)) {
      tally.refused(where, "rounds by up to " + brdf::text(rounding),
                    CheckTally::Refusal::as_it_should_be);
      continue;
    }
    for (int j = -steps; j <= steps; ++j) {
      const Real y = static_cast<Real>(x) * static_cast<Real>(j) / steps;
      tally.see(error_at(y, 1, taylor_sum(y)), 2 * (1 + x) * rounding, where);
    }
  }
  return tally.row();
}

/// sum c_m T_m(s), by Clenshaw.
template <std::floating_point Real>
Real clenshaw(const std::vector<double>& coefficients, Real s) {
  Real next = 0, current = 0;
  for (std::size_t m = coefficients.size(); m-- > 1;) {
    const Real previous = static_cast<Real>(coefficients[m]) + 2 * s * current - next;
    next = current;
    current = previous;
  }
  return static_cast<Real>(coefficients[0]) + s * current - next;
}

template <std::floating_point Real>
CheckRow chebyshev_row(double limit_in_roundoffs, const char* reason) {
  CheckTally tally(std::string("bare Chebyshev sum in ") + precision<Real>, depths, "of 1", reason);
  for (const double depth_rad : all_depths_rad) {
    const double x = depth_rad / 2;
    // J_m(x) at m = x + 12 x^(1/3) + 16 is below 1e-17.
    const brdf::ChebyshevFit fit(static_cast<int>(x + 12 * std::cbrt(x) + 16));
    std::vector<double> cosines, sines;
    for (std::size_t k = 0; k < fit.count(); ++k) {
      cosines.push_back(std::cos(x * fit.node(k)));
      sines.push_back(std::sin(x * fit.node(k)));
    }
    const std::vector<double> even = fit.chebyshev(cosines), odd = fit.chebyshev(sines);
    for (int j = -steps; j <= steps; ++j) {
      const Real s = static_cast<Real>(j) / steps;
      tally.see(error_at(x, s, {clenshaw(even, s), clenshaw(odd, s)}),
                unit_roundoff<Real> * limit_in_roundoffs * (1 + x),
                "depth " + brdf::text(depth_rad) + " rad");
    }
  }
  return tally.row();
}

}  // namespace

std::vector<CheckRow> bare_series_rows() {
  constexpr const char* reason =
      "each of its x + 17 terms or more is rounded, and in Clenshaw's sum turns s by a roundoff: "
      "32 (1 + x) unit roundoffs; never refused";
  return {taylor_row<double>(), taylor_row<float>(), chebyshev_row<double>(32, reason),
          chebyshev_row<float>(32, reason)};
}

}  // namespace evaluation::stability
