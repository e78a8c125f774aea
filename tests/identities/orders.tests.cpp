// Closed forms of the orders of infinite gratings, and the expansion that never cancels.
#include <catch2/catch.hpp>

#include "brdf/chebyshev_terms.h"
#include "brdf/direct_sum.h"
#include "tests/support/amplitudes.h"
#include "tests/support/exact_sums.h"
#include "tests/support/figure.h"
#include "tests/support/surfaces.h"

using brdf::Facing;
using brdf::Length;
using brdf::pi;
using brdf::Profile;
using exact::Real;

namespace {

constexpr double period_um = 2.5, height_um = 0.4;
constexpr int samples = 200;

brdf::HeightField profile(Profile kind, double duty = 0.5, Facing facing = Facing::plus_x) {
  return one_period({.profile = kind,
                     .period = Length::um(period_um),
                     .height = Length::um(height_um),
                     .duty = duty,
                     .facing = facing},
                    samples);
}

/// Worst difference of the powers of orders -6 to 6 at phase depths C H up to 12 from a closed form
/// power(m, C H).
template <class Power>
double worst_of_orders(const brdf::HeightField& field, Power closed_form) {
  WorstError error;
  for (const double depth : {0.1, 1.0, pi, 4.0, 2 * pi, 9.0, 12.0})
    for (int m = -6; m <= 6; ++m) {
      const double power = std::norm(amplitude(brdf::DirectSum{}, separate_lines(field),
                                               order_query(m, period_um, depth / height_um)));
      error.see(std::abs(power - static_cast<double>(closed_form(m, static_cast<Real>(depth)))));
    }
  return error.value();
}

/// sin(n x) / (n sin x), 1 at 0.
Real dirichlet(int n, Real x) {
  return x == 0 ? 1 : std::sin(n * x) / (n * std::sin(x));
}

// Phases of up to 40 rad carry 1e-14 each, and average; powers double it.
constexpr double rounding = 1e-14;
// With n samples a period an edge loses (pi a / n)^2 / 3 of its sinc^2(pi a): 1 / (3 n^2).
constexpr double edges = 1.0 / (3.0 * samples * samples);

}  // namespace

TEST_CASE("orders: a sinusoid has J_m(C H / 2)^2", "[identity][oracle]") {
  const double error = worst_of_orders(profile(Profile::sinusoid), [](int m, Real depth) {
    const Real j = exact::bessel_j(m, depth / 2);
    return j * j;
  });
  CHECK(figure("orders", "sinusoid, power", error) <= rounding);
}

TEST_CASE("orders: a rising sawtooth has sinc^2(m + C H / 2 pi), a falling one minus",
          "[identity][oracle]") {
  for (const auto& [facing, sign] : {std::pair{Facing::minus_x, 1}, {Facing::plus_x, -1}}) {
    const brdf::HeightField field = profile(Profile::blazed, 0.5, facing);
    const double sampled = worst_of_orders(field, [sign = sign](int m, Real depth) {
      const Real d = dirichlet(samples, (exact::pi * m + sign * depth / 2) / samples);
      return d * d;
    });
    const double continuous = worst_of_orders(field, [sign = sign](int m, Real depth) {
      const Real s = exact::sinc(exact::pi * m + sign * depth / 2);
      return s * s;
    });
    CHECK(figure("orders", "sawtooth of 200 samples, power against its sum", sampled) <= rounding);
    CHECK(figure("orders", "sawtooth of 200 samples, power against sinc^2", continuous) <=
          1.01 * edges);  // and its next term
  }
}

TEST_CASE("orders: a lamellar grating has 4 sin^2(C H / 2) sin^2(pi m f) / (pi m)^2",
          "[identity][oracle]") {
  for (const double duty : {0.5, 0.3}) {
    const double error =
        worst_of_orders(profile(Profile::lamellar, duty), [duty](int m, Real depth) {
          const Real s = std::sin(depth / 2), f = duty;
          if (m == 0) return 1 - 4 * f * (1 - f) * s * s;
          const Real of_duty = std::sin(exact::pi * m * f) / (exact::pi * m);
          return 4 * s * s * of_duty * of_duty;
        });
    // Two edges, each as above, in phase at worst; and the next term.
    CHECK(figure("orders", "lamellar of 200 samples, power", error) <= 1.01 * 4 * edges);
  }
}

