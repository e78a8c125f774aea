// The Taylor series: its steps, and what the sources print about it.
#include "brdf/taylor_series.h"

#include <catch2/catch.hpp>

#include "tests/support/amplitudes.h"
#include "tests/support/exact_sums.h"
#include "tests/support/figure.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"

using brdf::HeightField;
using brdf::Length;
using brdf::pi;
using brdf::TaylorSeries;
using exact::Real;

namespace {

constexpr double height_um = 0.2;

/// A sinusoid of peak-to-valley height_um; order 0 has the amplitude J_0(c h / 2).
HeightField sinusoid() {
  return one_period({.profile = brdf::Profile::sinusoid,
                     .period = Length::um(2.5),
                     .height = Length::um(height_um)},
                    64);
}

TaylorSeries first_terms(int terms) {
  brdf::TaylorSettings settings;
  settings.terms = terms;
  return TaylorSeries(settings);
}

/// Order 0 of F{s^n} for the sinusoid s = cos: binomial(n, n/2) / 2^n.
double mean_of_power(int n) {
  if (n % 2 == 1) return 0;
  double mean = 1;
  for (int i = 1; i <= n / 2; ++i) mean *= (2.0 * i - 1) / (2.0 * i);
  return mean;
}

/// abs(e^{ix} - its first terms): the tail, summed from its small end.
Real measured_remainder(Real x, int terms) {
  std::vector<exact::Complex> tail;
  exact::Complex term = 1;
  for (int n = 0; n < terms + 60; ++n) {
    if (n >= terms) tail.push_back(term);
    term *= exact::Complex(0, x / (n + 1));
  }
  exact::Complex sum = 0;
  for (auto it = tail.rbegin(); it != tail.rend(); ++it) sum += *it;
  return std::abs(sum);
}

/// One row of random heights, between 0.1 and 0.5 um, and frequencies on its lines.
struct Lines {
  Uniform uniform;
  HeightField field = random_heights(uniform, {1, 32, 0.1, 1}, 0.1, 0.5);

  explicit Lines(std::uint64_t seed) : uniform(seed) {}
  brdf::Query query(int line, double c_per_um) const {
    return {2 * pi * line / field.width_um(), 0, c_per_um};
  }
  template <class Function>
  exact::Complex exact_amplitude(const brdf::Query& q, Function f) const {
    return exact::transform(field, q, exact::evenly, f).amplitude();
  }
};

}  // namespace

TEST_CASE("Thesis 1.24: N terms of the series err by what they leave out", "[identity][oracle]") {
  const Lines lines(321);
  double largest = 0;
  for (const double c : {-10.0, -20.0, -40.0})  // phases of +-2, +-4, +-8
    for (int terms = 1; terms <= 40; ++terms) {
      const double bound = brdf::taylor_remainder_bound(c * lines.field.half_range_um(), terms) +
                           brdf::taylor_rounding_bound(c * lines.field.half_range_um());
      const brdf::Query q = lines.query(3, c);
      const double error =
          exact::difference(amplitude(first_terms(terms), separate_lines(lines.field), q),
                            lines.exact_amplitude(q, exact::phase(c)));
      CAPTURE(c, terms, error, bound);
      CHECK(error <= bound);
      largest = std::max(largest, error / bound);
    }
  // A bound is no use where nothing comes near it; pixels average to a third of it or less.
  CHECK(figure("Thesis 1.24", "error over x^N / N! and rounding, at most", largest) >= 0.05);
}

TEST_CASE("Thesis 1.25: term n is (i k w)^n / n! F{h^n}", "[identity][oracle]") {
  const Lines lines(322);
  const double c = -12;
  const Real middle = lines.field.mid_range_um();
  WorstError error;
  for (int n = 0; n <= 20; ++n)
    for (const int line : {0, 5, -9}) {
      const brdf::Query q = lines.query(line, c);
      const auto first = [&](int terms) {
        if (terms == 0) return std::complex<double>(0);
        return amplitude(first_terms(terms), separate_lines(lines.field), q);
      };
      exact::Complex coefficient = exact::turned(c * middle);
      for (int i = 1; i <= n; ++i) coefficient *= exact::Complex(0, Real(c) / i);
      const exact::Complex term = coefficient * lines.exact_amplitude(q, [&](Real h) {
        return exact::Complex(std::pow(h - middle, n));
      });
      error.see(exact::difference(first(n + 1) - first(n), term));
    }
  // The difference of two sums of size up to 1, whose terms reach e^2.4 / 5.
  CHECK(figure("Thesis 1.25", "term n = 0 to 20", error.value()) <= 2e-15);
}

