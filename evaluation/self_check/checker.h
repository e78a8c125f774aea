// What the self-checks share: tiles in the models of a method, and the rows.
#pragma once

#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "brdf/synthetic_profile.h"
#include "evaluation/checks.h"
#include "evaluation/methods.h"

namespace evaluation::self {

/// Largest error of an amplitude that the plans are asked for.
inline constexpr double tolerance = 1e-10;

using Amplitudes = std::vector<std::complex<double>>;

/// The amplitudes of a method.
inline Amplitudes amplitudes(const Method& method, const brdf::Surface& surface,
                             const std::vector<brdf::Query>& queries) {
  Amplitudes result(queries.size());
  method.plan(surface, brdf::bounds_of(queries, tolerance), {})->evaluate(queries, result);
  return result;
}

inline bool has(const Method& method, brdf::SurfaceModel model) {
  for (const brdf::SurfaceModel one : method.models)
    if (one == model) return true;
  return false;
}

/// A surface on which a method reads the orders of a tile one by one: a single evenly lit copy, or
/// the periodic model under a window twice as wide as the tile, whose lines at whole cycles do not
/// touch: the next weighs exp(-(2 pi 2)^2 / 2) = 5e-35. Empty where the method has neither.
std::vector<brdf::Surface> tiles(const Method& method, const brdf::HeightField& field);

/// The patch in every model of the method; as replicated one copy, so that the patch is whole.
std::vector<brdf::Surface> patches(const Method& method, const brdf::HeightField& field);

/// A relief of 5 x 8 pixels without symmetry, 0.4 um peak to valley.
brdf::HeightField relief();
/// One period of a profile in a row of pixels, the first at phase 0.
brdf::HeightField one_period(const brdf::ProfileParameters& profile, Eigen::Index pixels);

/// The query at whole cycles of a tile.
brdf::Query at_cycles(const brdf::HeightField& field, int x, int y, double c_per_um);
/// All of them: x cycles by y cycles.
std::vector<brdf::Query> all_cycles(const brdf::HeightField& field, double c_per_um);

/// A row of the table.
inline CheckTally tally(const char* check, const Method& method, std::string reason) {
  return {check, std::string(method.name), "of the peak", std::move(reason)};
}

std::vector<CheckRow> closed_form_rows(const Method& method);
std::vector<CheckRow> energy_rows(const Method& method);
std::vector<CheckRow> identity_rows(const Method& method);

}  // namespace evaluation::self
