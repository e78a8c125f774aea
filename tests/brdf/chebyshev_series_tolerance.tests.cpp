// The Chebyshev series where its tolerance is hardest to keep, and at the edges of its domain.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "brdf/chebyshev_series.h"
#include "brdf/direct_sum.h"
#include "tests/support/amplitudes.h"
#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::ChebyshevSeries;
using brdf::Errc;
using brdf::HeightField;
using brdf::Length;
using brdf::Query;
using brdf::Surface;
using brdf::SurfaceModel;

namespace {

constexpr std::uint64_t seed = 503;

enum class Plane { along_x, along_y, general };

Surface surface_of(const HeightField& field, SurfaceModel model, double sigma_um = 1.8) {
  return {&field,
          brdf::GaussianWindow(Length::um(sigma_um)),
          model,
          brdf::Origin::patch_centre,
          {3, 2}};
}

ChebyshevSeries by_series(std::size_t double_table_bytes = std::size_t{64} << 20) {
  return ChebyshevSeries(brdf::portable_kernels,
                         {brdf::SmallRequests::by_series, double_table_bytes});
}

/// The series against the direct sum, eight tolerances per decade from 1e-1 to 1e-12.
void check_every_tolerance(const Surface& surface, const std::vector<Query>& queries,
                           const ChebyshevSeries& method) {
  const Amplitudes reference = amplitudes(brdf::DirectSum{}, surface, queries);
  for (int eighth = 8; eighth <= 96; ++eighth) {
    const double tolerance = std::pow(10.0, -eighth / 8.0);
    const auto plan = method.plan(surface, bounds_of(queries, tolerance));
    REQUIRE(plan.explain().path != brdf::SeriesPath::direct_sum);
    Amplitudes found(queries.size());
    plan.evaluate(queries, found);
    WorstError worst;
    for (std::size_t i = 0; i < queries.size(); ++i) worst.see(std::abs(found[i] - reference[i]));
    CAPTURE(tolerance);
    CHECK(worst.value() <= tolerance);
    // Phases stay below 200 rad: the direct sum's own rounding, some 1e-15, is in the bound too.
    CHECK(worst.value() <= plan.report().error_bound);
    CHECK(plan.report().error_bound <= tolerance);
  }
}

std::vector<Query> random_queries(std::size_t count, Plane plane) {
  Uniform uniform(seed);
  std::vector<Query> queries;
  while (queries.size() < count) {
    Query q =
        query(random_direction(uniform), random_direction(uniform), Length::nm(uniform(380, 780)));
    if (plane == Plane::along_x) q.qy_per_um = 0.3;
    if (plane == Plane::along_y) q.qx_per_um = -1.7;
    queries.push_back(q);
  }
  return queries;
}

/// Directions about the mirror's, closer than the grid of any plan, at both ends of the range of c,
/// within bounds that reach as far as light does.
std::vector<Query> mirror_queries(Plane plane) {
  std::vector<Query> queries = random_queries(4, plane);
  const auto bounds = bounds_of(queries, 1);
  for (int step = -8; step <= 8; ++step)
    for (const double c_per_um : {bounds.lo.c_per_um, bounds.hi.c_per_um})
      queries.push_back({plane == Plane::along_y ? 0 : 0.037 * step,
                         plane == Plane::along_x ? 0 : 0.031 * step, c_per_um});
  for (Query& q : queries) {  // across the plane the mirror's direction as well
    if (plane == Plane::along_x) q.qy_per_um = 0;
    if (plane == Plane::along_y) q.qx_per_um = 0;
  }
  return queries;
}

}  // namespace

TEST_CASE("the tolerance is kept where all pixels add up", "[chebyshev_series][oracle]") {
  // Errors of kernels, window and storage are weighted like the pixels: on a flat patch seen from
  // the mirror's direction nothing cancels. Two levels are the ends of the series' interval.
  struct Step {
    double depth_um;
    std::size_t double_table_bytes;
  };
  const auto step = GENERATE(Step{0, std::size_t{64} << 20}, Step{0, 0}, Step{0.8, 0});
  // From a window much narrower than the patch to one cut at a fifth of sigma.
  const double sigma_um = GENERATE(0.2, 1.8, 9.0);
  const auto model =
      GENERATE(SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated);
  const auto plane = GENERATE(Plane::along_x, Plane::along_y, Plane::general);
  CAPTURE(step.depth_um, step.double_table_bytes, sigma_um, static_cast<int>(model),
          static_cast<int>(plane), seed);
  const HeightField field = sampled(
      18, 41, 0.1, 0.12, [&](double x_um, double) { return x_um > 0.5 ? step.depth_um : 0; });
  check_every_tolerance(surface_of(field, model, sigma_um), mirror_queries(plane),
                        by_series(step.double_table_bytes));
}

