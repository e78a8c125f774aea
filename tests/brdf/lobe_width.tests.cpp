#include "brdf/lobe_width.h"

#include <catch2/catch.hpp>

#include "tests/support/surfaces.h"

using brdf::Length;
using brdf::lobe_half_width_per_um;
using brdf::Surface;
using brdf::SurfaceModel;

namespace {

const brdf::LineDirection along_x{1, 0}, along_y{0, 1}, diagonal{std::sqrt(0.5), std::sqrt(0.5)};

/// 40 x 30 um.
brdf::HeightField flat() {
  return sampled(300, 400, 0.1, 0.1, [](double, double) { return 0.0; });
}

double half_width(const brdf::HeightField& field, double sigma_um, SurfaceModel model,
                  const brdf::LineDirection& line, brdf::Replicas replicas = {}) {
  return lobe_half_width_per_um({&field, brdf::GaussianWindow(Length::um(sigma_um)), model,
                                 brdf::Origin::patch_centre, replicas},
                                line);
}

/// Where (sin x / x)^2 = 1/2.
constexpr double sinc_half = 1.391557378251510;

}  // namespace

TEST_CASE("a Gaussian window's lobe is half as bright at sqrt(ln 2) / sigma", "[lobe]") {
  const auto field = flat();
  const double expected = std::sqrt(std::log(2.0)) / 2;
  for (const auto& line : {along_x, along_y, diagonal}) {
    CHECK(half_width(field, 2, SurfaceModel::periodic, line) == Approx(expected).epsilon(1e-12));
    // Cut at 7.5 sigma, exp(-28) of the peak.
    CHECK(half_width(field, 2, SurfaceModel::isolated, line) == Approx(expected).epsilon(1e-10));
  }
}

TEST_CASE("an even patch's lobe is half as bright at 2.783 / length", "[lobe]") {
  const auto field = flat();
  // 1e-5: pixels beside a continuous length, (pixel / length)^2.
  CHECK(half_width(field, 1e6, SurfaceModel::isolated, along_x) ==
        Approx(2 * sinc_half / 40).epsilon(1e-5));
  CHECK(half_width(field, 1e6, SurfaceModel::isolated, along_y) ==
        Approx(2 * sinc_half / 30).epsilon(2e-5));
  CHECK(half_width(field, 1, SurfaceModel::replicated, along_x, {7, 1}) ==
        Approx(2 * sinc_half / 280).epsilon(1e-6));
  CHECK(half_width(field, 1, SurfaceModel::replicated, along_y, {7, 2}) ==
        Approx(2 * sinc_half / 60).epsilon(1e-5));
}

TEST_CASE("a window cut by the patch makes a wider lobe than either alone", "[lobe]") {
  const auto field = flat();
  const double cut = half_width(field, 10, SurfaceModel::isolated, along_x);
  CHECK(cut > half_width(field, 10, SurfaceModel::periodic, along_x));
  CHECK(cut > half_width(field, 1e6, SurfaceModel::isolated, along_x));
}

TEST_CASE("along a single pixel there is no lobe", "[lobe]") {
  const auto row = sampled(1, 100, 0.1, 0.1, [](double, double) { return 0.0; });
  CHECK(std::isinf(half_width(row, 10, SurfaceModel::isolated, along_y)));
}
