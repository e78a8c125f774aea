#include <cmath>

#include "evaluation/stability/exact_amplitude.h"
#include "evaluation/stability/groups.h"
#include "evaluation/stability/method_tallies.h"

namespace evaluation::stability {
namespace {

constexpr int billion = 1'000'000'000;
constexpr const char* range = "1e9 x 1e9 copies";

brdf::Surface copies(const brdf::HeightField& field) {
  brdf::Surface surface = under_window(field);
  surface.model = brdf::SurfaceModel::replicated;
  surface.replicas = {billion, billion};
  return surface;
}

CheckRow method_row(const char* method, MayRefuse may_refuse) {
  CheckTally tally(std::string("method ") + method, range, "of the peak",
                   "8 eps times the mean phase along the copies: what the rounding of a frequency "
                   "makes of it; and 1e-10");
  const brdf::HeightField field = relief(0.3);
  const brdf::Surface surface = copies(field);
  const double length_um = field.width_um();
  for (const double order : {0.0, 1.0, 7.0})
    for (const double off_order : {0.0, 1e-10, 3e-9, 0.3}) {
      const double qx_per_um = 2 * brdf::pi * (order + off_order) / length_um;
      const std::vector<brdf::Query> queries{{qx_per_um, 0, -22}, {qx_per_um, 0, -17}};
      const double mean_phase_rad = qx_per_um * length_um * billion / 4;
      const AmplitudeCase one{
          "order " + brdf::text(order) + " + " + brdf::text(off_order), surface, queries,
          8 * std::numeric_limits<double>::epsilon() * (1 + mean_phase_rad) + 1e-10};
      see_case(tally, method_named(method), one, exact_amplitudes(surface, queries), may_refuse);
    }
  return tally.row();
}

CheckRow area_row() {
  CheckTally tally("coherence area", range, "relative", "six products round by 1.1e-16 each");
  const brdf::HeightField field = relief(0.3);
  const double area_um2 = field.width_um() * field.height_um() * 1e18;
  tally.see(std::abs(coherence_area_um2(copies(field)) / area_um2 - 1), 1e-15, range);
  return tally.row();
}

}  // namespace

std::vector<CheckRow> replica_rows() {
  return {method_row("pq", MayRefuse::never), method_row("chebyshev", MayRefuse::never),
          method_row("auto", MayRefuse::never), method_row("direct", MayRefuse::always),
          area_row()};
}

}  // namespace evaluation::stability