TEST_CASE("orders: n slits give sin(n x / 2) / (n sin(x / 2))", "[identity][oracle]") {
  const int slits = 7;
  const brdf::HeightField slit(brdf::HeightArray::Zero(1, 1), Length::um(period_um), Length::um(1));
  const brdf::Surface surface{&slit,
                              brdf::GaussianWindow(Length::um(1)),
                              brdf::SurfaceModel::replicated,
                              brdf::Origin::patch_centre,
                              {.x = slits, .y = 1}};
  WorstError error;
  for (double q = -8; q <= 8; q += 0.037)
    error.see(exact::difference(amplitude(brdf::DirectSum{}, surface, {q, 0, 0}),
                                dirichlet(slits, static_cast<Real>(q) * period_um / 2)));
  CHECK(figure("orders", "7 slits, amplitude", error.value()) <= 4e-15);  // phases up to 60 rad
}

TEST_CASE("orders: at fixed C their powers sum to 1", "[identity][oracle]") {
  // Parseval: the n orders of n samples, whatever the profile.
  for (const Profile kind : {Profile::sinusoid, Profile::blazed, Profile::lamellar}) {
    const brdf::HeightField field = profile(kind);
    double sum = 0;
    for (int m = -samples / 2; m < samples / 2; ++m)
      sum += std::norm(amplitude(brdf::DirectSum{}, separate_lines(field),
                                 order_query(m, period_um, 6 / height_um)));
    CHECK(figure("orders", "sum of the powers, less 1", std::abs(sum - 1)) <= 1e-13);  // 200 terms
  }
}

TEST_CASE("Jacobi-Anger: the coefficients at one frequency are (2 - delta_m0) i^m J_m",
          "[identity][oracle]") {
  // exp(i x tau s) = sum_nm M_nm T_n(tau) T_m(s); at tau = 1 the sum over n is the one-dimensional
  // expansion of exp(i x s).
  WorstError error;
  for (const double x : {0.3, 2.36, 4.71, 10.0, 40.0, 100.0}) {
    const brdf::ChebyshevTerms terms(x, 1e-14);
    for (int m = 0; m < terms.degrees(); ++m) {
      const double at_one = terms.pixel_basis().row(m).sum();  // M is symmetric
      const Real bessel = (m == 0 ? 1 : 2) * exact::bessel_j(m, x);
      const Real sign = m % 4 < 2 ? 1 : -1;  // i^m less the factor i of odd m
      error.see(static_cast<double>(std::abs(at_one - sign * bessel)));
    }
  }
  // The tolerance, and coefficients rounded at 4e-16, up to 150 in a sum.
  CHECK(figure("Jacobi-Anger", "coefficients against Bessel functions", error.value()) <= 6e-14);
}

TEST_CASE("Jacobi-Anger: the terms needed are known beforehand", "[identity][oracle]") {
  struct Row {
    double x;
    int terms[4];  ///< for 1e-3, 1e-6, 1e-9, 1e-12
  };
  double most_extra = 0;
  for (const Row& row :
       {Row{2.36, {8, 11, 14, 17}}, Row{4.71, {11, 15, 19, 22}}, Row{10, {18, 23, 27, 31}},
        Row{40, {52, 60, 66, 72}}, Row{100, {116, 126, 135, 143}}})
    for (int i = 0; i < 4; ++i) {
      const double tolerance = std::pow(10, -3 * (i + 1));
      CAPTURE(row.x, tolerance);
      // Smallest M with 2 sum_{m >= M} |J_m(x)| <= tolerance; 60 more than needed are nothing.
      Real tail = 0;
      int m = row.terms[3] + 60;
      while (2 * (tail + std::abs(exact::bessel_j(m - 1, row.x))) <= tolerance)
        tail += std::abs(exact::bessel_j(--m, row.x));
      CHECK(m == row.terms[i]);
      // The double series leaves out the tails of both variables.
      const int count = brdf::ChebyshevTerms(row.x, tolerance).count();
      CHECK(std::abs(count - m) <= 1);
      most_extra = std::max(most_extra, std::abs(static_cast<double>(count - m)));
    }
  figure("Jacobi-Anger", "terms of the double series less those of the tail", most_extra);
}
