// What any amplitude must do, whatever the surface: by the direct sum, and by the series against
// it.
#include <catch2/catch.hpp>

#include "brdf/chebyshev_series.h"
#include "brdf/direct_sum.h"
#include "evaluation/diffraction.h"
#include "tests/support/generated_scene.h"
#include "tests/support/property.h"

namespace {

using brdf::DirectSum;
using brdf::HeightField;
using brdf::Length;
using brdf::Query;
using brdf::Surface;
using brdf::SurfaceModel;
using Complex = std::complex<double>;

Surface lit(const HeightField& field, double sigma_um) {
  return {&field, brdf::GaussianWindow(Length::um(sigma_um)), SurfaceModel::isolated};
}

/// One patch evenly lit.
Surface evenly_lit(const HeightField& field) {
  return {&field, brdf::GaussianWindow(Length::um(1)), SurfaceModel::replicated};
}

Complex direct(const Surface& surface, const Query& query) {
  return amplitude(DirectSum{}, surface, query);
}

/// Each phase is rounded by half an epsilon of itself on either side, its sine and the sum once
/// more; sixteen leave room for the sum of 36 pixels.
double rounding(const GeneratedScene& scene) {
  return 16 * std::numeric_limits<double>::epsilon() * scene.largest_phase_rad();
}

void require_equal(Complex a, Complex b, double tolerance) {
  const double difference = std::abs(a - b);
  RC_ASSERT(difference <= tolerance);
}

}  // namespace

TEST_CASE("property: an evenly lit patch moved around its edge by a pixel turns each order's phase",
          "[property][invariant]") {
  check_property("translation", [] {
    const GeneratedScene scene = any_scene();
    const Eigen::Index cols = scene.heights_um.cols();
    brdf::HeightArray moved(scene.heights_um.rows(), cols);
    for (Eigen::Index col = 0; col < cols; ++col)
      moved.col((col + 1) % cols) = scene.heights_um.col(col);
    const HeightField before = scene.field(),
                      after(moved, Length::um(scene.dx_um), Length::um(scene.dy_um));
    Query query = scene.query();
    const auto order = static_cast<double>(*rc::gen::inRange(-20, 21));
    query.qx_per_um = 2 * brdf::pi * order / before.width_um();
    const double turn_rad = query.qx_per_um * scene.dx_um;
    const double phases_rad = scene.largest_phase_rad() + 40 * brdf::pi;
    require_equal(direct(evenly_lit(after), query),
                  direct(evenly_lit(before), query) * std::polar(1.0, turn_rad),
                  16 * std::numeric_limits<double>::epsilon() * phases_rad);
  });
}

TEST_CASE("property: a constant height turns the phase by c times it", "[property][invariant]") {
  check_property("constant height", [] {
    const GeneratedScene scene = any_scene();
    const double up_um = *number_between(-1, 1);
    GeneratedScene lifted = scene;
    lifted.heights_um += up_um;
    const HeightField low = scene.field(), high = lifted.field();
    const Query query = scene.query();
    require_equal(direct(lit(high, scene.sigma_um), query),
                  direct(lit(low, scene.sigma_um), query) * std::polar(1.0, query.c_per_um * up_um),
                  rounding(scene) + rounding(lifted));
  });
}

TEST_CASE("property: a mirrored patch answers to the mirrored query", "[property][invariant]") {
  check_property("mirror", [] {
    const GeneratedScene scene = any_scene();
    GeneratedScene mirrored = scene;
    mirrored.heights_um = scene.heights_um.rowwise().reverse().eval();
    const HeightField field = scene.field(), mirror = mirrored.field();
    Query query = scene.query();
    const Complex before = direct(lit(field, scene.sigma_um), query);
    query.qx_per_um = -query.qx_per_um;
    require_equal(direct(lit(mirror, scene.sigma_um), query), before, rounding(scene));
  });
}

TEST_CASE("property: a patch turned by 90 degrees answers to the turned query",
          "[property][invariant]") {
  check_property("rotation", [] {
    const GeneratedScene scene = any_scene();
    // The pixel at (x, y) goes to (-y, x).
    const brdf::HeightArray turned = scene.heights_um.transpose().rowwise().reverse();
    const HeightField field = scene.field(),
                      after(turned, Length::um(scene.dy_um), Length::um(scene.dx_um));
    const Query query = scene.query();
    require_equal(
        direct(lit(after, scene.sigma_um), {-query.qy_per_um, query.qx_per_um, query.c_per_um}),
        direct(lit(field, scene.sigma_um), query), rounding(scene));
  });
}

TEST_CASE("property: wavelength, heights, pixels and window scaled together change nothing",
          "[property][invariant]") {
  check_property("scaling", [] {
    const GeneratedScene scene = any_scene();
    const double scale = *number_between(0.1, 10);
    GeneratedScene scaled = scene;
    scaled.heights_um *= scale;
    for (double* length : {&scaled.dx_um, &scaled.dy_um, &scaled.sigma_um, &scaled.lambda_um})
      *length *= scale;
    const HeightField field = scene.field(), other = scaled.field();
    require_equal(direct(lit(other, scaled.sigma_um), scaled.query()),
                  direct(lit(field, scene.sigma_um), scene.query()), rounding(scene));
  });
}

TEST_CASE("property: the BRDF is the same with light and viewer exchanged",
          "[property][invariant]") {
  check_property("reciprocity", [] {
    const GeneratedScene scene = any_scene();
    const HeightField field = scene.field();
    const Surface surface = lit(field, scene.sigma_um);
    const std::vector<Query> queries{scene.query()};
    const auto plan =
        evaluation::method_named("direct").plan(surface, brdf::bounds_of(queries, 1e-9), {});
    const evaluation::Diffraction brdf_of(
        *plan, {brdf::Quantity::brdf, brdf::coherence_area_um2(surface)});
    const Length lambda = Length::um(scene.lambda_um);
    const evaluation::Sample there[] = {{{scene.omega_i, scene.omega_r}, lambda}},
                             back[] = {{{scene.omega_r, scene.omega_i}, lambda}};
    double forward[1], reverse[1];
    brdf_of.evaluate(there, forward);
    brdf_of.evaluate(back, reverse);
    // The same sums in another order: a few roundings of the gain and of the phases.
    const double gain = evaluation::gain({brdf::Quantity::brdf, brdf::coherence_area_um2(surface)},
                                         scene.omega_i, scene.omega_r, lambda);
    RC_ASSERT(std::abs(forward[0] - reverse[0]) <= gain * 2 * rounding(scene));
  });
}

TEST_CASE("property: the Chebyshev series is the direct sum within its tolerance",
          "[property][crossover]") {
  check_property("series", [] {
    const GeneratedScene scene = any_scene();
    const double tolerance = std::pow(10, *number_between(-13, -2));
    const HeightField field = scene.field();
    const Surface surface = lit(field, scene.sigma_um);
    const std::vector<Query> queries{scene.query()};
    require_equal(amplitudes(brdf::ChebyshevSeries{}, surface, queries, tolerance).front(),
                  direct(surface, queries.front()), tolerance + rounding(scene));
  });
}
