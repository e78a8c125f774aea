#include "brdf/band_quadratures.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/is_error.h"
#include "tests/support/worst_error.h"

namespace {

using brdf::BandQuadratures;
using brdf::Length;
using brdf::SpectralBand;
using brdf::SpectralNode;
using brdf::Xyz;

double t_of(Length wavelength) {
  const SpectralBand band;
  return (2 * wavenumber_per_um(wavelength) - band.k_lo_per_um() - band.k_hi_per_um()) /
         (band.k_hi_per_um() - band.k_lo_per_um());
}

/// The colour of 1 + cos(x t + phase).
template <class Nodes>
Xyz colour(const Nodes& nodes, double x, double phase) {
  Xyz sum;
  for (const SpectralNode& node : nodes)
    sum = sum + (1 + std::cos(x * t_of(node.wavelength) + phase)) * node.weight;
  return sum;
}

/// Steps of 0.01 nm: 500 in each straight piece of the tables.
std::vector<SpectralNode> fine_steps() {
  std::vector<Length> wavelengths;
  for (int i = 0; i <= 40000; ++i) wavelengths.push_back(Length::nm(380 + 0.01 * i));
  const auto weights = brdf::colour_weights(wavelengths);
  std::vector<SpectralNode> nodes;
  for (std::size_t i = 0; i < weights.size(); ++i) nodes.push_back({wavelengths[i], weights[i]});
  return nodes;
}

double difference(const Xyz& a, const Xyz& b) {
  WorstError worst;
  for (const double error : {a.x - b.x, a.y - b.y, a.z - b.z}) worst.see(std::abs(error));
  return worst.value();
}

}  // namespace

TEST_CASE("quadratures integrate oscillating spectra within the tolerance",
          "[band_quadratures][oracle]") {
  const auto reference = fine_steps();
  const BandQuadratures quadratures({}, BandQuadratures::polynomial_count(400, 1e-5));
  for (const double x : {0.0, 3.0, 20.0, 100.0, 400.0})
    for (const double tolerance : {1e-2, 1e-3, 1e-5}) {
      const int polynomial = BandQuadratures::polynomial_count(x, tolerance);
      const int even = quadratures.even_count(x, tolerance);
      CAPTURE(x, tolerance, polynomial, even);
      for (const double phase : {0.0, 1.0, 2.0}) {
        const Xyz exact = colour(reference, x, phase);
        // 2e-6: what 0.1 nm of the moments leave out where the straight pieces meet.
        CHECK(difference(colour(quadratures.polynomial(polynomial), x, phase), exact) <=
              tolerance + 2e-6);
        if (even == 0) continue;
        CHECK(difference(colour(quadratures.even_steps(even), x, phase), exact) <= tolerance);
      }
    }
  // Where the spectrum oscillates fast, even steps are fewer; where it does not, the polynomial.
  CHECK(quadratures.even_count(400, 1e-3) < BandQuadratures::polynomial_count(400, 1e-3) / 2);
  CHECK(BandQuadratures::polynomial_count(1, 1e-3) < 12);
}

TEST_CASE("the white of any number of nodes is D65", "[band_quadratures][oracle]") {
  // Reference: plain sums at 1 nm, 380 to 780 nm (tests/oracles/cie_whites.csv).
  const BandQuadratures quadratures({}, 40);
  for (const int count : {8, 20, 40}) {
    Xyz white;
    for (const SpectralNode& node : quadratures.polynomial(count)) white = white + node.weight;
    const auto [x, y] = chromaticity(white);
    // The table prints six digits; the trapezoid of its 1 nm differs from ours by less than 3e-5.
    CHECK(std::abs(x - 0.312739) <= 3e-5);
    CHECK(std::abs(y - 0.329052) <= 3e-5);
    CHECK(std::abs(white.y - 1) <= 1e-12);  // rounding of some thousand weights
  }
}

TEST_CASE("the white of even steps is D65 within their tolerance", "[band_quadratures][oracle]") {
  const BandQuadratures quadratures({}, 1);
  for (const double tolerance : {1e-2, 1e-3}) {
    const int count = quadratures.even_count(0, tolerance);
    REQUIRE(count > 0);
    Xyz white;
    for (const SpectralNode& node : quadratures.even_steps(count)) white = white + node.weight;
    // cie_whites.csv, 380 to 780 nm at 1 nm: X, Y and Z over 100. Straight lines over the 5 nm of
    // the tables change Z by 2e-4.
    CHECK(difference(white, {0.95042282, 1, 1.08861009}) <= tolerance + 3e-4);
  }
}

TEST_CASE("even steps lie in the middle of equal parts of the band in k", "[band_quadratures]") {
  const auto nodes = BandQuadratures({}, 1).even_steps(4);
  REQUIRE(nodes.size() == 4);
  const double lo_per_nm = 1 / 780.0, hi_per_nm = 1 / 380.0;
  for (int j = 0; j < 4; ++j)
    CHECK(nodes[static_cast<std::size_t>(j)].wavelength.nm() ==
          Approx(1 / (lo_per_nm + (hi_per_nm - lo_per_nm) * (j + 0.5) / 4)).epsilon(1e-13));
}

TEST_CASE("the weights of one node are the whole light", "[band_quadratures][oracle]") {
  // In the middle of the band in k, 2 / (1 / 380 + 1 / 780) nm.
  const auto nodes = BandQuadratures({}, 1).polynomial(1);
  REQUIRE(nodes.size() == 1);
  CHECK(nodes[0].wavelength.nm() == Approx(2 / (1 / 380.0 + 1 / 780.0)).epsilon(1e-14));
  // As above.
  CHECK(difference(nodes[0].weight, {0.95042282, 1, 1.08861009}) <= 3e-4);
}

TEST_CASE("a band without length, or of no light, is refused", "[band_quadratures]") {
  const auto band = [](double first_nm, double last_nm) {
    return BandQuadratures({Length::nm(first_nm), Length::nm(last_nm)}, 4);
  };
  CHECK_ERROR(band(500, 500), brdf::Errc::invalid_argument, "500 to 500");
  CHECK_ERROR(band(700, 400), brdf::Errc::invalid_argument, "ascend");
  CHECK_ERROR(band(0, 400), brdf::Errc::invalid_argument, "> 0");
  CHECK_ERROR(band(1000, 1200), brdf::Errc::invalid_argument, "830");
}
