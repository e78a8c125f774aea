#include "brdf/spectrum_extrema.h"

#include <catch2/catch.hpp>
#include <limits>

#include "brdf/power_spectra.h"
#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::Errc;
using brdf::Extrema;
using brdf::SpectrumExtrema;
using Complex = std::complex<double>;

namespace {

brdf::StoredPowerSpectra some_spectra() {
  constexpr std::uint64_t seed = 211;
  CAPTURE(seed);
  Uniform uniform(seed);
  return brdf::stored_power_spectra(random_heights(uniform, {12, 15, 0.1, 0.1}, 0, 0.4), 6);
}

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Rounding of the way there (in [0, 1]), of the product and of the sum.
double round_trip_bound(const Extrema& extrema) {
  return 2 * eps * extrema.range() + eps * std::max(std::abs(extrema.min), std::abs(extrema.max));
}

}  // namespace

TEST_CASE("normalised values lie in 0 to 1 and come back within rounding of the range",
          "[spectrum_extrema][invariant]") {
  const brdf::StoredPowerSpectra spectra = some_spectra();
  spectra.visit(6, [](int power, const brdf::HalfSpectrum& spectrum) {
    CAPTURE(power);
    const SpectrumExtrema extrema = brdf::spectrum_extrema(spectrum.half);
    WorstError re, im, lowest, highest;
    for (const Complex& value : spectrum.half) {
      const Complex stored = normalised(value, extrema), back = rescaled(stored, extrema);
      for (const double part : {stored.real(), stored.imag()}) {
        lowest.see(-part);
        highest.see(part);
      }
      re.see(std::abs(back.real() - value.real()));
      im.see(std::abs(back.imag() - value.imag()));
    }
    CHECK(lowest.value() <= 0);
    CHECK(highest.value() <= 1);
    if (power > 0) CHECK(highest.value() == 1);  // the extrema are met
    CHECK(re.value() <= round_trip_bound(extrema.re));
    CHECK(im.value() <= round_trip_bound(extrema.im));
  });
}

TEST_CASE("a spectrum of equal values comes back exactly", "[spectrum_extrema][invariant]") {
  const std::vector<Complex> equal(5, Complex(2.5, -1));
  const SpectrumExtrema extrema = brdf::spectrum_extrema(equal);
  CHECK(normalised(equal[0], extrema) == Complex(0, 0));
  CHECK(rescaled(Complex(0, 0), extrema) == equal[0]);
}

TEST_CASE("values that are not finite, or none, have no extrema", "[spectrum_extrema][invariant]") {
  CHECK_ERROR(brdf::spectrum_extrema({}), Errc::bad_input, "without values");
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const Complex& value : {Complex(bad, 0), Complex(0, bad)})
      for (const std::size_t place : {0, 2}) {
        std::vector<Complex> values(3, Complex(1, 2));
        values[place] = value;
        CHECK_ERROR(brdf::spectrum_extrema(values), Errc::bad_input, "finite");
      }
}
