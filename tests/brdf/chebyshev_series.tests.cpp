// The Chebyshev series against the direct sum: the tolerance is kept, and nothing but query and
// plan decides an amplitude.
#include "brdf/chebyshev_series.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numeric>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "brdf/direct_sum.h"
#include "brdf/height_field.h"
#include "tests/support/amplitudes.h"
#include "tests/support/is_error.h"

using namespace brdf;

namespace {

constexpr unsigned seed = 20140106;

enum class Relief { blazed, sinusoid, rough, deep_step, flat };
enum class Frequencies { along_x, along_y, general };

HeightField relief(Relief kind, Eigen::Index rows, Eigen::Index cols) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  HeightArray heights_um(rows, cols);
  for (Eigen::Index row = 0; row < rows; ++row)
    for (Eigen::Index col = 0; col < cols; ++col) {
      const double x_um = 0.1 * static_cast<double>(col), y_um = 0.12 * static_cast<double>(row);
      const double cycles = x_um / 2.33 + y_um / 31;
      switch (kind) {
        case Relief::blazed:
          heights_um(row, col) = 0.15 * (1 - (cycles - std::floor(cycles)));
          break;
        case Relief::sinusoid:
          heights_um(row, col) = 0.2 * std::cos(2 * pi * cycles);
          break;
        case Relief::rough:
          heights_um(row, col) = 0.4 * uniform(random);
          break;
        case Relief::deep_step:
          heights_um(row, col) = 2 * col + row / 3 < cols ? 3 : 0;
          break;
        case Relief::flat:
          heights_um(row, col) = 0.7;
          break;
      }
    }
  return HeightField(std::move(heights_um), Length::um(0.1), Length::um(0.12));
}

/// Visible light from and to all of the hemisphere; in a plane the other frequency is 0.3 rad/um.
std::vector<Query> random_queries(Frequencies frequencies, std::size_t count) {
  std::mt19937 random(seed + 1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Query> queries;
  for (std::size_t i = 0; i < count; ++i) {
    const double k_per_um = 2 * pi / (0.38 + 0.4 * uniform(random));
    const double u = 3.8 * uniform(random) - 1.9, v = 3.8 * uniform(random) - 1.9;
    const double w = -0.3 - 1.7 * uniform(random);
    queries.push_back({frequencies == Frequencies::along_y ? 0.3 : k_per_um * u,
                       frequencies == Frequencies::along_x ? 0.3 : k_per_um * v, k_per_um * w});
  }
  return queries;
}

Surface surface_of(const HeightField& field, SurfaceModel model, double sigma_um = 1.8) {
  return {&field, GaussianWindow(Length::um(sigma_um)), model, Origin::patch_centre, {3, 2}};
}

/// Error at most the bound, bound at most the tolerance, eight tolerances per decade.
void sweep_tolerances(const Surface& surface, std::span<const Query> queries,
                      std::size_t double_table_bytes = SeriesSettings{}.double_table_bytes) {
  const ChebyshevSeries method(portable_kernels, {.double_table_bytes = double_table_bytes});
  const Amplitudes reference = amplitudes_of(DirectSum{}.plan(surface, many(queries, 1)), queries);
  for (int eighth = 8; eighth <= 96; ++eighth) {
    const double tolerance = std::pow(10.0, -eighth / 8.0);
    const ChebyshevSeriesPlan plan = method.plan(surface, many(queries, tolerance));
    const double error = largest_difference(amplitudes_of(plan, queries), reference);
    CAPTURE(tolerance, plan.report().error_bound);
    CHECK(error <= tolerance);
    CHECK(error <= plan.report().error_bound);
    // Phases here are below 200 rad, so that rounding (4e-14) leaves every tolerance attainable.
    CHECK(plan.report().error_bound <= tolerance);
    CHECK(plan.explain().path != SeriesPath::direct_sum);
  }
}

}  // namespace

