// What the sources print about the series, beside what is right.
#include <catch2/catch.hpp>

#include "brdf/direct_sum.h"
#include "brdf/taylor_series.h"
#include "tests/support/amplitudes.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"

using brdf::DirectSum;
using brdf::GaussianWindow;
using brdf::HeightField;
using brdf::Length;
using brdf::Origin;
using brdf::pi;
using brdf::Surface;
using brdf::SurfaceModel;
using brdf::TaylorSeries;
using Complex = std::complex<double>;

namespace {

/// A sinusoid of phase depth 2 x; order 0 has the amplitude J_0(x).
constexpr double height_um = 0.2;
HeightField sinusoid() {
  return one_period({.profile = brdf::Profile::sinusoid,
                     .period = Length::um(2.5),
                     .height = Length::um(height_um)},
                    64);
}

/// Order 0 of F{s^n} for the sinusoid s = cos: binomial(n, n/2) / 2^n.
double mean_of_power(int n) {
  if (n % 2 == 1) return 0;
  double mean = 1;
  for (int i = 1; i <= n / 2; ++i) mean *= (2.0 * i - 1) / (2.0 * i);
  return mean;
}

/// sup of abs(e^{ix} - first terms): the tail, summed from its small end.
double measured_remainder(double x, int terms) {
  Complex tail = 0, term = 1;
  std::vector<Complex> all;
  for (int n = 0; n < terms + 40; ++n) {
    if (n >= terms) all.push_back(term);
    term *= Complex(0, x / (n + 1));
  }
  for (auto it = all.rbegin(); it != all.rend(); ++it) tail += *it;
  return std::abs(tail);
}

}  // namespace

TEST_CASE("Thesis 1.31 bounds an imaginary exponent by e^x too much",
          "[taylor_series][erratum][E7]") {
  const double x = 1.5 * pi;
  // The last power kept is 20, 25, 30: one term more. Numbers of four digits.
  for (const auto& [last, printed, bound, measured] : {std::tuple{20, 2.994e-4, 2.690e-6, 2.635e-6},
                                                       {25, 8.815e-8, 7.919e-10, 7.809e-10},
                                                       {30, 1.0047e-11, 9.025e-14, 8.934e-14}}) {
    CAPTURE(last);
    const double ours = brdf::taylor_remainder_bound(x, last + 1);
    CHECK(std::abs(ours / bound - 1) <= 2e-4);
    CHECK(std::abs(measured_remainder(x, last + 1) / measured - 1) <= 2e-4);
    CHECK(measured_remainder(x, last + 1) <= ours);
    CHECK(std::abs(std::exp(x) * ours / printed - 1) <= 2e-4);  // a factor of 111
  }
  CHECK(brdf::taylor_remainder_bound(-x, 21) == brdf::taylor_remainder_bound(x, 21));
}

TEST_CASE("the rounding of the series grows as e^x", "[taylor_series][oracle]") {
  // Terms of e^{ix} summed as the series does; x = 10, 20, 30.
  for (const double x : {10.0, 20.0, 30.0}) {
    Complex sum = 0, term = 1;
    for (int n = 0; n < 200; ++n) {
      sum += term;
      term *= Complex(0, x / (n + 1));
    }
    const double error = std::abs(sum - std::polar(1.0, x));
    CAPTURE(x);
    CHECK(error <= brdf::taylor_rounding_bound(x));
    CHECK(error >= brdf::taylor_rounding_bound(x) / 1000);
  }
  CHECK(brdf::taylor_rounding_bound(0) == 0x1p-53);
  CHECK(brdf::taylor_rounding_bound(-30) == brdf::taylor_rounding_bound(30));
}

