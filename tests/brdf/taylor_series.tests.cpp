#include "brdf/taylor_series.h"

#include <catch2/catch.hpp>

#include "brdf/direct_sum.h"
#include "tests/support/amplitudes.h"
#include "tests/support/is_error.h"
#include "tests/support/oracle_table.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::DirectSum;
using brdf::Errc;
using brdf::GaussianWindow;
using brdf::HeightField;
using brdf::Length;
using brdf::Origin;
using brdf::Query;
using brdf::QueryBounds;
using brdf::Surface;
using brdf::SurfaceModel;
using brdf::TaylorSeries;

namespace {

constexpr Grid grid{40, 48, 0.12, 0.15};  // 4.8 um x 7.2 um, pixels that are not square

Surface under_quarter_window(const HeightField& field, Origin origin = Origin::patch_centre) {
  const double sigma_um = std::min(field.width_um(), field.height_um()) / 4;
  return {&field, GaussianWindow(Length::um(sigma_um)), SurfaceModel::periodic, origin};
}

HeightField blazed() {
  return brdf::synthetic_grating({.period = Length::um(1.1), .height = Length::um(0.3)}, grid.rows,
                                 grid.cols, Length::um(grid.dx_um), Length::um(grid.dy_um));
}

std::vector<Query> random_queries(Uniform& uniform, int count, bool in_plane) {
  std::vector<Query> queries;
  for (int i = 0; i < count; ++i) {
    const auto pick = [&] {
      return in_plane ? brdf::direction(brdf::Angle::deg(uniform(-85, 85)), {})
                      : random_direction(uniform, 85);
    };
    const brdf::Direction light = pick(), viewer = pick();
    queries.push_back(query(light, viewer, Length::nm(uniform(380, 780))));
  }
  return queries;
}

struct Comparison {
  double worst, bound;
};

/// Worst error against the direct sum, and the error bounds of both.
Comparison compare(const TaylorSeries& method, const Surface& surface,
                   const std::vector<Query>& queries, double tolerance) {
  const QueryBounds bounds = brdf::bounds_of(queries, tolerance);
  const Amplitudes taylor = amplitudes(method, surface, queries, tolerance);
  const Amplitudes direct = amplitudes(DirectSum{}, surface, queries);
  WorstError worst;
  for (std::size_t i = 0; i < queries.size(); ++i) worst.see(std::abs(taylor[i] - direct[i]));
  return {worst.value(), method.plan(surface, bounds).report().error_bound +
                             DirectSum{}.plan(surface, bounds).report().error_bound};
}

}  // namespace

TEST_CASE("the series is the direct sum to what its radius leaves out, never above its bound",
          "[taylor_series][oracle]") {
  constexpr std::uint64_t seed = 81;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField blaze = blazed();
  const HeightField rough = random_heights(uniform, grid, -0.1, 0.5);
  for (const HeightField* field : {&blaze, &rough})
    for (const Origin origin : {Origin::patch_centre, Origin::patch_corner})
      for (const bool in_plane : {true, false}) {
        const Surface surface = under_quarter_window(*field, origin);
        const std::vector<Query> queries = random_queries(uniform, 40, in_plane);
        // The window's weight at the edge: 3.4e-4 at 4 sigma_f, 1.5e-8 at 6, 1.3e-14 at 8, times
        // a few neighbours. 60 terms leave (9.9 rad)^60 / 60! = 7e-23; their rounding is 2e-12
        // at most and typically a hundred times less.
        for (const auto& [radius, most] : {std::pair{4.0, 1e-3}, {6.0, 1e-7}, {8.0, 1e-12}}) {
          CAPTURE(in_plane, radius);
          const Comparison result =
              compare(TaylorSeries({.terms = 60, .radius_sigma_f = radius}), surface, queries, 0);
          CHECK(result.worst <= most);
          CHECK(result.worst <= result.bound);
        }
      }
}

TEST_CASE("the series keeps the tolerance it was asked for", "[taylor_series][oracle]") {
  constexpr std::uint64_t seed = 82;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, grid, 0.2, 0.5);
  const Surface surface = under_quarter_window(field);
  const std::vector<Query> queries = random_queries(uniform, 40, false);
  for (const double tolerance : {1e-2, 1e-4, 1e-8, 1e-11}) {
    CAPTURE(tolerance);
    const Comparison result = compare(TaylorSeries{}, surface, queries, tolerance);
    CHECK(result.worst <= tolerance);
    CHECK(result.bound <= tolerance);
    // Half of the tolerance for each part, no more work than that asks for.
    CHECK(result.worst >= tolerance * 1e-4);
  }
}

