// Copies of a tile side by side: the geometric sum, and what the sources print of it.
#include "brdf/pq_factors.h"

#include <catch2/catch.hpp>

#include "tests/support/exact_sums.h"
#include "tests/support/figure.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::pi;
using brdf::pq_factor;
using exact::Real;

// Below, N is the last index as in the sources: N + 1 copies, x = w T the phase from one to the
// next. Everything is divided by the peak N + 1.
namespace {

struct PQ {
  double p, q;
  double power() const { return p * p + q * q; }
};

/// sum_{n = 0}^{N} e^{-i n x} / (N + 1), term by term.
exact::Complex geometric_sum(Real x, int last) {
  exact::Complex sum = 0;
  for (int n = 0; n <= last; ++n) sum += exact::turned(-n * x);
  return sum / static_cast<Real>(last + 1);
}

/// a + i b over c + i d are the numerator and the denominator of the closed geometric sum.
struct Parts {
  double a, b, c, d;
  Parts(double x, int last)
      : a(1 - std::cos((last + 1) * x)),
        b(std::sin((last + 1) * x)),
        c(1 - std::cos(x)),
        d(std::sin(x)) {}
  double norm(int last) const { return (c * c + d * d) * (last + 1); }
};

PQ thesis_1_48(double x, int last) {
  const Parts t(x, last);
  return {(t.a * t.c + t.b * t.d) / t.norm(last), (t.b * t.c - t.a * t.d) / t.norm(last)};
}

PQ printed_thesis_1_49(double x, int last) {
  const Parts t(x, last);
  return {(t.a * t.c + t.b * t.d) / t.norm(last), (t.b * t.c + t.a * t.d) / t.norm(last)};
}

PQ printed_thesis_1_50(double x, int last) {
  const double p = 0.5 + 0.5 * (std::cos(x * last) - std::cos(x * (last + 1))) / (1 - std::cos(x));
  const double q =
      (std::sin(x * (last + 1)) - std::sin(x * last) - std::sin(x)) / (2 * (1 - std::cos(x)));
  return {p / (last + 1), q / (last + 1)};
}

std::complex<double> printed_thesis_1_42(double x, int last) {
  using Complex = std::complex<double>;
  return (1.0 - std::polar(1.0, x * (last + 1))) / (1.0 - std::polar(1.0, -x)) / Complex(last + 1);
}

/// The same in half angles, without reducing x in cycles first.
double half_angle_form(double x, int last) {
  return std::sin((last + 1) * x / 2) / ((last + 1) * std::sin(x / 2));
}

/// Calls see(x) well away from the orders, where printed forms do not cancel.
template <class See>
void between_orders(See see) {
  for (int i = 1; i < 400; ++i)
    if (i % 100 != 0) see(2 * pi * i / 100);
}

}  // namespace

TEST_CASE("Thesis 1.38-1.48: the factor is the geometric sum of copies about the origin",
          "[identity][oracle]") {
  // sum_{n = 0}^{N} e^{-i n x} = e^{-i N x / 2} times the sum over copies placed symmetrically.
  WorstError error;
  for (const int last : {0, 1, 2, 9, 99})
    for (double cycles = -3.7; cycles <= 3.7; cycles += 0.0137) {
      const Real x = 2 * exact::pi * cycles;
      error.see(exact::difference(pq_factor(cycles, last + 1),
                                  geometric_sum(x, last) * exact::turned(last * x / 2)));
    }
  CHECK(figure("Thesis 1.38-1.48", "factor against the sum, of the peak", error.value()) <= 5e-16);
}

TEST_CASE("Thesis 1.49, 1.50: p and q are the real and the imaginary part", "[identity][oracle]") {
  WorstError split, closed, power;
  for (const int last : {1, 4, 9})
    between_orders([&](double x) {
      const exact::Complex sum = geometric_sum(x, last);
      const PQ right = thesis_1_48(x, last), printed = printed_thesis_1_50(x, last);
      split.see(exact::difference({right.p, right.q}, sum));
      closed.see(exact::difference({printed.p, printed.q}, sum));
      power.see(std::abs(std::pow(pq_factor(x / (2 * pi), last + 1), 2) -
                         static_cast<double>(std::norm(sum))));
    });
  // Phases of up to 250 rad hold 3e-14; the nearest 1 - cos x is 2e-3, the peak up to 10.
  CHECK(figure("Thesis 1.50", "p + i q between the orders, of the peak", closed.value()) <= 1e-12);
  CHECK(split.value() <= 1e-12);
  CHECK(figure("Thesis 1.50", "p^2 + q^2 against the factor's square", power.value()) <= 1e-14);
}