TEST_CASE("Thesis 1.37 takes the modulus inside the sums", "[taylor_series][erratum][E5]") {
  // Order 0 at x = C H / 2 = pi/2: J_0^2 = 0.22278; the printed sum of moduli is
  // sum (x/2)^{4k} / k!^4 = 1.40, more light than falls in.
  const HeightField field = sinusoid();
  const double x = pi / 2, c = -2 * x / height_um;
  const Complex right = amplitude(TaylorSeries{}, separate_lines(field), {0, 0, c});
  CHECK(std::abs(std::norm(right) - 0.2227851476866917) <= 1e-14);  // rounding of e^x terms
  double inside = 0, coefficient = 1;
  for (int n = 0; n < 40; ++n) {
    inside += std::norm(coefficient * mean_of_power(n));
    coefficient *= x / (n + 1);
  }
  CHECK(inside >= 1.3);
  // The modulus inside the sum over neighbours: between two lines of a rough patch they interfere.
  constexpr std::uint64_t seed = 91;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField rough = random_heights(uniform, {1, 32, 0.1, 1}, 0, 0.1);
  const Surface surface{&rough, GaussianWindow(Length::um(0.8)), SurfaceModel::periodic};
  const brdf::Query between{2 * pi * 3.5 / 3.2, 0, -20};
  const brdf::PeriodicBins bins(surface.window, brdf::x_axis(surface), 8);
  double of_lines = 0;
  for (long bin = -10; bin <= 20; ++bin) {
    const Complex line = amplitude(DirectSum{}, separate_lines(rough),
                                   {2 * pi * static_cast<double>(bin) / 3.2, 0, -20});
    of_lines += std::norm(line) * bins.weight(between.qx_per_um, bin);
  }
  const double power = std::norm(amplitude(TaylorSeries{}, surface, between));
  CHECK(std::abs(power - std::norm(amplitude(DirectSum{}, surface, between))) <= 1e-13);
  CHECK(std::abs(of_lines / power - 1) >= 0.1);
}

TEST_CASE("Thesis 1.35 multiplies every amplitude by pi", "[taylor_series][erratum][E6]") {
  const HeightField flat = sampled(8, 8, 0.1, 0.1, [](double, double) { return 0.3; });
  const Surface surface{&flat, GaussianWindow(Length::um(0.4)), SurfaceModel::periodic};
  const double right = std::abs(amplitude(TaylorSeries{}, surface, {0, 0, -20}));
  CHECK(std::abs(right - 1) <= 1e-14);  // a few neighbours' rounding
  CHECK(std::abs(pi * right - 1) >= 2);
}

TEST_CASE("Thesis 1.25 has the height once too often", "[taylor_series][erratum][E22]") {
  // (i k w h)^n / n! F{h^n} counts h^n twice: with h = 0.2 um it is J_0 of a depth of h^2.
  const HeightField field = sinusoid();
  const double c = -20;
  const auto by_powers = [&](double argument) {
    Complex sum = 0, coefficient = 1;
    for (int n = 0; n < 60; ++n) {
      sum += coefficient * mean_of_power(n);
      coefficient *= Complex(0, argument / (n + 1));
    }
    return sum;
  };
  const double half_um = height_um / 2;
  const double right = std::abs(amplitude(TaylorSeries{}, separate_lines(field), {0, 0, c}));
  CHECK(std::abs(right - std::abs(by_powers(c * half_um))) <= 1e-14);  // J_0(2) = 0.2239
  CHECK(std::abs(right - std::abs(by_powers(c * half_um * half_um))) >= 0.5);
}

TEST_CASE("a window on the patch's corner sees another surface", "[taylor_series][erratum][E17]") {
  constexpr std::uint64_t seed = 92;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, {24, 24, 0.1, 0.1}, 0, 0.3);
  const GaussianWindow window(Length::um(0.6));
  const Surface centre{&field, window, SurfaceModel::periodic};
  const Surface corner{&field, window, SurfaceModel::periodic, Origin::patch_corner};
  double largest = 0;
  for (int i = 0; i < 20; ++i) {
    const brdf::Query q{uniform(-15, 15), uniform(-15, 15), -25};
    largest = std::max(largest, std::abs(std::abs(amplitude(TaylorSeries{}, centre, q)) -
                                         std::abs(amplitude(TaylorSeries{}, corner, q))));
  }
  CHECK(largest >= 0.02);  // against amplitudes of about 0.05
}

TEST_CASE("w = +1 turns the relief inside out", "[taylor_series][erratum][E13]") {
  // A blaze falling in +x at phase depth 2 pi sends everything to order +1; with the other sign
  // of w, to order -1, as if it rose.
  const HeightField field =
      one_period({.period = Length::um(2.5), .height = Length::um(height_um)}, 100);
  const double c = 2 * pi / height_um;
  const auto power = [&](int order, double w_sign) {
    brdf::Query q = order_query(order, 2.5, c);
    q.c_per_um = w_sign * c;
    return std::norm(amplitude(TaylorSeries{}, separate_lines(field), q));
  };
  CHECK(std::abs(power(1, -1) - 1) <= 1e-14);  // all pixels in phase, e^pi terms
  CHECK(power(-1, -1) <= 1e-14);
  CHECK(std::abs(power(-1, 1) - 1) <= 1e-14);
  CHECK(power(1, 1) <= 1e-14);
}