TEST_CASE("error stays below tolerance and bound from 1e-1 to 1e-12, eight per decade",
          "[chebyshev_series][oracle][long]") {
  const auto kind =
      GENERATE(Relief::blazed, Relief::sinusoid, Relief::rough, Relief::deep_step, Relief::flat);
  const auto model =
      GENERATE(SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated);
  const auto frequencies =
      GENERATE(Frequencies::along_x, Frequencies::along_y, Frequencies::general);
  CAPTURE(static_cast<int>(kind), static_cast<int>(model), static_cast<int>(frequencies), seed);
  const HeightField field = relief(kind, 48, 63);  // an odd side: the centre is a pixel
  sweep_tolerances(surface_of(field, model), random_queries(frequencies, 24));
}

TEST_CASE("windows from a tenth to three times the patch keep every tolerance",
          "[chebyshev_series][oracle]") {
  const auto sigma_um = GENERATE(0.6, 6.0, 18.0);
  const auto model = GENERATE(SurfaceModel::isolated, SurfaceModel::periodic);
  const auto frequencies = GENERATE(Frequencies::along_x, Frequencies::general);
  CAPTURE(sigma_um, static_cast<int>(model), static_cast<int>(frequencies), seed);
  const HeightField field = relief(Relief::blazed, 48, 60);
  sweep_tolerances(surface_of(field, model, sigma_um), random_queries(frequencies, 16));
}

TEST_CASE("origin at the corner keeps the tolerance", "[chebyshev_series][oracle]") {
  const auto model =
      GENERATE(SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated);
  const auto frequencies = GENERATE(Frequencies::along_x, Frequencies::general);
  const HeightField field = relief(Relief::rough, 32, 40);
  Surface surface = surface_of(field, model);
  surface.origin = Origin::patch_corner;
  sweep_tolerances(surface, random_queries(frequencies, 16));
}

TEST_CASE("phase depth of 200 rad at 1e-12", "[chebyshev_series][oracle]") {
  const auto frequencies = GENERATE(Frequencies::along_x, Frequencies::general);
  HeightArray heights_um = relief(Relief::rough, 48, 48).heights_um();
  std::vector<Query> queries = random_queries(frequencies, 40);
  const double largest_c = bounds_of(queries, 1).max_abs_c_per_um();
  heights_um *= 200 / largest_c / (heights_um.maxCoeff() - heights_um.minCoeff());
  const HeightField field(std::move(heights_um), Length::um(0.1), Length::um(0.1));
  const auto model = GENERATE(SurfaceModel::isolated, SurfaceModel::periodic);
  const Surface surface = surface_of(field, model);
  const ChebyshevSeriesPlan plan = ChebyshevSeries{}.plan(surface, many(queries, 1e-12));
  const Amplitudes reference = amplitudes_of(DirectSum{}.plan(surface, many(queries, 1)), queries);
  const double error = largest_difference(amplitudes_of(plan, queries), reference);
  CAPTURE(error, plan.report().terms);
  CHECK(error <= 1e-12);
  CHECK(error <= plan.report().error_bound);
  CHECK(plan.report().error_bound <= 1e-12);
}

