#include <cstdlib>

#include "benchmarks/engine_runs.h"
#include "benchmarks/rows.h"
#include "benchmarks/scenes.h"
#include "brdf/order_range.h"
#include "brdf/taylor_series.h"

namespace benchmarks {
namespace {

/// The queries in a band around an order, and where they stood.
struct Selected {
  Queries queries;
  std::vector<std::size_t> places;
};

Selected within(const brdf::OrderBands& bands, const Queries& queries) {
  Selected selected;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (!bands.contains(queries[i])) continue;
    selected.queries.push_back(queries[i]);
    selected.places.push_back(i);
  }
  return selected;
}

/// Stops the run where a selected query lacks the bits of the full sweep.
void require_same_bits(const Amplitudes& all, const Amplitudes& some, const Selected& selected) {
  for (std::size_t i = 0; i < some.size(); ++i)
    if (some[i] != all[selected.places[i]]) {
      std::fprintf(stderr, "a selected cell differs from the full sweep\n");
      std::exit(1);
    }
}

template <class Plan>
void compare(RatioTable& table, const std::string& method, const Plan& plan,
             const brdf::OrderBands& bands, const Queries& queries) {
  Amplitudes all(queries.size()), some;
  Samples all_s, some_s, select_s;
  Selected selected;
  for (int i = 0; i < repetitions; ++i) {
    all_s.add(evaluate(plan, queries, all, {}));
    const Stopwatch selecting;
    selected = within(bands, queries);
    const double to_select_s = selecting.seconds();
    some.resize(selected.queries.size());
    select_s.add(to_select_s);
    some_s.add(to_select_s + evaluate(plan, selected.queries, some, {}));
  }
  require_same_bits(all, some, selected);
  table.at_least(
      "A periodic, " + method + ": Nmin/Nmax against all cells, plan excluded",
      all_s.median() / some_s.median(), 1, "x",
      ms(all_s) + " / " + ms(some_s) +
          format(" (%.2f ms of it to select); %.1f %% of the cells, the same bits",
                 1e3 * select_s.median(),
                 100.0 * static_cast<double>(some.size()) / static_cast<double>(all.size())));
}

}  // namespace

void orders_only(RatioTable& table) {
  const brdf::HeightField field = blazed(650);
  const Queries queries = in_plane_sweep();
  const brdf::Surface surface = lit(field, brdf::SurfaceModel::periodic);
  const brdf::QueryBounds bounds = brdf::bounds_of(queries, 1e-6);
  const brdf::OrderBands bands(surface, {brdf::Length::um(2.5)}, 4);
  compare(table, "1e-6", engine().plan(surface, bounds), bands, queries);
  compare(table, "the sources' 30 terms", brdf::TaylorSeries({30, 4.0}).plan(surface, bounds),
          bands, queries);
}

}  // namespace benchmarks
