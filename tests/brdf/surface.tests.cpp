#include "brdf/surface.h"

#include <catch2/catch.hpp>

#include "tests/support/is_error.h"
#include "tests/support/surfaces.h"

using brdf::GaussianWindow;
using brdf::HeightField;
using brdf::Length;
using brdf::Origin;
using brdf::pi;
using brdf::Surface;
using brdf::SurfaceAxis;
using brdf::SurfaceModel;

namespace {

HeightField flat(Eigen::Index rows, Eigen::Index cols, double dx_um, double dy_um) {
  return sampled(rows, cols, dx_um, dy_um, [](double, double) { return 0.0; });
}

}  // namespace

TEST_CASE("the origin is the middle of the pixel centres, or the first pixel",
          "[surface][oracle]") {
  const HeightField field = flat(3, 4, 0.5, 0.25);
  const GaussianWindow window(Length::um(1));
  const Surface centred{&field, window, SurfaceModel::isolated};
  CHECK(brdf::x_axis(centred).position_um(0) == -0.75);
  CHECK(brdf::x_axis(centred).position_um(3) == 0.75);
  CHECK(brdf::y_axis(centred).position_um(1) == 0);
  CHECK(brdf::y_axis(centred).position_um(2) == 0.25);
  const Surface corner{&field, window, SurfaceModel::isolated, Origin::patch_corner};
  CHECK(brdf::x_axis(corner).position_um(0) == 0);
  CHECK(brdf::y_axis(corner).position_um(2) == 0.5);
}

TEST_CASE("repetitions follow each other by the length of the patch", "[surface][invariant]") {
  const HeightField field = flat(3, 4, 0.5, 0.25);
  const Surface surface{&field, GaussianWindow(Length::um(1)), SurfaceModel::periodic};
  const SurfaceAxis x = brdf::x_axis(surface), y = brdf::y_axis(surface);
  CHECK(x.position_um(0, 1) - x.position_um(3, 0) == 0.5);  // the next pixel of the lattice
  CHECK(x.position_um(2, -1) == x.position_um(2) - field.width_um());
  CHECK(y.position_um(2, 2) == y.position_um(2) + 2 * field.height_um());
}

TEST_CASE("an isolated patch has no repetitions and a periodic one enough for the window",
          "[surface][invariant]") {
  const HeightField field = flat(3, 4, 0.5, 0.25);
  for (const double sigma_um : {0.1, 1.0, 7.0}) {
    CAPTURE(sigma_um);
    const GaussianWindow window(Length::um(sigma_um));
    const Surface isolated{&field, window, SurfaceModel::isolated};
    CHECK(brdf::x_axis(isolated).last_copy == 0);
    CHECK(brdf::y_axis(isolated).first_copy == 0);
    for (const Origin origin : {Origin::patch_centre, Origin::patch_corner}) {
      const Surface periodic{&field, window, SurfaceModel::periodic, origin};
      for (const SurfaceAxis& axis : {brdf::x_axis(periodic), brdf::y_axis(periodic)}) {
        // One pixel beyond either end the window is below the rounding of its sum.
        CHECK(window.spatial(axis.position_um(-1, axis.first_copy)) <= 3e-18);
        CHECK(window.spatial(axis.position_um(axis.count, axis.last_copy)) <= 3e-18);
      }
    }
  }
}

TEST_CASE("a window over more copies than can be counted is refused", "[surface][refusal]") {
  const HeightField field = flat(3, 4, 0.5, 0.25);  // 2 um x 0.75 um
  const auto under = [&](double sigma_um) {
    return Surface{&field, GaussianWindow(Length::um(sigma_um)), SurfaceModel::periodic};
  };
  // 18 sigma / 2 um <= 1e9.
  CHECK(brdf::x_axis(under(1.11e8)).copies() == 999'000'003);
  CHECK_ERROR(brdf::x_axis(under(1.12e8)), brdf::Errc::over_limit, "1.12e+08 um");
  CHECK_ERROR(brdf::x_axis(under(1.12e8)), brdf::Errc::over_limit, "patch 2 um");
  CHECK_ERROR(brdf::y_axis(under(1.11e8)), brdf::Errc::over_limit, "1e9");
  // As many as overflow an int, and as many as no integer holds.
  for (const double sigma_um : {4.8e8, 1e12, 1e300})
    CHECK_ERROR(brdf::x_axis(under(sigma_um)), brdf::Errc::over_limit, "1e9");
}