TEST_CASE("Thesis 1.32: P is the series of the transforms", "[identity][oracle]") {
  const Lines lines(323);
  WorstError error;
  for (const double c : {-5.0, -15.0, -25.0})
    for (int line = -16; line <= 16; ++line) {
      const brdf::Query q = lines.query(line, c);
      error.see(exact::difference(amplitude(TaylorSeries{}, separate_lines(lines.field), q),
                                  lines.exact_amplitude(q, exact::phase(c))));
    }
  // Terms reach e^5 / sqrt(10 pi) = 26 before they cancel; each carries its rounding, 1e-16.
  CHECK(figure("Thesis 1.32", "amplitude on the lines", error.value()) <= 2e-14);
}

TEST_CASE("Erratum E7: Thesis 1.31 bounds an imaginary exponent by e^x too much",
          "[identity][erratum][E7]") {
  const double x = 1.5 * pi;
  // The last power kept is 20, 25, 30: one term more. Numbers of four digits.
  for (const auto& [last, printed, bound, measured] : {std::tuple{20, 2.994e-4, 2.690e-6, 2.635e-6},
                                                       {25, 8.815e-8, 7.919e-10, 7.809e-10},
                                                       {30, 1.0047e-11, 9.025e-14, 8.934e-14}}) {
    CAPTURE(last);
    const double ours = brdf::taylor_remainder_bound(x, last + 1);
    const auto remainder = static_cast<double>(measured_remainder(x, last + 1));
    CHECK(std::abs(ours / bound - 1) <= 2e-4);
    CHECK(std::abs(remainder / measured - 1) <= 2e-4);
    CHECK(remainder <= ours);
    CHECK(std::abs(std::exp(x) * ours / printed - 1) <= 2e-4);
  }
  CHECK(figure("E7", "printed remainder over the measured one, n up to 25",
               8.815e-8 / static_cast<double>(measured_remainder(x, 26))) ==
        Approx(112.9).epsilon(1e-3));
  CHECK(brdf::taylor_remainder_bound(-x, 21) == brdf::taylor_remainder_bound(x, 21));
}

TEST_CASE("heights from 0 instead of their mid-range need far more terms", "[identity][oracle]") {
  // A scan of 818.69 nm at 380 nm, light at 75 deg, viewer at -40 deg; the powers 0 to 30.
  const brdf::Query q =
      query_in_plane(brdf::Angle::deg(75), brdf::Angle::deg(-40), Length::nm(380));
  const double x = -q.c_per_um * 0.81869;
  // Two digits are known of each.
  CHECK(figure("Thesis 1.31", "bound, 818.69 nm from 0, powers to 30",
               brdf::taylor_remainder_bound(x, 31)) == Approx(31).epsilon(0.02));
  CHECK(figure("Thesis 1.31", "bound, 818.69 nm from mid-range, powers to 30",
               brdf::taylor_remainder_bound(x / 2, 31)) == Approx(1.5e-8).epsilon(0.04));
}

TEST_CASE("the rounding of the series grows as e^x", "[identity][oracle]") {
  for (const double x : {10.0, 20.0, 30.0}) {
    std::complex<double> sum = 0, term = 1;
    for (int n = 0; n < 200; ++n) {
      sum += term;
      term *= std::complex<double>(0, x / (n + 1));
    }
    const double error = exact::difference(sum, exact::turned(x));
    CAPTURE(x);
    CHECK(error <= brdf::taylor_rounding_bound(x));
    CHECK(error >= brdf::taylor_rounding_bound(x) / 1000);
    if (x == 30)  // 2e-4, to its one digit; the last bits differ between libraries
      CHECK(figure("Thesis 1.24", "rounding of e^{30 i} by its series", error) ==
            Approx(2e-4).epsilon(0.5));
  }
  CHECK(brdf::taylor_rounding_bound(0) == 0x1p-53);
  CHECK(brdf::taylor_rounding_bound(-30) == brdf::taylor_rounding_bound(30));
}

