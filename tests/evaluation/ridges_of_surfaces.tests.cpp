// Ridges of responses that the engine computes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "brdf/synthetic_surface.h"
#include "evaluation/diffraction.h"
#include "evaluation/period/ridges.h"
#include "evaluation/sweep.h"
#include "tests/support/real_data.h"
#include "tests/support/real_scans.h"

namespace {

using brdf::Angle;
using brdf::Length;
using evaluation::ResponseMatrix;
using evaluation::Ridge;
using evaluation::Ridges;

constexpr double sigma_um = 16.25;
constexpr double sigma_f = 1 / (2 * brdf::pi * sigma_um);
const evaluation::PlaneOfIncidence plane{Angle::deg(75), 1, sigma_f};

}  // namespace

TEST_CASE("the engine's response of a blaze has its orders as ridges", "[oracle][ridges]") {
  const brdf::HeightField field =
      brdf::synthetic_grating({brdf::Profile::blazed, Length::nm(2500), Length::nm(600)}, 1, 1300,
                              Length::nm(50), Length::um(1));
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(sigma_um)),
                              brdf::SurfaceModel::isolated};
  evaluation::SweepRequest request{Angle::deg(75), Angle::deg(0), Angle::deg(0), {}, {}};
  for (int nm = 380; nm <= 780; nm += 10) request.lambda_nm.values.push_back(nm);
  for (int i = -600; i <= 100; ++i) request.theta_r_deg.values.push_back(i / 10.0);
  const auto plan =
      evaluation::method_named("chebyshev").plan(surface, bounds_of(request, 1e-6), {});
  const ResponseMatrix response = sweep(request, evaluation::Diffraction(*plan, {}), {});
  const Ridges found = find_ridges(response, plane, {});
  REQUIRE(found.ridges.size() >= 3);
  for (const Ridge& ridge : found.ridges) {
    INFO(ridge.period_nm << " nm, relative " << ridge.relative);
    REQUIRE(ridge.order);
    // Nothing but orders. The slope of gain and efficiency pulls a lobe by a part of its width.
    CHECK(std::abs(ridge.f_per_um - *ridge.order / 2.5) <= 0.1 * sigma_f);
  }
}

TEST_CASE("two skins have several ridges side by side", "[golden][real][ridges]") {
  const auto folder = real_data();
  if (!folder) return;
  struct Skin {
    const char* file;
    double phi_i_deg, first_deg, last_deg;
    std::vector<double> periods_nm;  ///< maxima of the mean over f, by numpy from the CSV of sweep
  };
  for (const Skin& skin :
       {Skin{"elaphe_65um.png", 0, -45, -10, {1029.1, 1184.3, 1136.0, 1072.4, 943.5}},
        Skin{"xenopeltis_65um.png", 90, -50, -25, {1554.9, 1516.4, 1441.5, 1382.9, 1349.4}}}) {
    CAPTURE(skin.file);
    const evaluation::HeightFile scan = read_scan(*folder, skin.file);
    const brdf::Surface surface{&scan.field, brdf::GaussianWindow(Length::um(sigma_um)),
                                brdf::SurfaceModel::isolated};
    const Angle phi = Angle::deg(skin.phi_i_deg);
    evaluation::SweepRequest request{Angle::deg(75), phi, phi, {}, {}};
    for (int nm = 380; nm <= 780; nm += 5) request.lambda_nm.values.push_back(nm);
    for (int i = 0; skin.first_deg + i * 0.05 <= skin.last_deg; ++i)
      request.theta_r_deg.values.push_back(skin.first_deg + i * 0.05);
    const auto plan =
        evaluation::method_named("chebyshev").plan(surface, bounds_of(request, 1e-6), {});
    const ResponseMatrix response = sweep(request, evaluation::Diffraction(*plan, {}), {});
    const Ridges found = find_ridges(response, plane, {});
    for (const double period_nm : skin.periods_nm) {
      INFO(period_nm << " nm");
      // One step of that program's axis, sigma_f / 6.
      CHECK(std::ranges::any_of(found.ridges, [&](const Ridge& ridge) {
        return ridge.order == 1 && std::abs(ridge.f_per_um - 1e3 / period_nm) <= sigma_f / 6;
      }));
    }
  }
}