TEST_CASE("Thesis 1.53: in two dimensions the factors multiply", "[identity][oracle]") {
  // A tile and its 3 x 5 copies, pixel by pixel.
  constexpr std::uint64_t seed = 351;
  CAPTURE(seed);
  Uniform uniform(seed);
  const brdf::HeightField tile = random_heights(uniform, {4, 6, 0.2, 0.3}, 0, 0.4);
  WorstError right;
  double one_w_for_both = 0;
  for (int i = 0; i < 100; ++i) {
    const brdf::Query q{uniform(-10, 10), uniform(-10, 10), -20};
    const auto of = [&](exact::Repeats repeats) {
      return exact::transform(tile, q, exact::evenly, exact::phase(-20), repeats).amplitude();
    };
    const auto all = of({.x = 1, .y = 2}), one = of({});
    const double x = pq_factor(q.qx_per_um * tile.width_um() / (2 * pi), 3),
                 y = pq_factor(q.qy_per_um * tile.height_um() / (2 * pi), 5),
                 printed_y = pq_factor(q.qx_per_um * tile.height_um() / (2 * pi), 5);
    right.see(exact::difference(std::complex<double>(one) * x * y, all));
    one_w_for_both =
        std::max(one_w_for_both, exact::difference(std::complex<double>(one) * x * printed_y, all));
  }
  CHECK(figure("Thesis 1.53", "3 x 5 copies of a tile", right.value()) <= 2e-15);
  CHECK(figure("E19", "3 x 5 copies with one w for both axes", one_w_for_both) >= 0.1);
}

TEST_CASE("Erratum E1: Thesis 1.42 has the wrong sign in the numerator",
          "[identity][erratum][E1]") {
  double phase = 0;
  WorstError modulus;
  between_orders([&](double x) {
    const std::complex<double> printed = printed_thesis_1_42(x, 4);
    phase = std::max(phase, exact::difference(printed, geometric_sum(x, 4)));
    modulus.see(std::abs(std::abs(printed) - std::abs(pq_factor(x / (2 * pi), 5))));
  });
  // The power of one row of copies is right all the same, but for the cancellation, as above.
  CHECK(modulus.value() <= 1e-12);
  // The phase is not: minus e^{i (N + 2) x / 2} for e^{-i N x / 2}, the opposite near an order.
  CHECK(figure("E1", "printed sum of 5 copies, of the peak, off by", phase) ==
        Approx(2).epsilon(0.05));
}

TEST_CASE("Erratum E1: N is the last index, not the number of copies", "[identity][erratum][E1]") {
  // Five copies taken for N = 5 are six: the first zero lies at 1/6 instead of 1/5 of a cycle.
  CHECK(std::abs(pq_factor(1.0 / 5, 5)) <= 1e-16);
  CHECK(figure("E1", "six copies at the first zero of five", std::abs(pq_factor(1.0 / 5, 6))) ==
        Approx(1.0 / 6).epsilon(1e-12));
}

TEST_CASE("Erratum E2: Thesis 1.49 has a plus in q", "[identity][erratum][E2]") {
  WorstError right, printed;
  between_orders([&](double x) {
    const double power = std::pow(pq_factor(x / (2 * pi), 5), 2);
    right.see(std::abs(thesis_1_48(x, 4).power() - power));
    printed.see(std::abs(printed_thesis_1_49(x, 4).power() - power));
  });
  CHECK(right.value() <= 1e-12);  // cancellation of 1 - cos x, as above
  CHECK(figure("E2", "printed power of 5 copies, of the peak, off by", printed.value()) ==
        Approx(0.261).epsilon(0.01));
}