TEST_CASE("periodic window sums are those of the whole Gaussian", "[surface][oracle]") {
  const HeightField field = flat(5, 8, 0.5, 0.25);
  const Surface surface{&field, GaussianWindow(Length::um(2)), SurfaceModel::periodic};
  // On a lattice finer than sigma the sum is the integral to exp(-2 pi^2 (sigma/dx)^2) < 1e-100.
  const brdf::WindowSums sums = brdf::window_sums(surface, brdf::x_axis(surface));
  CHECK(std::abs(sums.g * 0.5 / (2 * std::sqrt(2 * pi)) - 1) <= 4e-15);  // 90 terms
  CHECK(std::abs(sums.g_squared * 0.5 / (2 * std::sqrt(pi)) - 1) <= 4e-15);
}

TEST_CASE("the coherent area of the periodic model is 4 pi sigma squared", "[surface][oracle]") {
  for (const Origin origin : {Origin::patch_centre, Origin::patch_corner})
    for (const double sigma_um : {1.0, 16.25}) {
      const HeightField field = flat(13, 10, 0.5, 0.25);
      const Surface surface{&field, GaussianWindow(Length::um(sigma_um)), SurfaceModel::periodic,
                            origin};
      // Rounding of sums of up to 1200 terms, six of them multiplied.
      CHECK(std::abs(brdf::coherence_area_um2(surface) / (4 * pi * sigma_um * sigma_um) - 1) <=
            1e-13);
    }
}

TEST_CASE("the coherent area of an isolated patch is that of the cut window", "[surface][oracle]") {
  // Per axis (Int g)^2 / Int g^2 = 2 sigma sqrt(pi) erf(L / (sigma sqrt 8))^2 / erf(L / (2 sigma)).
  // Pixels are a midpoint rule: it errs by dx^2 / 24 (g'(L/2) - g'(-L/2)), which is 3.6e-7 of
  // Int g and 1.3e-7 of Int g^2; for both axes 2 (2 * 3.6e-7 - 1.3e-7) = 1.2e-6.
  const double sigma_um = 16.25, length_um = 65;
  const HeightField field = flat(650, 650, 0.1, 0.1);
  const Surface surface{&field, GaussianWindow(Length::um(sigma_um)), SurfaceModel::isolated};
  const double axis_um = 2 * sigma_um * std::sqrt(pi) *
                         std::pow(std::erf(length_um / (sigma_um * std::sqrt(8.0))), 2) /
                         std::erf(length_um / (2 * sigma_um));
  CHECK(std::abs(brdf::coherence_area_um2(surface) / (axis_um * axis_um) - 1) <= 1.2e-6);
  CHECK(axis_um * axis_um / (4 * pi * sigma_um * sigma_um) <= 0.9);  // the cut is felt
}

TEST_CASE("a patch far smaller than the window is its own coherent area", "[surface][crossover]") {
  const HeightField field = flat(4, 6, 0.5, 0.25);
  const Surface surface{&field, GaussianWindow(Length::um(1e4)), SurfaceModel::isolated};
  // g differs from 1 by (1.5 / 1e4)^2 / 2 = 1e-8, and the area by the variance of that.
  CHECK(std::abs(brdf::coherence_area_um2(surface) / 3.0 - 1) <= 1e-15);
}

TEST_CASE("the coherent area of copies is their area, however many", "[surface][oracle]") {
  const HeightField field = flat(3, 4, 0.5, 0.25);
  for (const int copies : {1, 7, 1'000'000'000}) {
    CAPTURE(copies);
    const Surface surface{&field,
                          GaussianWindow(Length::um(1)),
                          SurfaceModel::replicated,
                          Origin::patch_centre,
                          {copies, copies}};
    CHECK(brdf::x_axis(surface).copies() == copies);
    // Four products of it round.
    CHECK(std::abs(brdf::coherence_area_um2(surface) / (1.5 * copies * copies) - 1) <= 1e-15);
  }
}
