#include "brdf/chebyshev_carrier.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

using namespace brdf;

namespace {

using Complex = std::complex<double>;

double chebyshev(int n, double s) {
  return std::cos(n * std::acos(s));
}

/// sum_r i^(r odd) T_r(tau) sum_p C_pr T_p(s).
Complex carried_series(const CarriedTerms& carried, const ChebyshevTerms& terms, double tau,
                       double s) {
  Complex sum = 0;
  for (int r = 0; r < terms.count(); ++r) {
    Complex term = 0;
    for (int p = 0; p < carried.degrees(); ++p)
      term += (CarriedTerms::imaginary(p, r) ? Complex(0, 1) : Complex(1, 0)) *
              carried.coefficient(p, r) * chebyshev(p, s);
    sum += (r % 2 == 0 ? Complex(1, 0) : Complex(0, 1)) * chebyshev(r, tau) * term;
  }
  return sum;
}

}  // namespace

TEST_CASE("carried terms meet exp(i (phase + x tau) s) within both bounds",
          "[chebyshev_carrier][oracle]") {
  const double x = GENERATE(0.0, 0.5, 4.71, 40.0);
  const double phase_rad = GENERATE(0.0, 1e-9, 1.0, -7.3, 60.0);
  const double tolerance = GENERATE(1e-1, 1e-3, 1e-6, 1e-9, 1e-13);
  const ChebyshevTerms terms(x, tolerance);
  const CarriedTerms carried(terms, phase_rad, tolerance);
  CAPTURE(x, phase_rad, tolerance, terms.count(), carried.degrees());
  CHECK(carried.error_bound() <= tolerance);
  for (double tau = -1; tau <= 1; tau += 0.25)
    for (double s = -1; s <= 1; s += 0.0625)
      // The rounding of coefficients and of the phase itself.
      CHECK(std::abs(carried_series(carried, terms, tau, s) -
                     std::polar(1.0, (phase_rad + x * tau) * s)) <=
            terms.error_bound() + carried.error_bound() +
                1e-15 * (10 + 2 * carried.degrees() + std::abs(phase_rad) + x));
}

TEST_CASE("degrees are those of the Bessel tail", "[chebyshev_carrier][golden]") {
  // One term of an x = 0 series is exp(i phase s) alone: smallest M with 2 sum_{m >= M}
  // abs(J_m(phase)) <= tolerance, as in chebyshev_terms.tests.cpp.
  struct Row {
    double phase_rad, tolerance;
    int degrees;
  };
  for (const Row& row : {Row{2.36, 1e-3, 8}, Row{-2.36, 1e-12, 17}, Row{10, 1e-6, 23},
                         Row{40, 1e-9, 66}, Row{100, 1e-12, 143}}) {
    CAPTURE(row.phase_rad, row.tolerance);
    const CarriedTerms carried(ChebyshevTerms(0, 1e-15), row.phase_rad, row.tolerance);
    CHECK(std::abs(carried.degrees() - row.degrees) <= 1);
  }
}

TEST_CASE("moments amplify rounding by no more than the norm", "[chebyshev_carrier][invariant]") {
  const double x = GENERATE(0.0, 0.5, 10.0), phase_rad = GENERATE(0.0, 1.0, 30.0);
  const ChebyshevTerms terms(x, 1e-12);
  const CarriedTerms carried(terms, phase_rad, 1e-12);
  CAPTURE(x, phase_rad);
  for (double tau = -1; tau <= 1; tau += 0.125) {
    double sum = 0;
    for (int p = 0; p < carried.degrees(); ++p) {
      Complex coefficient = 0;
      for (int r = 0; r < terms.count(); ++r)
        coefficient += (CarriedTerms::imaginary(p, r) ? Complex(0, 1) : Complex(1, 0)) *
                       (r % 2 == 0 ? Complex(1, 0) : Complex(0, 1)) * chebyshev(r, tau) *
                       carried.coefficient(p, r);
      sum += std::abs(coefficient);
    }
    CHECK(sum <= carried.norm() + 1e-11);  // the tolerance of both series, a few times
  }
}
