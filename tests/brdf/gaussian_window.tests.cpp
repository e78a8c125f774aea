#include "brdf/gaussian_window.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/is_error.h"

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

TEST_CASE("a sigma that is not positive and finite is refused", "[gaussian_window][invariant]") {
  CHECK_ERROR(GaussianWindow(Length::um(0)), Errc::invalid_argument, "sigma 0 um");
  CHECK_ERROR(GaussianWindow(Length::um(-2.5)), Errc::invalid_argument, "sigma -2.5 um");
  CHECK_ERROR(GaussianWindow(Length::um(1 / 0.0)), Errc::invalid_argument, "sigma inf um");
  CHECK_ERROR(GaussianWindow(Length::um(std::numeric_limits<double>::quiet_NaN())),
              Errc::invalid_argument, "sigma nan um");
}
