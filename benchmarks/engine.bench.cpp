// The parts one by one under Google Benchmark; the comparisons are made by table.cpp.
#include <benchmark/benchmark.h>

#include "benchmarks/engine_runs.h"
#include "benchmarks/scenes.h"
#include "benchmarks/sources_algorithm.h"

namespace {

using namespace benchmarks;
using brdf::SurfaceModel;

const Queries& sweep() {
  static const Queries queries = in_plane_sweep();
  return queries;
}

const Queries& random_million() {
  static const Queries queries = random_directions(1000000);
  return queries;
}

/// Argument: -log10 of the tolerance.
double tolerance(const benchmark::State& state) {
  return std::pow(10.0, -static_cast<double>(state.range(0)));
}

void plan(benchmark::State& state, SurfaceModel model, Eigen::Index pixels,
          const Queries& queries) {
  const brdf::HeightField field = blazed(pixels);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        engine().plan(lit(field, model), brdf::bounds_of(queries, tolerance(state))));
}

void evaluate_plan(benchmark::State& state, SurfaceModel model, Eigen::Index pixels,
                   const Queries& queries) {
  const brdf::HeightField field = blazed(pixels);
  const auto planned = engine().plan(lit(field, model), brdf::bounds_of(queries, tolerance(state)));
  Amplitudes amplitudes(queries.size());
  for (auto _ : state) planned.evaluate(queries, amplitudes);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(queries.size()));
}

template <class Real>
void sources(benchmark::State& state) {
  const brdf::HeightField field = blazed(650);
  Amplitudes amplitudes(sweep().size());
  for (auto _ : state)
    SourcesAlgorithm<Real>(lit(field, SurfaceModel::periodic), Planning::estimate)
        .evaluate(sweep(), amplitudes);
}

/// Items: complex exponentials.
void direct_sum(benchmark::State& state, const brdf::PhaseKernels& kernels) {
  const brdf::HeightField field = blazed(256);
  const Queries some = every(sweep(), 5000);
  const auto planned =
      brdf::DirectSum(kernels).plan(lit(field, SurfaceModel::isolated), brdf::bounds_of(some, 0));
  Amplitudes amplitudes(some.size());
  for (auto _ : state) planned.evaluate(some, amplitudes);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(some.size() * 256 * 256));
}

constexpr auto ms_unit = benchmark::kMillisecond;

BENCHMARK_CAPTURE(plan, A_periodic, SurfaceModel::periodic, 650, sweep())
    ->Arg(6)
    ->Arg(12)
    ->Unit(ms_unit);
BENCHMARK_CAPTURE(plan, A_isolated, SurfaceModel::isolated, 650, sweep())
    ->Arg(6)
    ->Arg(12)
    ->Unit(ms_unit);
BENCHMARK_CAPTURE(plan, C_isolated, SurfaceModel::isolated, 256, random_million())
    ->Arg(6)
    ->Arg(12)
    ->Unit(ms_unit);
BENCHMARK_CAPTURE(evaluate_plan, A_periodic, SurfaceModel::periodic, 650, sweep())
    ->Arg(6)
    ->Arg(12)
    ->Unit(ms_unit);
BENCHMARK_CAPTURE(evaluate_plan, A_isolated, SurfaceModel::isolated, 650, sweep())
    ->Arg(6)
    ->Arg(12)
    ->Unit(ms_unit);
BENCHMARK_CAPTURE(evaluate_plan, C_isolated, SurfaceModel::isolated, 256, random_million())
    ->Arg(6)
    ->Arg(12)
    ->Unit(ms_unit);
BENCHMARK(sources<float>)->Unit(ms_unit);
BENCHMARK(sources<double>)->Unit(ms_unit);
BENCHMARK_CAPTURE(direct_sum, vectorised, evaluation::vectorised_phase_kernels())->Unit(ms_unit);
BENCHMARK_CAPTURE(direct_sum, portable, brdf::portable_phase_kernels)->Unit(ms_unit);

}  // namespace

BENCHMARK_MAIN();
