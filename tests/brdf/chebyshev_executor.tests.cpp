// Making a Chebyshev plan on several threads.
#include <algorithm>
#include <catch2/catch.hpp>
#include <complex>
#include <random>
#include <thread>
#include <vector>

#include "brdf/chebyshev_series.h"
#include "brdf/height_field.h"

using namespace brdf;

namespace {

constexpr unsigned seed = 11;

enum class Frequencies { along_x, along_y, general };

HeightField rough(Eigen::Index rows, Eigen::Index cols) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 0.4);
  return HeightField(HeightArray::NullaryExpr(rows, cols, [&] { return uniform(random); }),
                     Length::um(0.1), Length::um(0.12));
}

std::vector<Query> random_queries(Frequencies frequencies, std::size_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Query> queries;
  for (std::size_t i = 0; i < count; ++i) {
    const double q_per_um = 30 * uniform(random), other_per_um = 25 * uniform(random);
    queries.push_back({frequencies == Frequencies::along_y ? 0 : q_per_um,
                       frequencies == Frequencies::along_x ? 0 : other_per_um,
                       -18 + 10 * uniform(random)});
  }
  return queries;
}

std::vector<std::complex<double>> amplitudes(const Executor& executor, const Surface& surface,
                                             std::span<const Query> queries) {
  QueryBounds bounds = bounds_of(queries, 1e-9);
  bounds.count = 10'000'000;
  const ChebyshevSeries method(portable_kernels, {.executor = executor});
  std::vector<std::complex<double>> result(queries.size());
  method.plan(surface, bounds).evaluate(queries, result);
  return result;
}

/// Every `threads`-th task to the same thread.
Executor on_threads(std::size_t threads) {
  return [threads](std::size_t count, const std::function<void(std::size_t)>& task) {
    std::vector<std::jthread> pool;
    for (std::size_t t = 0; t < threads; ++t)
      pool.emplace_back([&, t] {
        for (std::size_t i = t; i < count; i += threads) task(i);
      });
  };
}

void backwards(std::size_t count, const std::function<void(std::size_t)>& task) {
  for (std::size_t i = count; i > 0; --i) task(i - 1);
}

}  // namespace

TEST_CASE("a plan has the same bits whoever runs its tasks", "[chebyshev_series][invariant]") {
  const auto model =
      GENERATE(SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated);
  const auto frequencies =
      GENERATE(Frequencies::along_x, Frequencies::along_y, Frequencies::general);
  CAPTURE(static_cast<int>(model), static_cast<int>(frequencies), seed);
  const HeightField field = rough(53, 77);  // sides that no batch divides
  const Surface surface{
      &field, GaussianWindow(Length::um(1.8)), model, Origin::patch_centre, {3, 2}};
  const std::vector<Query> queries = random_queries(frequencies, 200);
  const auto serial = amplitudes(run_serially, surface, queries);
  CHECK(amplitudes(backwards, surface, queries) == serial);
  for (const std::size_t threads : {2u, 3u, 7u})
    CHECK(amplitudes(on_threads(threads), surface, queries) == serial);
}

TEST_CASE("what a task throws leaves the plan", "[chebyshev_series]") {
  const HeightField field = rough(16, 16);
  const Surface surface{&field, GaussianWindow(Length::um(1.8)), SurfaceModel::isolated};
  const auto failing = [](std::size_t, const std::function<void(std::size_t)>&) {
    throw Error(Errc::invalid_argument, "no thread");
  };
  CHECK_THROWS_AS(amplitudes(failing, surface, random_queries(Frequencies::along_x, 4)), Error);
}
