#include "brdf/gaussian_window.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/is_error.h"
#include "tests/support/worst_error.h"

using brdf::Errc;
using brdf::GaussianWindow;
using brdf::Length;
using brdf::pi;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
const GaussianWindow window(Length::um(16.25));
}  // namespace

TEST_CASE("the window and its transform have peak 1 and the stated widths",
          "[gaussian_window][oracle]") {
  CHECK(window.spatial(0) == 1);
  CHECK(window.spectral(0) == 1);
  CHECK(window.sigma_um() == 16.25);
  // exp(-1/2) at one sigma and exp(-2) at two: the exponent carries a few roundings.
  CHECK(std::abs(window.spatial(16.25) - 0.6065306597126334) <= 2 * eps);
  CHECK(std::abs(window.spatial(-32.5) - 0.1353352832366127) <= 2 * eps);
  CHECK(std::abs(window.spectral(window.sigma_f_per_um()) - 0.6065306597126334) <= 4 * eps);
  CHECK(std::abs(window.spectral(-2 * window.sigma_f_per_um()) - 0.1353352832366127) <= 4 * eps);
  CHECK(std::abs(window.sigma_f_per_um() * 2 * pi * 16.25 - 1) <= 4 * eps);
}

TEST_CASE("the spectral form is the Fourier transform of the spatial form",
          "[gaussian_window][oracle]") {
  // The trapezoid rule errs by the transform one period away: at a step of sigma / 4 and up to
  // 0.06 per um less than 1e-70; cut at 9 sigma 3e-18. What is left is the rounding of 73 terms.
  const double step_um = window.sigma_um() / 4;
  WorstError error;
  for (double f_per_um = -0.06; f_per_um <= 0.06; f_per_um += 0.0025) {
    double transform = 0, area = 0;
    for (int i = -36; i <= 36; ++i) {
      const double x_um = i * step_um;
      transform += window.spatial(x_um) * std::cos(2 * pi * f_per_um * x_um);
      area += window.spatial(x_um);
    }
    error.see(std::abs(transform / area - window.spectral(f_per_um)));
  }
  CHECK(error.value() <= 1e-15);
}

TEST_CASE("a sigma that is not positive and finite is refused", "[gaussian_window][invariant]") {
  CHECK_ERROR(GaussianWindow(Length::um(0)), Errc::invalid_argument, "sigma 0 um");
  CHECK_ERROR(GaussianWindow(Length::um(-2.5)), Errc::invalid_argument, "sigma -2.5 um");
  CHECK_ERROR(GaussianWindow(Length::um(1 / 0.0)), Errc::invalid_argument, "sigma inf um");
  CHECK_ERROR(GaussianWindow(Length::um(std::numeric_limits<double>::quiet_NaN())),
              Errc::invalid_argument, "sigma nan um");
}

TEST_CASE("Thesis 1.35 multiplies the peak-1 weight by pi", "[gaussian_window][erratum][E6]") {
  // phi = pi exp(...) makes the flat patch reflect pi^2 in power; the weight's peak is 1.
  const double printed_peak = pi * std::exp(0.0);
  CHECK(printed_peak - window.spectral(0) >= 2);
  CHECK(window.spectral(0) == 1);
}