TEST_CASE("Erratum E3: Thesis 1.50 fails at the orders", "[identity][erratum][E3]") {
  constexpr int last = 99;
  CHECK(std::isnan(printed_thesis_1_50(0, last).p));
  CHECK(std::isnan(printed_thesis_1_50(1e-10, last).p));
  WorstError printed, ours;
  for (const double x : {1e-6, -1e-6, 0.9e-6, 1.1e-6}) {
    const exact::Complex sum = geometric_sum(x, last);
    const PQ pq = printed_thesis_1_50(x, last);
    printed.see(exact::difference({pq.p, pq.q}, sum));
    ours.see(exact::difference(pq_factor(x / (2 * pi), last + 1),
                               sum * exact::turned(last * static_cast<Real>(x) / 2)));
  }
  // 1 - cos x = 5e-13 holds four digits.
  const double off = figure("E3", "printed p + i q 1e-6 rad from an order", printed.value());
  CHECK(off >= 1e-5);
  CHECK(off <= 1e-3);
  CHECK(figure("E3", "factor 1e-6 rad from an order", ours.value()) <= 5e-16);
}

TEST_CASE("Erratum E3: half angles alone fail at the orders too", "[identity][erratum][E3]") {
  constexpr int last = 99;
  WorstError printed, ours;
  for (int order = 1; order <= 3; ++order) {
    const double peak = order % 2 == 0 ? 1 : -1;  // 100 copies
    printed.see(std::abs(half_angle_form(2 * pi * order, last) - peak));
    ours.see(std::abs(pq_factor(order, last + 1) - peak));
  }
  CHECK(ours.value() == 0);
  // Sines of the rounding of 2 pi m: which order suffers most is chance, but fixed by the doubles.
  CHECK(figure("E3", "half angles at the orders 1 to 3, of the peak, off by", printed.value()) ==
        Approx(1.16).epsilon(0.01));
}

TEST_CASE("Erratum E4: Thesis 1.53 has products of the same kind in q", "[identity][erratum][E4]") {
  WorstError right, printed;
  for (double x1 = 0.1; x1 < 6; x1 += 0.17)
    for (double x2 = 0.1; x2 < 6; x2 += 0.17) {
      const PQ a = thesis_1_48(x1, 4), b = thesis_1_48(x2, 3);
      const double power = std::pow(pq_factor(x1 / (2 * pi), 5) * pq_factor(x2 / (2 * pi), 4), 2);
      const double p = a.p * b.p - a.q * b.q;
      right.see(std::abs(PQ{p, a.p * b.q + a.q * b.p}.power() - power));
      printed.see(std::abs(PQ{p, a.p * b.p + a.q * b.q}.power() - power));
    }
  CHECK(figure("Thesis 1.53", "power of 5 x 4 copies, q = p1 q2 + q1 p2", right.value()) <= 1e-13);
  CHECK(figure("E4", "printed power of 5 x 4 copies, of the peak, off by", printed.value()) ==
        Approx(0.852).epsilon(0.01));
}

TEST_CASE("Erratum E14: the power takes p^2 + q^2, k is 2 pi / lambda, the limit is N + 1",
          "[identity][erratum][E14]") {
  // The Repository scales the power by sqrt(p^2 + q^2): sidelobes of 0.2 in amplitude stay 0.2.
  WorstError root;
  between_orders([&](double x) {
    const double factor = std::abs(pq_factor(x / (2 * pi), 10));
    root.see(factor - factor * factor);
  });
  CHECK(figure("E14", "power by the root, 10 copies, of the peak, off by", root.value()) ==
        Approx(0.25).epsilon(0.05));  // x - x^2 at 1/2
  // k = 1 / lambda puts the first order of T at 1 / 2 pi of a cycle.
  CHECK(figure("E14", "power of order 1 with k = 1 / lambda, 10 copies; right: 1",
               std::pow(pq_factor(1 / (2 * pi), 10), 2)) ==
        Approx(std::pow(std::sin(5) / (10 * std::sin(0.5)), 2)).epsilon(1e-13));
  CHECK(pq_factor(0, 10) == 1);
  const double limit_n = 9.0 / 10;
  CHECK(figure("E14", "peak amplitude of 10 copies with the limit N = 9; right: 1", limit_n) < 1);
}
