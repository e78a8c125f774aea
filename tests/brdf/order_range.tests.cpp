#include "brdf/order_range.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"

using brdf::Angle;
using brdf::Errc;
using brdf::GaussianWindow;
using brdf::Length;
using brdf::OrderBands;
using brdf::OrderRange;
using brdf::pi;
using brdf::Query;
using brdf::Replicas;
using brdf::Surface;
using brdf::SurfaceModel;

namespace {

const brdf::HeightField flat = one_period({brdf::Profile::flat, Length::um(40)}, 80);

Surface windowed(double sigma_um) {
  return {&flat, GaussianWindow(Length::um(sigma_um)), SurfaceModel::isolated};
}

/// The query at (fx, fy) cycles/um.
Query at(double fx_per_um, double fy_per_um) {
  return {2 * pi * fx_per_um, 2 * pi * fy_per_um, -20};
}

}  // namespace

TEST_CASE("Nmin and Nmax hold just the orders whose lobe meets the band of wavelengths",
          "[order_range][identity][oracle]") {
  Uniform uniform(1);
  for (int trial = 0; trial < 20000; ++trial) {
    const double u = uniform(-2, 2), d_um = uniform(0.3, 5), b_per_um = uniform(0, 0.2);
    const double lambda_min_um = uniform(0.3, 0.6), lambda_max_um = lambda_min_um + uniform(0, 0.5);
    const OrderRange range = brdf::order_range(
        u, Length::um(lambda_min_um), Length::um(lambda_max_um), Length::um(d_um), b_per_um);
    // By definition: some wavelength of the band puts u / lambda within b of the order n / d.
    for (int n = 0; n <= 60; ++n) {
      const double nearest =
          std::clamp(n / d_um, std::abs(u) / lambda_max_um, std::abs(u) / lambda_min_um);
      const double miss_per_um = std::abs(nearest - n / d_um) - b_per_um;
      if (std::abs(miss_per_um) < 1e-12) continue;  // on the edge, where rounding decides
      const bool held = n >= range.first && n <= range.last;
      if (held != (miss_per_um < 0)) FAIL("order " << n << " at u " << u << ", d " << d_um);
    }
  }
}

TEST_CASE("order 0 needs all wavelengths near the mirror direction",
          "[order_range][identity][oracle]") {
  const auto range = [](double u, double b_per_um) {
    return brdf::order_range(u, Length::nm(380), Length::nm(780), Length::um(2.5), b_per_um);
  };
  for (const double sign : {-1.0, 1.0}) {
    CHECK(range(sign * 0.0038, 0.0101).first == 0);
    CHECK(range(sign * 0.0038, 0.0101).last == 0);
    // 0.0038 / 0.78 = 0.00487: beyond that halfwidth no wavelength is left, and no order 1 yet.
    CHECK(range(sign * 0.0038, 0.0048).empty());
  }
}

TEST_CASE("the bands of a grating lie around its orders along its own vector",
          "[order_range][invariant]") {
  const double sigma_um = 10, sigma_f = 1 / (2 * pi * sigma_um), radius = 4, d_um = 1.6;
  for (const double azimuth_deg : {0.0, 90.0, 33.0}) {
    const OrderBands bands(windowed(sigma_um), {Length::um(d_um), {}, Angle::deg(azimuth_deg)},
                           radius);
    const double c = std::cos(azimuth_deg * pi / 180), s = std::sin(azimuth_deg * pi / 180);
    const auto query = [&](double along, double across) {
      return at(c * along - s * across, s * along + c * across);
    };
    CHECK(bands.along_per_um() == Approx(radius * sigma_f).epsilon(1e-14));
    for (const int m : {-3, -1, 0, 2}) {
      CHECK(bands.contains(query(m / d_um + 0.99 * radius * sigma_f, 0)));
      CHECK_FALSE(bands.contains(query(m / d_um + 1.01 * radius * sigma_f, 0)));
      CHECK(bands.contains(query(m / d_um, -0.99 * radius * sigma_f)));
      CHECK_FALSE(bands.contains(query(m / d_um, -1.01 * radius * sigma_f)));
    }
  }
}

TEST_CASE("a lattice has orders along both axes", "[order_range][invariant]") {
  const OrderBands bands(windowed(10), {Length::um(1.6), Length::um(0.9)}, 4);
  CHECK(bands.contains(at(2 / 1.6, -3 / 0.9)));
  CHECK_FALSE(bands.contains(at(2 / 1.6, 2.5 / 0.9)));
  CHECK_FALSE(bands.contains(at(1.5 / 1.6, 2 / 0.9)));
}

TEST_CASE("without a window the bands reach to the zeros of the replicas' lobes",
          "[order_range][oracle]") {
  Surface surface = windowed(10);
  surface.model = SurfaceModel::replicated;
  surface.replicas = {5, 3};
  // 80 pixels of 0.5 um times 5, and one row of 1 um times 3.
  const OrderBands bands(surface, {Length::um(2), Length::um(1)}, 2);
  CHECK(bands.along_per_um() == Approx(2 / 200.0).epsilon(1e-14));
  CHECK(bands.across_per_um() == Approx(2 / 3.0).epsilon(1e-14));
  const OrderBands turned(surface, {Length::um(2), Length::um(1), Angle::deg(90)}, 2);
  CHECK(turned.along_per_um() == Approx(2 / 3.0).epsilon(1e-14));
}

TEST_CASE("bands that mean nothing are refused", "[order_range]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double period_um : {0.0, -1.0, nan})
    CHECK_ERROR(OrderBands(windowed(10), {Length::um(period_um)}, 4), Errc::invalid_argument,
                "period");
  CHECK_ERROR(OrderBands(windowed(10), {Length::um(1), Length::um(nan)}, 4), Errc::invalid_argument,
              "period");
  for (const double radius : {0.0, -4.0, nan})
    CHECK_ERROR(OrderBands(windowed(10), {Length::um(1)}, radius), Errc::invalid_argument,
                "band radius");
  CHECK_ERROR(brdf::order_range(1, Length::nm(500), Length::nm(400), Length::um(1), 0),
              Errc::invalid_argument, "wavelengths");
  CHECK_ERROR(brdf::order_range(1, Length::nm(400), Length::nm(500), {}, 0), Errc::invalid_argument,
              "period");
  CHECK_ERROR(brdf::order_range(nan, Length::nm(400), Length::nm(500), Length::um(1), 0),
              Errc::invalid_argument, "finite");
}
