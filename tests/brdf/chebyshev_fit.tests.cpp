#include "brdf/chebyshev_fit.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace brdf;

namespace {

double power_sum(const std::vector<double>& coefficients, double t) {
  double sum = 0;
  for (std::size_t n = coefficients.size(); n-- > 0;) sum = sum * t + coefficients[n];
  return sum;
}

}  // namespace

TEST_CASE("a polynomial is fitted exactly", "[chebyshev_fit][oracle]") {
  const std::vector<double> polynomial{0.25, -1, 0.5, 3, -0.125};
  const int degree = GENERATE(4, 5, 9);
  const std::vector<double> fitted =
      ChebyshevFit(degree)([&](double t) { return power_sum(polynomial, t); });
  REQUIRE(fitted.size() == static_cast<std::size_t>(degree) + 1);
  for (std::size_t n = 0; n < fitted.size(); ++n)
    // Rounding of values below 5, times the powers of T_9, up to 576.
    CHECK(std::abs(fitted[n] - (n < polynomial.size() ? polynomial[n] : 0)) <= 1e-12);
}

TEST_CASE("coefficients are those of T_n and sum to the function", "[chebyshev_fit][oracle]") {
  // exp(t) = I_0(1) + 2 sum I_n(1) T_n(t).
  const ChebyshevFit fit(16);
  std::vector<double> values;
  for (std::size_t k = 0; k < fit.count(); ++k) values.push_back(std::exp(fit.node(k)));
  const std::vector<double> coefficients = fit.chebyshev(values);
  for (std::size_t n = 0; n < 8; ++n)
    CHECK(std::abs(coefficients[n] -
                   (n == 0 ? 1 : 2) * std::cyl_bessel_i(static_cast<double>(n), 1.0)) <= 4e-15);
  for (double t = -1; t <= 1; t += 0.03125) {
    CHECK(std::abs(chebyshev_sum(coefficients, t) - std::exp(t)) <= 4e-15);
    CHECK(std::abs(power_sum(fit.monomials(coefficients), t) - std::exp(t)) <= 4e-14);
  }
}

TEST_CASE("the first coefficients alone make a polynomial of lower degree",
          "[chebyshev_fit][invariant]") {
  const std::vector<double> coefficients{1, -0.5, 0.25};
  const std::vector<double> monomials = ChebyshevFit(12).monomials(coefficients);
  REQUIRE(monomials.size() == 3);
  for (double t = -1; t <= 1; t += 0.125)
    CHECK(std::abs(power_sum(monomials, t) - chebyshev_sum(coefficients, t)) <= 4e-16);
}
