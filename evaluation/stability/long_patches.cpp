#include <cmath>

#include "evaluation/stability/exact_amplitude.h"
#include "evaluation/stability/groups.h"
#include "evaluation/stability/method_tallies.h"

namespace evaluation::stability {
namespace {

constexpr Eigen::Index pixels = 16;

/// One row of pixels with a relief of 0.3 um.
brdf::HeightField narrow_patch(double width_um) {
  brdf::HeightArray heights_um(1, pixels);
  for (Eigen::Index col = 0; col < pixels; ++col)
    heights_um(0, col) = 0.15 * (1 + std::cos(1.7 * static_cast<double>(col)));
  return {std::move(heights_um), brdf::Length::um(width_um / pixels), brdf::Length::um(0.2)};
}

/// kernels_error: what the method is allowed beside the rounding of the phase.
CheckRow row(const char* method, double kernels_error, const std::string& reason) {
  CheckTally tally(std::string("method ") + method, "patches 1 um to 10 cm long, 500 nm",
                   "of the peak", reason);
  const double k_per_um = brdf::wavenumber_per_um(brdf::Length::nm(500));
  for (double width_um = 1; width_um <= 1e5; width_um *= 10) {
    const brdf::HeightField field = narrow_patch(width_um);
    const brdf::Surface surface = under_window(field);
    for (const double u : {0.01, 0.3, 1.0, 1.9}) {
      std::vector<brdf::Query> queries;
      for (const double step : {0.0, 0.4, 1.0})
        queries.push_back({k_per_um * u + step / width_um, 0, -(1.2 + 0.1 * step) * k_per_um});
      const double phase_rad = queries.back().qx_per_um * (width_um + field.dx_um()) / 2 -
                               queries.back().c_per_um * field.max_um();
      const AmplitudeCase one{
          brdf::text(width_um) + " um, u = " + brdf::text(u), surface, queries,
          2 * std::numeric_limits<double>::epsilon() * phase_rad + kernels_error};
      see_case(tally, method_named(method), one, exact_amplitudes(surface, queries),
               MayRefuse::never);
    }
  }
  return tally.row();
}

}  // namespace

std::vector<CheckRow> long_patch_rows() {
  return {
      row("direct", 1e-15,
          "2 eps times the largest phase at the patch's end, and the rounding of the sum, 1e-15"),
      row("chebyshev", 1e-12,
          "2 eps times the largest phase, and the tolerance asked for beside it, 1e-12")};
}

}  // namespace evaluation::stability
