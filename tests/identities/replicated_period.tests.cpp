// What copies of a tile do to the period that is found in their response.
#include <catch2/catch.hpp>
#include <cmath>

#include "brdf/synthetic_surface.h"
#include "evaluation/diffraction.h"
#include "evaluation/period_fit.h"
#include "evaluation/sweep.h"

namespace {

using brdf::Angle;
using brdf::HeightField;
using brdf::Length;
using brdf::SurfaceModel;

constexpr double tile_um = 65;

/// 26.53 periods in the tile.
const HeightField blaze =
    brdf::synthetic_grating({brdf::Profile::blazed, Length::nm(2450), Length::nm(150)}, 1, 650,
                            Length::um(tile_um / 650), Length::um(tile_um));

/// The sources' estimate of order +1, mean and standard deviation over the wavelengths.
evaluation::PeriodSpread spread(const char* method, SurfaceModel model, int copies) {
  const brdf::Surface surface{&blaze,
                              brdf::GaussianWindow(Length::um(tile_um / 4)),
                              model,
                              brdf::Origin::patch_centre,
                              {copies, 1}};
  evaluation::SweepRequest request{Angle::deg(75), {}, {}, {}, {}};
  for (int nm = 380; nm <= 780; nm += 20) request.lambda_nm.values.push_back(nm);
  for (int i = 0; i <= 1800; ++i) request.theta_r_deg.values.push_back(-58 + 0.01 * i);
  const auto plan = evaluation::method_named(method).plan(surface, bounds_of(request, 1e-4), {});
  const auto response =
      sweep(request, evaluation::Diffraction(*plan, {brdf::Quantity::power}), {2, {}});
  const auto plane = evaluation::plane_of_incidence(request.theta_i, {}, {});
  evaluation::PeakSearch search;
  search.period_guess = Length::nm(2450);
  search.refinement = evaluation::Refinement::grid;
  const auto peaks = find_peaks(response, plane, search);
  return period_spread(peaks, plane, 1);
}

}  // namespace

TEST_CASE("copies of a tile have the periods tile / n and no others",
          "[identity][pq_factors][E19]") {
  const auto alone = spread("direct", SurfaceModel::isolated, 1);
  INFO("alone " << alone.mean_nm << ", std " << alone.std_nm);
  // Moved by the slope of the efficiency and the cut window, tenths in a thousand.
  CHECK(std::abs(alone.mean_nm - 2450) <= 2);
  const double nearest_nm = 1000 * tile_um / 27;  // 2407.4
  for (const char* method : {"pq", "direct"}) {
    const auto copied = spread(method, SurfaceModel::replicated, 5);
    INFO(method << " " << copied.mean_nm << ", std " << copied.std_nm);
    CHECK(std::abs(copied.mean_nm - nearest_nm) <= 3);
    // And with a spread that gives no hint of it.
    CHECK(copied.std_nm <= 1);
  }
}
