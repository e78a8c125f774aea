// Timed runs of the Chebyshev series and of the direct sum.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "benchmarks/stopwatch.h"
#include "brdf/chebyshev_series.h"
#include "brdf/direct_sum.h"
#include "evaluation/kernels/phase_sum.h"
#include "evaluation/kernels/series_kernels.h"
#include "evaluation/parallel.h"

namespace benchmarks {

using Queries = std::vector<brdf::Query>;
using Amplitudes = std::vector<std::complex<double>>;

struct EngineTimes {
  double plan_s, evaluate_s;
  double total_s() const { return plan_s + evaluate_s; }
};

/// How something is run and timed.
struct Run {
  std::size_t threads = 1;
  Time time = Time::of_thread;
};

/// Evaluates equal shares of the queries, one for each thread. Seconds of wall, or of processor
/// time of the thread that took longest.
template <class Plan>
double evaluate(const Plan& plan, std::span<const brdf::Query> queries,
                std::span<std::complex<double>> amplitudes, Run run) {
  const Stopwatch all(run.time);
  std::vector<double> each_s(run.threads);
  const auto share = [&](std::size_t t) {
    const Stopwatch watch;
    const std::size_t first = queries.size() * t / run.threads,
                      end = queries.size() * (t + 1) / run.threads;
    plan.evaluate(queries.subspan(first, end - first), amplitudes.subspan(first, end - first));
    each_s[t] = watch.seconds();
  };
  evaluation::parallel_for(run.threads, static_cast<int>(run.threads), share);
  return run.time == Time::of_wall ? all.seconds()
                                   : *std::max_element(each_s.begin(), each_s.end());
}

/// The engine, its plans made by that many threads.
inline brdf::ChebyshevSeries engine(std::size_t threads = 1) {
  brdf::SeriesSettings settings;
  if (threads > 1)
    settings.executor = [threads](std::size_t count, const std::function<void(std::size_t)>& task) {
      evaluation::parallel_for(count, static_cast<int>(threads), task);
    };
  return brdf::ChebyshevSeries(evaluation::vectorised_kernels(), settings);
}

/// The bounds of equal shares, one for each thread, put together.
inline brdf::QueryBounds bounds_of(const Queries& queries, double tolerance, std::size_t threads) {
  if (threads == 1) return brdf::bounds_of(queries, tolerance);
  Queries corners(2 * threads);
  evaluation::parallel_for(threads, static_cast<int>(threads), [&](std::size_t t) {
    const std::size_t first = queries.size() * t / threads,
                      end = queries.size() * (t + 1) / threads;
    const auto share = brdf::bounds_of(std::span(queries).subspan(first, end - first), tolerance);
    corners[2 * t] = share.lo;
    corners[2 * t + 1] = share.hi;
  });
  brdf::QueryBounds bounds = brdf::bounds_of(corners, tolerance);
  bounds.count = queries.size();
  return bounds;
}

/// Bounds of the queries, plan, and all amplitudes.
inline EngineTimes run_engine(const brdf::Surface& surface, const Queries& queries,
                              double tolerance, Amplitudes& amplitudes, Run run = {}) {
  amplitudes.resize(queries.size());
  const Stopwatch planning(run.time);
  const auto plan = engine(run.threads).plan(surface, bounds_of(queries, tolerance, run.threads));
  const double plan_s = planning.seconds();
  return {plan_s, evaluate(plan, queries, amplitudes, run)};
}

inline double run_direct_sum(const brdf::Surface& surface, const Queries& queries,
                             Amplitudes& amplitudes, Run run = {}) {
  amplitudes.resize(queries.size());
  const brdf::DirectSum method(evaluation::vectorised_phase_kernels());
  return evaluate(method.plan(surface, brdf::bounds_of(queries, 0)), queries, amplitudes, run);
}

/// NaN if any amplitude is.
inline double worst_difference(const Amplitudes& a, const Amplitudes& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = std::abs(a[i] - b[i]);
    if (std::isnan(d)) return d;
    worst = std::max(worst, d);
  }
  return worst;
}

inline Queries every(const Queries& queries, std::size_t step, std::size_t first = 0) {
  Queries some;
  for (std::size_t i = first; i < queries.size(); i += step) some.push_back(queries[i]);
  return some;
}

}  // namespace benchmarks