TEST_CASE("orders of a sinusoid have the powers of the table by the series",
          "[taylor_series][oracle]") {
  WorstError error;
  for (const OracleRow& row : oracle_table("sinusoid_orders.csv")) {
    const HeightField field = one_period({.profile = brdf::Profile::sinusoid,
                                          .period = Length::um(number(row[3])),
                                          .height = Length::um(number(row[1]))},
                                         64);
    const Query q = order_query(static_cast<int>(number(row[6])), number(row[3]), number(row[8]));
    error.see(
        std::abs(std::norm(amplitude(TaylorSeries{}, separate_lines(field), q)) - number(row[9])));
  }
  CHECK(error.value() <= 1e-14);  // x = c h / 2 up to 3.1: terms of up to 5, rounded
}

TEST_CASE("a tolerance that is not positive is refused", "[taylor_series][invariant]") {
  const HeightField field =
      sampled(1, 8, 0.1, 0.1, [](double x, double) { return 0.05 * std::cos(x); });
  const Surface surface{&field, GaussianWindow(Length::um(5)), SurfaceModel::periodic};
  for (const double tolerance : {0.0, -1e-6, std::numeric_limits<double>::quiet_NaN()})
    CHECK_ERROR(TaylorSeries{}.plan(surface, QueryBounds{{0, 0, -20}, {0, 0, -20}, 1, tolerance}),
                Errc::invalid_argument, "tolerance");
}

TEST_CASE("the bound keeps the tolerance on a patch many windows wide",
          "[taylor_series][regression]") {
  // 512 um under 5 um: sixteen lines within sigma_f, so many neighbours stand at the edge.
  const HeightField field =
      sampled(1, 2048, 0.25, 1, [](double x, double) { return 0.05 * std::cos(x); });
  const Surface surface{&field, GaussianWindow(Length::um(5)), SurfaceModel::periodic};
  const QueryBounds bounds{{-6, 0, -20}, {6, 0, -20}, 100, 1e-6};
  CHECK(TaylorSeries{}.plan(surface, bounds).report().error_bound <= 1e-6);
}

TEST_CASE("errors stay below the bound while the rounding grows with e^x",
          "[taylor_series][crossover]") {
  // Two levels: every power of the scaled height is +-1, which leaves the cancellation whole.
  const HeightField field = brdf::synthetic_grating(
      {.profile = brdf::Profile::lamellar, .period = Length::um(1), .height = Length::um(1)}, 8, 20,
      Length::um(0.1), Length::um(0.1));
  const Surface surface = under_quarter_window(field);
  double smallest = 1, largest = 0;
  for (const double x : {1.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0}) {
    CAPTURE(x);
    const std::vector<Query> queries = {{0, 0, -2 * x}, {1, 0.5, -1.99 * x}};  // half range 0.5 um
    const Comparison result =
        compare(TaylorSeries({.terms = 200, .radius_sigma_f = 9}), surface, queries, 0);
    CHECK(result.worst <= result.bound);
    smallest = std::min(smallest, result.worst);
    largest = std::max(largest, result.worst);
  }
  CHECK(smallest <= 1e-15);
  CHECK(largest >= 1e-4);  // 2e-4 at x = 30 by the literature of this cancellation
}

TEST_CASE("a request at one frequency of an axis is the same sum as over a range",
          "[taylor_series][crossover]") {
  // Where all queries share qy its neighbours are summed when the tables are filled.
  constexpr std::uint64_t seed = 83;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, grid, 0, 0.3);
  const Surface surface = under_quarter_window(field);
  std::vector<Query> queries;
  for (int i = 0; i < 10; ++i) queries.push_back({uniform(-20, 20), 3.7, uniform(-30, -10)});
  const Amplitudes fixed = amplitudes(TaylorSeries{}, surface, queries, 1e-9);
  queries.push_back({0, -5, -30});
  const Amplitudes ranged = amplitudes(TaylorSeries{}, surface, queries, 1e-9);
  WorstError error;
  for (std::size_t i = 0; i < fixed.size(); ++i) error.see(std::abs(fixed[i] - ranged[i]));
  CHECK(error.value() <= 1e-13);  // the same terms in another order; e^4.5 roundings
  const TaylorSeries method;
  const QueryBounds narrow{{-20, 3.7, -30}, {20, 3.7, -10}, 10, 1e-9};
  const QueryBounds wide{{-20, -5, -30}, {20, 3.7, -10}, 10, 1e-9};
  CHECK(method.plan(surface, narrow).report().bytes < method.plan(surface, wide).report().bytes);
}

