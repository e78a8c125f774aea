// Planes of incidence at any azimuth, against the direct sum.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "brdf/chebyshev_series.h"
#include "brdf/direct_sum.h"
#include "brdf/directions.h"
#include "brdf/height_field.h"
#include "tests/support/amplitudes.h"

using namespace brdf;

namespace {

constexpr unsigned seed = 23;

HeightField relief(double height_um, Eigen::Index rows = 48, Eigen::Index cols = 63) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  HeightArray heights_um(rows, cols);
  for (Eigen::Index row = 0; row < rows; ++row)
    for (Eigen::Index col = 0; col < cols; ++col)
      heights_um(row, col) = height_um * (0.8 * static_cast<double>((row + 2 * col) % 23) / 22 +
                                          0.2 * uniform(random));
  return HeightField(std::move(heights_um), Length::um(0.1), Length::um(0.12));
}

/// Light from 75 deg, seen from -80 to 10 deg in the plane of that azimuth.
std::vector<Query> plane(Angle azimuth, std::size_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Query> queries;
  const Direction omega_i = direction(Angle::deg(75), azimuth);
  for (std::size_t i = 0; i < count; ++i) {
    const Direction omega_r = direction(Angle::deg(-80 + 90 * uniform(random)), azimuth);
    const Eigen::Vector3d q = wavenumber_per_um(Length::nm(380 + 400 * uniform(random))) *
                              scattering_vector(omega_i, omega_r);
    queries.push_back({q.x(), q.y(), q.z()});
  }
  return queries;
}

QueryBounds bounds_on_line(std::span<const Query> queries, Angle azimuth, double tolerance) {
  QueryBounds bounds = many(queries, tolerance);
  const Direction along = direction(Angle::deg(45), azimuth) / std::sin(pi / 4);
  bounds.line = LineDirection{along.x(), along.y()};
  return bounds;
}

Surface surface_of(const HeightField& field, SurfaceModel model) {
  return {&field, GaussianWindow(Length::um(1.8)), model, Origin::patch_centre, {3, 2}};
}

}  // namespace

TEST_CASE("an oblique plane keeps every tolerance from 1e-1 to 1e-12, eight per decade",
          "[chebyshev_series][oracle][long]") {
  const auto model = GENERATE(SurfaceModel::isolated, SurfaceModel::replicated);
  const auto origin = GENERATE(Origin::patch_centre, Origin::patch_corner);
  const double azimuth_deg = GENERATE(17.0, 45.0, 89.9, 133.0, -61.0, 200.0);
  const double height_um = GENERATE(0.0, 0.15, 3.0);
  CAPTURE(static_cast<int>(model), static_cast<int>(origin), azimuth_deg, height_um, seed);
  const Angle azimuth = Angle::deg(azimuth_deg);
  const HeightField field = relief(height_um);
  Surface surface = surface_of(field, model);
  surface.origin = origin;
  const std::vector<Query> queries = plane(azimuth, 24);
  const Amplitudes reference =
      amplitudes_of(DirectSum{}.plan(surface, bounds_of(queries, 1)), queries);
  for (int eighth = 8; eighth <= 96; ++eighth) {
    const double tolerance = std::pow(10.0, -eighth / 8.0);
    const auto plan = ChebyshevSeries{}.plan(surface, bounds_on_line(queries, azimuth, tolerance));
    CAPTURE(tolerance, plan.report().error_bound);
    REQUIRE(plan.explain().path == SeriesPath::in_plane);
    REQUIRE(plan.explain().projected);
    const double error = largest_difference(amplitudes_of(plan, queries), reference);
    CHECK(error <= tolerance);
    CHECK(error <= plan.report().error_bound);
    CHECK(plan.report().error_bound <= tolerance);
  }
}

TEST_CASE("a line along an axis takes the plane of that axis", "[chebyshev_series][crossover]") {
  const double azimuth_deg = GENERATE(0.0, 90.0, 180.0, 270.0);
  const Angle azimuth = Angle::deg(azimuth_deg);
  const HeightField field = relief(0.3);
  const Surface surface = surface_of(field, SurfaceModel::isolated);
  const std::vector<Query> queries = plane(azimuth, 24);
  QueryBounds bounds = bounds_on_line(queries, azimuth, 1e-6);
  const auto with_line = ChebyshevSeries{}.plan(surface, bounds);
  CHECK_FALSE(with_line.explain().projected);
  bounds.line.reset();
  CHECK(amplitudes_of(with_line, queries) ==
        amplitudes_of(ChebyshevSeries{}.plan(surface, bounds), queries));
}

TEST_CASE("a periodic surface takes the general way along an oblique line",
          "[chebyshev_series][oracle]") {
  const Angle azimuth = Angle::deg(30);
  const HeightField field = relief(0.3);
  const Surface surface = surface_of(field, SurfaceModel::periodic);
  const std::vector<Query> queries = plane(azimuth, 24);
  const auto plan = ChebyshevSeries{}.plan(surface, bounds_on_line(queries, azimuth, 1e-6));
  CHECK(plan.explain().path == SeriesPath::general);
  CHECK(largest_difference(
            amplitudes_of(plan, queries),
            amplitudes_of(DirectSum{}.plan(surface, bounds_of(queries, 1)), queries)) <= 1e-6);
}

TEST_CASE("an oblique plan has the same bits whoever runs its tasks, and in any order",
          "[chebyshev_series][invariant]") {
  const Angle azimuth = Angle::deg(30);
  const HeightField field = relief(0.3, 77, 53);
  const Surface surface = surface_of(field, SurfaceModel::isolated);
  const std::vector<Query> queries = plane(azimuth, 101);
  const QueryBounds bounds = bounds_on_line(queries, azimuth, 1e-9);
  const auto backwards = [](std::size_t count, const std::function<void(std::size_t)>& task) {
    for (std::size_t i = count; i > 0; --i) task(i - 1);
  };
  const auto plan = ChebyshevSeries{}.plan(surface, bounds);
  const Amplitudes whole = amplitudes_of(plan, queries);
  CHECK(amplitudes_of(
            ChebyshevSeries(portable_kernels, {.executor = backwards}).plan(surface, bounds),
            queries) == whole);
  for (std::size_t first = 0; first < queries.size(); first += 9)
    CHECK(amplitudes_of(plan, std::span(queries).subspan(first, 1)).front() == whole[first]);
}

TEST_CASE("queries off the line and directions that are no unit vector are refused",
          "[chebyshev_series]") {
  const Angle azimuth = Angle::deg(30);
  const HeightField field = relief(0.3);
  const Surface surface = surface_of(field, SurfaceModel::isolated);
  const std::vector<Query> queries = plane(azimuth, 24);
  QueryBounds bounds = bounds_on_line(queries, azimuth, 1e-6);
  const auto plan = ChebyshevSeries{}.plan(surface, bounds);
  Query off = queries[0];
  off.qx_per_um *= 1 - 1e-9;
  Amplitudes one(1);
  CHECK_THROWS_AS(plan.evaluate(std::span(&off, 1), one), Error);
  bounds.line = LineDirection{1, 1};
  CHECK_THROWS_AS(ChebyshevSeries{}.plan(surface, bounds), Error);
}
