#include "brdf/chebyshev_terms.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

using namespace brdf;

namespace {

std::complex<double> series(const ChebyshevTerms& terms, double tau, double s) {
  std::complex<double> sum = 0;
  for (int r = 0; r < terms.count(); ++r) {
    double u = 0, a = 0;
    for (int n = 0; n < terms.degrees(); ++n) {
      const double weight =
          terms.query_basis().size() > 0 ? terms.query_basis()(n, r) : (n == r ? 1.0 : 0.0);
      u += weight * std::cos(n * std::acos(tau));
      a += terms.pixel_basis()(n, r) * std::cos(n * std::acos(s));
    }
    sum += terms.odd(r) ? std::complex<double>(0, u * a) : std::complex<double>(u * a, 0);
  }
  return sum;
}

}  // namespace

TEST_CASE("series meets exp(i x tau s) within its bound", "[chebyshev_terms][oracle]") {
  const double x = GENERATE(0.0, 1e-9, 0.3, 2.36, 4.71, 10.0, 40.0, 100.0);
  const double tolerance = GENERATE(1e-1, 1e-3, 1e-6, 1e-9, 1e-12);
  const auto basis = GENERATE(SeriesBasis::chebyshev, SeriesBasis::modes);
  const ChebyshevTerms terms(x, tolerance, basis);
  CAPTURE(x, tolerance, terms.count());
  CHECK(terms.error_bound() <= tolerance);
  for (double tau = -1; tau <= 1; tau += 0.25)
    for (double s = -1; s <= 1; s += 0.125)
      // 1e-15 per term and unit of phase: the rounding of coefficients and of exp itself.
      CHECK(std::abs(series(terms, tau, s) - std::polar(1.0, x * tau * s)) <=
            terms.error_bound() + 1e-15 * (10 + terms.count() + x));
}

TEST_CASE("terms are those of the Bessel tail", "[chebyshev_terms][golden]") {
  // Smallest M with 2 sum_{m >= M} abs(J_m(x)) <= tolerance, from 40-digit arithmetic. The double
  // series leaves both tails out, so that it may need one term more.
  struct Row {
    double x, tolerance;
    int terms;
  };
  for (const Row& row : {Row{2.36, 1e-3, 8}, Row{2.36, 1e-12, 17}, Row{10, 1e-6, 23},
                         Row{40, 1e-9, 66}, Row{100, 1e-12, 143}}) {
    CAPTURE(row.x, row.tolerance);
    const int terms = ChebyshevTerms(row.x, row.tolerance).count();
    CHECK(terms >= row.terms - 1);
    CHECK(terms <= row.terms + 1);
  }
}

TEST_CASE("modes are never more than the Chebyshev terms", "[chebyshev_terms][invariant]") {
  for (const double x : {0.0, 0.5, 1.2, 4.71, 10.0, 25.0})
    for (const double tolerance : {1e-3, 1e-7, 1e-10}) {
      CAPTURE(x, tolerance);
      CHECK(ChebyshevTerms(x, tolerance, SeriesBasis::modes).count() <=
            ChebyshevTerms(x, tolerance).count());
    }
}
