#include "evaluation/stability/exact_amplitude.h"
#include "evaluation/stability/groups.h"
#include "evaluation/stability/method_tallies.h"

namespace evaluation::stability {
namespace {

brdf::HeightField patch(const brdf::HeightArray& heights_um) {
  return {heights_um, brdf::Length::um(0.2), brdf::Length::um(0.3)};
}

/// All methods in all of their models.
CheckRow row(const char* range, const brdf::HeightField& field) {
  constexpr double tolerance = 1e-10;
  CheckTally tally("all methods, all surface models", range, "of the peak",
                   "the tolerance asked for, 1e-10");
  const std::vector<brdf::Query> in_plane{{0, 0, -22}, {3, 0, -1e-9}, {-11, 0, -17}};
  const std::vector<brdf::Query> general{{0, 0, -22}, {3, -2, -1e-9}, {-11, 7, -17}};
  for (const auto& [queries, name] : {std::pair{in_plane, "in plane"}, {general, "general"}})
    for (const brdf::SurfaceModel model :
         {brdf::SurfaceModel::isolated, brdf::SurfaceModel::periodic,
          brdf::SurfaceModel::replicated}) {
      brdf::Surface surface = under_window(field);
      surface.model = model;
      const auto exact = exact_amplitudes(surface, queries);
      for (const Method& method : methods())
        if (std::find(method.models.begin(), method.models.end(), model) != method.models.end())
          see_case(tally, method,
                   {std::string(method.name) + ", " + std::string(name_of(model)) + ", " + name,
                    surface, queries, tolerance},
                   exact, MayRefuse::never);
    }
  return tally.row();
}

}  // namespace

std::vector<CheckRow> small_patch_rows() {
  brdf::HeightArray spike = brdf::HeightArray::Zero(3, 3);
  spike(1, 2) = 0.4;
  return {row("flat patch", patch(brdf::HeightArray::Constant(3, 4, 0.7))),
          row("one pixel", patch(brdf::HeightArray::Constant(1, 1, 0.7))),
          row("one spike of 400 nm", patch(spike))};
}

}  // namespace evaluation::stability