TEST_CASE("an amplitude depends on its query and the plan only, to the last bit",
          "[chebyshev_series][invariant]") {
  const auto model =
      GENERATE(SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated);
  const auto frequencies = GENERATE(Frequencies::along_x, Frequencies::general);
  const auto tolerance = GENERATE(1e-6, 1e-9);
  const HeightField field = relief(Relief::sinusoid, 48, 56);
  // Above the size from which general queries are sorted, and not a multiple of any block.
  const std::vector<Query> queries = random_queries(frequencies, 10'003);
  const ChebyshevSeriesPlan plan =
      ChebyshevSeries{}.plan(surface_of(field, model), many(queries, tolerance));
  const Amplitudes whole = amplitudes_of(plan, queries);

  SECTION("a second plan of the same request") {
    const ChebyshevSeriesPlan again =
        ChebyshevSeries{}.plan(surface_of(field, model), many(queries, tolerance));
    CHECK(amplitudes_of(again, queries) == whole);
  }
  SECTION("any order") {
    std::vector<std::size_t> order(queries.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    std::vector<Query> shuffled;
    Amplitudes expected;
    for (const std::size_t i : order) {
      shuffled.push_back(queries[i]);
      expected.push_back(whole[i]);
    }
    CHECK(amplitudes_of(plan, shuffled) == expected);
  }
  SECTION("any subset, down to one query") {
    for (const std::size_t count : {1u, 2u, 3u, 7u, 8u, 9u, 100u}) {
      const std::span<const Query> some(queries.data() + 17, count);
      CHECK(amplitudes_of(plan, some) ==
            Amplitudes(whole.begin() + 17, whole.begin() + 17 + static_cast<long>(count)));
    }
  }
  SECTION("four threads on unequal parts") {
    Amplitudes parts(queries.size());
    {
      std::vector<std::jthread> threads;
      for (const auto& [first, last] : {std::pair<std::size_t, std::size_t>{0, 101},
                                        {101, 5000},
                                        {5000, 5001},
                                        {5001, queries.size()}})
        threads.emplace_back([&, first = first, last = last] {
          plan.evaluate(std::span(queries).subspan(first, last - first),
                        std::span(parts).subspan(first, last - first));
        });
    }
    CHECK(parts == whole);
  }
}

TEST_CASE("few queries are summed directly, to the direct sum's bits",
          "[chebyshev_series][crossover]") {
  const HeightField field = relief(Relief::rough, 48, 56);
  const Surface surface = surface_of(field, SurfaceModel::isolated);
  const std::vector<Query> queries = random_queries(Frequencies::general, 2);
  const QueryBounds bounds = bounds_of(queries, 1e-6);
  const ChebyshevSeriesPlan plan = ChebyshevSeries{}.plan(surface, bounds);
  CHECK(plan.explain().path == SeriesPath::direct_sum);
  CHECK(plan.report().bytes == 0);
  CHECK(amplitudes_of(plan, queries) == amplitudes_of(DirectSum{}.plan(surface, bounds), queries));
}

TEST_CASE("single precision is used for large tables at 1e-6 and not at 1e-9",
          "[chebyshev_series]") {
  const HeightField field = relief(Relief::blazed, 48, 56);
  const Surface surface = surface_of(field, SurfaceModel::isolated);
  const std::vector<Query> queries = random_queries(Frequencies::along_x, 8);
  const ChebyshevSeries all_large(portable_kernels, {.double_table_bytes = 0});
  CHECK(all_large.explain(surface, many(queries, 1e-6)).storage == TableStorage::single_precision);
  CHECK(all_large.explain(surface, many(queries, 1e-9)).storage == TableStorage::double_precision);
  CHECK(ChebyshevSeries{}.explain(surface, many(queries, 1e-6)).storage ==
        TableStorage::double_precision);
}

TEST_CASE("single precision keeps every tolerance", "[chebyshev_series][oracle]") {
  // The flat patch has the largest amplitudes, and with them the largest rounding.
  const auto kind = GENERATE(Relief::flat, Relief::blazed);
  const auto model =
      GENERATE(SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated);
  const auto frequencies = GENERATE(Frequencies::along_x, Frequencies::general);
  CAPTURE(static_cast<int>(kind), static_cast<int>(model), static_cast<int>(frequencies), seed);
  const HeightField field = relief(kind, 32, 40);
  sweep_tolerances(surface_of(field, model), random_queries(frequencies, 16), 0);
}

TEST_CASE("bytes are known before the plan and hold", "[chebyshev_series][invariant]") {
  const auto frequencies = GENERATE(Frequencies::along_x, Frequencies::general);
  const HeightField field = relief(Relief::blazed, 48, 56);
  const Surface surface = surface_of(field, SurfaceModel::isolated);
  const std::vector<Query> queries = random_queries(frequencies, 8);
  const QueryBounds bounds = many(queries, 1e-6);
  CHECK(ChebyshevSeries{}.plan(surface, bounds).report().bytes <=
        ChebyshevSeries{}.bytes(surface, bounds));
}

TEST_CASE("a tolerance that is not positive and queries outside the bounds are refused",
          "[chebyshev_series]") {
  const HeightField field = relief(Relief::blazed, 16, 16);
  const Surface surface = surface_of(field, SurfaceModel::isolated);
  const std::vector<Query> queries = random_queries(Frequencies::general, 8);
  CHECK_THROWS_AS(ChebyshevSeries{}.plan(surface, many(queries, 0)), Error);
  CHECK_THROWS_AS(ChebyshevSeries{}.plan(surface, many(queries, std::nan(""))), Error);
  const ChebyshevSeriesPlan plan = ChebyshevSeries{}.plan(surface, many(queries, 1e-3));
  Amplitudes one(1);
  for (const Query& outside : {Query{99, 0, -10}, Query{0, 0, -99}, Query{std::nan(""), 0, -10}})
    CHECK_THROWS_AS(plan.evaluate(std::span(&outside, 1), one), Error);
}

TEST_CASE("reliefs of hundreds of micrometres keep the tolerance in every plane",
          "[chebyshev_series][crossover]") {
  // From 50 um on the carrier is multiplied out at the pixels: c_mid r passes 1000 rad.
  for (const double height_um : {40.0, 60.0, 400.0}) {
    const HeightField unit = relief(Relief::rough, 6, 7);
    const HeightField field(HeightArray(unit.heights_um() * (height_um / 0.4)), Length::um(0.1),
                            Length::um(0.12));
    for (const SurfaceModel model :
         {SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated})
      for (const Frequencies frequencies :
           {Frequencies::along_x, Frequencies::along_y, Frequencies::general}) {
        CAPTURE(height_um, static_cast<int>(model), static_cast<int>(frequencies));
        std::vector<Query> queries = random_queries(frequencies, 20);
        for (Query& q : queries) q.c_per_um = -42 - q.c_per_um / 30;  // within 3 %
        const Surface surface = surface_of(field, model, 0.3);
        const ChebyshevSeriesPlan plan =
            ChebyshevSeries(portable_kernels, {.small_requests = SmallRequests::by_series})
                .plan(surface, bounds_of(queries, 1e-9));
        CHECK(plan.explain().path != SeriesPath::direct_sum);
        CHECK(plan.report().error_bound <= 1e-9);
        // The direct sum's own rounding: 2 eps times 2e4 rad.
        CHECK(largest_difference(amplitudes_of(plan, queries),
                                 amplitudes_of(DirectSum{}.plan(surface, many(queries, 1)),
                                               queries)) <= 1e-9 + 1e-11);
      }
  }
}

TEST_CASE("a phase that varies too much over the request is left to the direct sum, or refused",
          "[chebyshev_series][crossover]") {
  const HeightField field(HeightArray(relief(Relief::rough, 6, 7).heights_um() * 1000),
                          Length::um(0.1), Length::um(0.12));
  const Surface surface = surface_of(field, SurfaceModel::isolated);
  const QueryBounds bounds{{-1, -1, -30}, {1, 1, -10}, 100'000'000, 1e-6};
  CHECK(ChebyshevSeries{}.plan(surface, bounds).explain().path == SeriesPath::direct_sum);
  CHECK_ERROR(ChebyshevSeries(portable_kernels, {.small_requests = SmallRequests::by_series})
                  .plan(surface, bounds),
              Errc::over_limit, "up to 2000");
}

TEST_CASE("copies along an axis of one frequency are many at no cost",
          "[chebyshev_series][oracle]") {
  const HeightField field = relief(Relief::blazed, 5, 7);
  const Surface surface{&field,
                        GaussianWindow(Length::um(1)),
                        SurfaceModel::replicated,
                        Origin::patch_centre,
                        {1, 1'000'000'000}};
  Surface tile = surface;
  tile.replicas = {1, 1};
  // At whole cycles of the tile all copies add up, an odd order of an even number with a minus.
  for (const int order : {0, 3}) {
    const double qy = 2 * pi * order / field.height_um();
    const std::vector<Query> queries{{1.3, qy, -20}, {-4, qy, -15}};
    Amplitudes expected = amplitudes_of(DirectSum{}.plan(tile, many(queries, 1)), queries);
    if (order % 2 != 0)
      for (std::complex<double>& a : expected) a = -a;
    const Amplitudes found = amplitudes_of(
        ChebyshevSeries(portable_kernels, {.small_requests = SmallRequests::by_series})
            .plan(surface, bounds_of(queries, 1e-10)),
        queries);
    // 1e9 copies turn by the rounding of the frequency, 4e-16 of 3 cycles: 4e-6 rad at the ends.
    CHECK(largest_difference(found, expected) <= 1e-10 + 1e-10 * order);
  }
}