TEST_CASE("windows down to two fifths of a pixel keep every tolerance",
          "[chebyshev_series][oracle][crossover]") {
  // The sum over such a window is not its integral, and differs between a centre on a pixel and one
  // between two; what a cut leaves out is one sample, not a tail.
  const double sigma_um = GENERATE(0.04, 0.07, 0.15);
  const auto cols = GENERATE(Eigen::Index{1}, Eigen::Index{4}, Eigen::Index{20}, Eigen::Index{41});
  const auto model = GENERATE(SurfaceModel::isolated, SurfaceModel::periodic);
  const auto plane = GENERATE(Plane::along_x, Plane::general);
  CAPTURE(sigma_um, cols, static_cast<int>(model), static_cast<int>(plane), seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, {4, cols, 0.1, 0.1}, 0, 0.1);
  check_every_tolerance(surface_of(field, model, sigma_um), random_queries(60, plane), by_series());
}

TEST_CASE("patches of one pixel, one row or one column keep every tolerance",
          "[chebyshev_series][oracle][crossover]") {
  struct Shape {
    Eigen::Index rows, cols;
  };
  const auto shape = GENERATE(Shape{1, 1}, Shape{1, 40}, Shape{40, 1}, Shape{2, 2});
  const auto model =
      GENERATE(SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated);
  const auto plane = GENERATE(Plane::along_x, Plane::along_y, Plane::general);
  CAPTURE(shape.rows, shape.cols, static_cast<int>(model), static_cast<int>(plane), seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, {shape.rows, shape.cols, 0.1, 0.12}, -0.1, 0.3);
  check_every_tolerance(surface_of(field, model), random_queries(12, plane), by_series());
}

TEST_CASE("bounds without width in any direction keep every tolerance",
          "[chebyshev_series][oracle][crossover]") {
  const auto model =
      GENERATE(SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, {30, 37, 0.1, 0.12}, -0.1, 0.3);
  std::vector<Query> queries = random_queries(12, Plane::general);
  const Query fixed = queries[0];
  SECTION("one k w: a single wavelength at one angle of incidence and its cone") {
    for (Query& q : queries) q.c_per_um = fixed.c_per_um;
  }
  SECTION("one direction of the scattering vector across the surface") {
    for (Query& q : queries) q = {fixed.qx_per_um, fixed.qy_per_um, q.c_per_um};
  }
  SECTION("one query") {
    queries.resize(1);
  }
  SECTION("one query in the mirror's direction") {
    queries = {{0, 0, -13}};
  }
  SECTION("k w = 0: no relief") {
    for (Query& q : queries) q.c_per_um = 0;
  }
  check_every_tolerance(surface_of(field, model), queries, by_series());
}

TEST_CASE("every face of the bounds belongs to a plan and nothing beyond",
          "[chebyshev_series][crossover]") {
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, {16, 20, 0.1, 0.12}, -0.1, 0.3);
  const Surface surface = surface_of(field, SurfaceModel::isolated);
  const std::vector<Query> queries = random_queries(12, Plane::general);
  constexpr double inf = std::numeric_limits<double>::infinity();
  const auto small_requests =
      GENERATE(brdf::SmallRequests::by_series, brdf::SmallRequests::by_direct_sum);
  const ChebyshevSeries method(brdf::portable_kernels, {small_requests});
  const brdf::QueryBounds bounds = bounds_of(queries, 1e-6);
  const auto plan = method.plan(surface, bounds);
  const auto evaluate = [&](const Query& q) {
    std::complex<double> a;
    plan.evaluate(std::span(&q, 1), std::span(&a, 1));
    return a;
  };
  for (double Query::*member : {&Query::qx_per_um, &Query::qy_per_um, &Query::c_per_um})
    for (const bool upper : {false, true}) {
      Query q = queries[3];
      q.*member = (upper ? bounds.hi : bounds.lo).*member;
      CHECK(std::abs(evaluate(q) - amplitude(brdf::DirectSum{}, surface, q)) <= 1e-6);
      q.*member = std::nextafter(q.*member, upper ? inf : -inf);
      CHECK_ERROR(evaluate(q), Errc::invalid_argument, "outside the bounds");
    }
}

TEST_CASE("a tolerance that is not positive is refused with its value", "[chebyshev_series]") {
  const HeightField field = sampled(4, 4, 0.1, 0.1, [](double x_um, double) { return x_um; });
  const Surface surface = surface_of(field, SurfaceModel::isolated);
  const auto bounds = [](double tolerance) {
    return bounds_of(random_queries(4, Plane::general), tolerance);
  };
  CHECK_ERROR(by_series().plan(surface, bounds(0)), Errc::invalid_argument, "tolerance 0 ");
  CHECK_ERROR(by_series().plan(surface, bounds(-1e-6)), Errc::invalid_argument, "-1e-06 ");
  CHECK_ERROR(by_series().plan(surface, bounds(std::nan(""))), Errc::invalid_argument, "nan ");
  CHECK_ERROR(by_series().bytes(surface, bounds(-1)), Errc::invalid_argument, "must be > 0");
}
