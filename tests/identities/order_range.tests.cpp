// Nmin and Nmax: which orders a direction can show in a band of wavelengths.
#include "brdf/order_range.h"

#include <catch2/catch.hpp>

#include "tests/support/figure.h"
#include "tests/support/surfaces.h"

using brdf::Length;
using brdf::order_range;
using brdf::OrderRange;
using brdf::pi;

namespace {

constexpr double first_um = 0.38, last_um = 0.78;

OrderRange visible(double u, double period_um, double halfwidth_per_um) {
  return order_range(u, Length::um(first_um), Length::um(last_um), Length::um(period_um),
                     halfwidth_per_um);
}

int count(const OrderRange& range) {
  return range.empty() ? 0 : static_cast<int>(range.last - range.first) + 1;
}

/// Both ends d u / lambda_min where u < 0, and 0 left out.
OrderRange printed_implementation_chapter(double u, double period_um) {
  const double a = period_um * u / (u < 0 ? first_um : last_um), b = period_um * u / first_um;
  return {std::max(1.0, std::ceil(std::abs(a))), std::floor(std::abs(b))};
}

}  // namespace

TEST_CASE("Erratum E8: for u < 0 both printed ends are the same", "[identity][erratum][E8]") {
  // u = -1.7, d = 2.5 um: 5.4 to 11.2, the orders 6 to 11.
  CHECK(count(visible(-1.7, 2.5, 0)) == 6);
  CHECK(count(visible(1.7, 2.5, 0)) == 6);
  CHECK(figure("E8", "orders printed for u = -1.7; right: 6",
               count(printed_implementation_chapter(-1.7, 2.5))) == 0);
  // For u > 0 the printed form is right.
  CHECK(count(printed_implementation_chapter(1.7, 2.5)) == 6);
}

TEST_CASE("Erratum E8: without n = 0 the mirror direction is dark", "[identity][erratum][E8]") {
  const double halfwidth = 4 * brdf::GaussianWindow(Length::um(16.25)).sigma_f_per_um();
  CHECK(count(visible(0, 2.5, halfwidth)) == 1);
  CHECK(figure("E8", "orders printed for u = 0; right: 1",
               count(printed_implementation_chapter(0, 2.5))) == 0);
}

TEST_CASE("Erratum E8: lambda_n along y takes v, not u", "[identity][erratum][E8]") {
  const brdf::HeightField flat(brdf::HeightArray::Zero(4, 4), Length::um(1), Length::um(1));
  const brdf::OrderBands bands(
      {&flat, brdf::GaussianWindow(Length::um(16.25)), brdf::SurfaceModel::periodic},
      {.along = Length::um(2), .across = Length::um(2)}, 4);
  // u = 0.5, v = 0.75, d = 2 um: order (2, 3) is 500 nm on both axes.
  const double k = brdf::wavenumber_per_um(Length::nm(500));
  CHECK(bands.contains({0.5 * k, 0.75 * k, -k}));
  const double printed_nm = 1e3 * 2 * 0.5 / 3;  // d u / n with n = 3
  CHECK(figure("E8", "lambda of order 3 along y, printed [nm]; right: 500", printed_nm) ==
        Approx(333.3).epsilon(1e-3));
  const double k_printed = brdf::wavenumber_per_um(Length::nm(printed_nm));
  CHECK_FALSE(bands.contains({0.5 * k_printed, 0.75 * k_printed, -k_printed}));
}

TEST_CASE("Erratum E16: an order's share of a colour is the width of its band",
          "[identity][erratum][E16]") {
  // At fixed u the lobe of order n is as wide in u / lambda as that of any other: in lambda it is
  // lambda_n^2 / |u| of that, 4/9 for order 3 beside order 2. The printed sum weighs them alike.
  const brdf::GaussianWindow window(Length::um(16.25));
  const double period_um = 2.5, u = 0.5;
  const auto band_um = [&](int order) {
    const double centre_um = period_um * u / order, step_um = 1e-5;
    double integral_um = 0;
    for (double lambda_um = 0.8 * centre_um; lambda_um <= 1.2 * centre_um; lambda_um += step_um)
      integral_um += step_um * std::pow(window.spectral(u / lambda_um - order / period_um), 2);
    // sqrt(pi) sigma_f lambda_n^2 / |u|, but for the curvature of 1 / lambda over the lobe.
    CHECK(
        integral_um ==
        Approx(std::sqrt(pi) * window.sigma_f_per_um() * centre_um * centre_um / u).epsilon(1e-3));
    return integral_um;
  };
  CHECK(figure("E16", "band of order 3 over that of order 2; printed: 1",
               band_um(3) / band_um(2)) == Approx(4.0 / 9).epsilon(1e-3));
}