TEST_CASE("the bytes announced cover what the plan then holds", "[taylor_series][invariant]") {
  const HeightField field = blazed();
  const Surface surface = under_quarter_window(field);
  for (const QueryBounds& bounds : {QueryBounds{{-5, -5, -30}, {5, 5, -10}, 9, 1e-6},
                                    QueryBounds{{1, 0, -30}, {1, 0, -10}, 9, 1e-3}}) {
    const std::size_t announced = TaylorSeries{}.bytes(surface, bounds);
    const std::size_t transform = brdf::RealFourier2d::bytes(40, 48);
    CHECK(announced == TaylorSeries{}.plan(surface, bounds).report().bytes + transform);
  }
}

TEST_CASE("the least number of terms is taken, or none", "[taylor_series][oracle]") {
  CHECK(brdf::taylor_terms(0, 1e-6, 100) == 1);
  for (const double x : {0.5, 2.36, 4.7, 10.0, 30.0})
    for (const double tolerance : {1e-3, 1e-9}) {
      CAPTURE(x, tolerance);
      const auto terms = brdf::taylor_terms(x, tolerance, 1000);
      REQUIRE(terms);
      CHECK(brdf::taylor_remainder_bound(x, *terms) <= tolerance);
      CHECK(brdf::taylor_remainder_bound(x, *terms - 1) > tolerance);
      CHECK(!brdf::taylor_terms(x, tolerance, *terms - 1));
      CHECK(brdf::taylor_terms(x, tolerance, *terms) == terms);
    }
  // A first bound of 3 below the tolerance is no end while the terms still grow.
  CHECK(brdf::taylor_terms(3, 5, 100) == 3);
}

TEST_CASE("only the periodic model is supported", "[taylor_series][invariant]") {
  CHECK(TaylorSeries::supports(SurfaceModel::periodic));
  CHECK(!TaylorSeries::supports(SurfaceModel::isolated));
}

TEST_CASE("settings that make no series are refused", "[taylor_series][invariant]") {
  for (const int terms : {0, -4, TaylorSeries::max_terms + 1})
    CHECK_ERROR(TaylorSeries({.terms = terms, .radius_sigma_f = {}}), Errc::invalid_argument,
                "terms " + std::to_string(terms));
  const double nan = std::nan("");
  for (const auto& [radius, shown] :
       {std::pair<double, std::string>{0, "0"}, {-1, "-1"}, {40.5, "40.5"}, {nan, "nan"}})
    CHECK_ERROR(TaylorSeries({.terms = {}, .radius_sigma_f = radius}), Errc::invalid_argument,
                "radius " + shown + " ");
}

TEST_CASE("a tolerance beyond every number of terms is refused by its phase depth",
          "[taylor_series][crossover]") {
  const HeightField field =
      sampled(2, 2, 0.1, 0.1, [](double x, double) { return x > 0 ? 100.0 : 0.0; });
  const Surface surface = under_quarter_window(field);
  CHECK_ERROR(TaylorSeries{}.plan(surface, {{0, 0, -32}, {1, 1, -20}, 1, 1e-6}),
              Errc::not_attainable, "3200 rad");
}

TEST_CASE("a phase depth whose rounding exceeds the tolerance is refused, unless terms are given",
          "[taylor_series][crossover]") {
  const HeightField field = blazed();  // heights 0.3 um peak to valley, sampled short of it
  const Surface surface = under_quarter_window(field);
  const auto bounds = [&](double depth_rad, double tolerance) {
    const double c = depth_rad / (2 * field.half_range_um());
    return QueryBounds{{0, 0, -c}, {1, 1, -c}, 1, tolerance};
  };
  // e^x 2^-53 = 1e-6, 1e-3 and 1e-12 at these phase depths 2 x.
  for (const auto& [tolerance, depth_rad] :
       {std::pair(1e-6, 45.842), std::pair(1e-3, 59.658), std::pair(1e-12, 18.211)}) {
    CHECK_ERROR(TaylorSeries{}.plan(surface, bounds(depth_rad + 0.01, tolerance)),
                Errc::not_attainable, "rounds by up to");
    CHECK_NOTHROW(TaylorSeries{}.plan(surface, bounds(depth_rad - 0.01, tolerance)));
    const TaylorSeries with_terms({.terms = 60});
    CHECK(with_terms.plan(surface, bounds(depth_rad + 0.01, tolerance)).report().error_bound >=
          tolerance);
  }
  CHECK_ERROR(TaylorSeries{}.plan(surface, bounds(1500, 1e-3)), Errc::not_attainable,
              "phase depth 1500");
}