TEST_CASE("Erratum E5: Thesis 1.37 takes the modulus inside the sums", "[identity][erratum][E5]") {
  // Order 0 at x = C H / 2 = pi/2: J_0^2 = 0.22278; the printed sum of moduli is
  // sum (x/2)^{4k} / k!^4 = 1.40, more light than falls in.
  const HeightField field = sinusoid();
  const double x = pi / 2, c = -2 * x / height_um;
  const double right = std::norm(amplitude(TaylorSeries{}, separate_lines(field), {0, 0, c}));
  CHECK(std::abs(right - static_cast<double>(std::pow(exact::bessel_j(0, exact::pi / 2), 2))) <=
        1e-14);  // rounding of e^x terms
  double printed_thesis_1_37 = 0, coefficient = 1;
  for (int n = 0; n < 40; ++n) {
    printed_thesis_1_37 += std::norm(coefficient * mean_of_power(n));
    coefficient *= x / (n + 1);
  }
  figure("E5", "power of order 0, modulus outside", right);
  CHECK(figure("E5", "power of order 0, modulus inside the series", printed_thesis_1_37) ==
        Approx(1.40).epsilon(0.01));

  // The modulus inside the sum over neighbours: between two lines of a rough patch they interfere.
  const Lines lines(324);
  const double sigma_um = 0.8;
  const brdf::Surface surface{&lines.field, brdf::GaussianWindow(Length::um(sigma_um)),
                              brdf::SurfaceModel::periodic};
  const brdf::Query between{2 * pi * 3.5 / lines.field.width_um(), 0, -20};
  const brdf::PeriodicBins bins(surface.window, brdf::x_axis(surface), 8);
  double inside = 0;
  for (long bin = bins.first(between.qx_per_um); bin <= bins.last(between.qx_per_um); ++bin)
    inside += bins.weight(between.qx_per_um, bin) *
              static_cast<double>(std::norm(lines.exact_amplitude(
                  lines.query(static_cast<int>(bin), -20), exact::phase(-20))));
  // 9 sigma are 2.3 patches: 3 repetitions on each side.
  const auto outside = static_cast<double>(std::norm(
      exact::transform(lines.field, between, exact::gaussian(sigma_um), exact::phase(-20), {.x = 3})
          .amplitude()));
  const double power = std::norm(amplitude(TaylorSeries{}, surface, between));
  CHECK(figure("E5", "power between lines, modulus outside", std::abs(power - outside)) <= 1e-13);
  CHECK(figure("E5", "power between lines, modulus inside, relative",
               std::abs(inside / outside - 1)) >= 0.1);
}

TEST_CASE("Erratum E21: Thesis 1.15 with ifft2 divides by the pixels twice",
          "[identity][erratum][E21]") {
  const HeightField flat(brdf::HeightArray::Constant(8, 8, 0.3), Length::um(0.1), Length::um(0.1));
  brdf::RealFourier2d fourier(8, 8);
  std::ranges::fill(fourier.samples(), 1.0);
  fourier.transform();
  const double once = std::abs(fourier.bin(0, 0)) / 64;  // what ifft2 gives
  const double ours = std::abs(amplitude(TaylorSeries{}, separate_lines(flat), {0, 0, -20}));
  CHECK(std::abs(ours - 1) <= 1e-14);  // a few neighbours' rounding
  CHECK(once == 1);
  CHECK(figure("E21", "flat patch of 8 x 8 divided twice; right: 1", once / 64) == 1.0 / 64);
}

TEST_CASE("Erratum E22: Thesis 1.25 has the height once too often", "[identity][erratum][E22]") {
  // (i k w h)^n / n! F{h^n} counts h^n twice: with h = 0.2 um it is J_0 of a depth of h^2.
  const HeightField field = sinusoid();
  const double c = -20, half_um = height_um / 2;
  const double right = std::abs(amplitude(TaylorSeries{}, separate_lines(field), {0, 0, c}));
  CHECK(std::abs(right - static_cast<double>(exact::bessel_j(0, 2))) <= 1e-14);  // e^2 terms
  std::complex<double> printed_thesis_1_25 = 0, coefficient = 1;
  for (int n = 0; n < 60; ++n) {
    printed_thesis_1_25 += coefficient * mean_of_power(n);
    coefficient *= std::complex<double>(0, c * half_um * half_um / (n + 1));
  }
  CHECK(figure("E22", "printed order 0; right: J_0(2) = 0.2239", std::abs(printed_thesis_1_25)) ==
        Approx(0.99).epsilon(0.005));  // J_0(0.2)
}
