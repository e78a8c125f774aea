#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "benchmarks/engine_runs.h"
#include "benchmarks/rows.h"
#include "benchmarks/scenes.h"
#include "benchmarks/sources_algorithm.h"
#include "brdf/taylor_series.h"

namespace benchmarks {

using brdf::SurfaceModel;

void against_the_sources(RatioTable& table, const std::string& memory) {
  std::printf("%s: ", memory.c_str());
  const brdf::HeightField field = blazed(650);
  const brdf::Surface surface = lit(field, SurfaceModel::periodic);
  const Queries queries = in_plane_sweep(), some = every(queries, 701);
  Amplitudes by_sources(queries.size()), by_engine, exact, same(some.size()), check(some.size());
  SourcesAlgorithm<float> sources(surface, Planning::estimate);
  sources.evaluate(some, check);
  brdf::TaylorSeries({.terms = sources_terms, .radius_sigma_f = sources_radius_sigma_f})
      .plan(surface, brdf::bounds_of(some, 1e-6))
      .evaluate(some, same);
  run_direct_sum(surface, some, exact);
  const double to_taylor = worst_difference(check, same);
  std::printf(
      "A periodic, %zu cells: the sources' algorithm differs from the same series in double"
      " by %.1e,\nfrom the direct sum by %.1e;",
      some.size(), to_taylor, worst_difference(check, exact));
  if (!(to_taylor <= 1e-5)) std::exit((std::puts(" the baseline is wrong"), 1));
  run_engine(surface, some, 1e-6, check);
  std::printf(" the Chebyshev series at 1e-6 differs from it by %.1e.\n",
              worst_difference(check, exact));

  struct Split {
    Samples planning, transforms, interleaving, gather, total;
    void add(const SourcesTimes& t, double total_s) {
      planning.add(t.planning_s);
      transforms.add(t.transforms_s);
      interleaving.add(t.interleaving_s);
      gather.add(t.gather_s);
      total.add(total_s);
    }
    void print(const char* what) const {
      std::printf(
          "The sources' algorithm, %s: planning %.1f, FFTs and powers %.1f, interleaving "
          "%.1f, gather %.1f, in all %s\n",
          what, 1e3 * planning.median(), 1e3 * transforms.median(), 1e3 * interleaving.median(),
          1e3 * gather.median(), ms(total).c_str());
    }
  } single, measured, twice;
  const auto run_sources = [&]<class Real>(Planning planning, Split& split, Real) {
    SourcesAlgorithm<Real> run(surface, planning);
    run.evaluate(queries, by_sources);
    split.add(run.times(), run.total_s());
  };
  Samples engine_s, plan_s;
  for (int i = 0; i < repetitions; ++i) {
    run_sources(Planning::estimate, single, 0.0f);
    for (int again = 0; again < 3; ++again) {
      const EngineTimes times = run_engine(surface, queries, 1e-6, by_engine);
      engine_s.add(times.total_s());
      plan_s.add(times.plan_s);
    }
    run_sources(Planning::measure, measured, 0.0f);
    run_sources(Planning::estimate, twice, 0.0);
  }
  single.print("float, FFTW_ESTIMATE");
  measured.print("float, FFTW_MEASURE (planning not counted)");
  twice.print("double, FFTW_ESTIMATE");
  std::puts("");
  const Split& best = measured.total.median() < single.total.median() ? measured : single;
  table.at_most("the sources' algorithm on A, " + memory, best.total.median(), 0.4, "s",
                ms(best.total));
  table.at_least("A periodic 1e-6 against the sources' algorithm, " + memory,
                 best.total.median() / engine_s.median(), 25, "x",
                 ms(best.total) + " / " + ms(engine_s) +
                     format(" (plan %.2f ms); least against least %.3g x; against its double form "
                            "%.3g x",
                            1e3 * plan_s.median(), best.total.least() / engine_s.least(),
                            twice.total.median() / engine_s.median()));
}

void against_the_direct_sum(RatioTable& table) {
  const brdf::HeightField field = blazed(650);
  const brdf::Surface surface = lit(field, SurfaceModel::isolated);
  const Queries queries = in_plane_sweep();
  constexpr std::size_t parts = 5, step = 10 * parts;
  Amplitudes by_engine, by_direct;
  Samples engine_s, direct_s;
  double worst = 0;
  for (std::size_t part = 0; part < parts; ++part) {
    for (int again = 0; again < 4; ++again)
      engine_s.add(run_engine(surface, queries, 1e-6, by_engine).total_s());
    const Queries some = every(queries, step, 10 * part);
    direct_s.add(run_direct_sum(surface, some, by_direct) / static_cast<double>(some.size()) *
                 static_cast<double>(queries.size()));
    for (std::size_t i = 0; i < some.size(); ++i)
      worst = std::max(worst, std::abs(by_direct[i] - by_engine[10 * part + step * i]));
  }
  table.at_least("A isolated 1e-6 against the vectorised direct sum",
                 direct_s.median() / engine_s.median(), 5000, "x",
                 format("%.3g s +- %.0f %%", direct_s.median(), 100 * direct_s.spread()) + " / " +
                     ms(engine_s) + format("; worst error %.1e", worst));
  table.at_least("vectorised direct sum, one thread",
                 static_cast<double>(queries.size()) *
                     static_cast<double>(field.heights_um().size()) / direct_s.median() / 1e6,
                 500, "million complex exponentials/s", "a tenth of A");
}

void full_check(RatioTable& table) {
  const brdf::HeightField field = blazed(256);
  const brdf::Surface surface = lit(field, SurfaceModel::isolated);
  const Queries queries = in_plane_sweep();
  Amplitudes by_engine, by_direct;
  run_engine(surface, queries, 1e-12, by_engine);
  const double direct_s = run_direct_sum(surface, queries, by_direct, {2, Time::of_wall});
  table.at_most("every cell of A at 256 x 256 by direct sum, two threads", direct_s, 30,
                "s of wall",
                format("worst error of the Chebyshev series at 1e-12: %.1e",
                       worst_difference(by_engine, by_direct)));
}

}  // namespace benchmarks
