// Where the orders of strictly periodic surfaces lie, by every method that is exact for its model.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "brdf/direct_sum.h"
#include "brdf/grating_equation.h"
#include "brdf/synthetic_surface.h"
#include "evaluation/diffraction.h"
#include "evaluation/sweep.h"
#include "tests/support/amplitudes.h"
#include "tests/support/surfaces.h"

namespace {

using brdf::Angle;
using brdf::Facing;
using brdf::HeightField;
using brdf::Length;
using brdf::Profile;
using brdf::SurfaceModel;

constexpr double step_deg = 0.05, period_um = 2.5;
constexpr Eigen::Index periods = 80, pixels_of_period = 25;

struct Case {
  const char* method;
  SurfaceModel model;
};

/// Lobes so narrow that the slope of an order's efficiency across them moves no top by a step: a
/// window of an eighth of the patch, or the whole patch evenly lit.
brdf::Surface lit(const HeightField& field, SurfaceModel model) {
  return {&field,
          brdf::GaussianWindow(Length::um(field.width_um() / 8)),
          model,
          brdf::Origin::patch_centre,
          {2, 1}};
}

evaluation::SweepRequest request(Angle theta_i) {
  evaluation::SweepRequest request{theta_i, {}, {}, {{450, 550, 700}}, {}};
  for (int i = 0; i <= 2800; ++i) request.theta_r_deg.values.push_back(-70 + step_deg * i);
  return request;
}

/// Power of an order of the sampled profile: one period, alone and evenly lit.
double order_power(const brdf::ProfileParameters& profile, int order, double c_per_um) {
  const HeightField tile = one_period(profile, pixels_of_period);
  return std::norm(amplitude(brdf::DirectSum{},
                             {&tile, brdf::GaussianWindow(Length::um(1)), SurfaceModel::replicated},
                             order_query(order, period_um, std::abs(c_per_um))));
}

/// Brightest angle within half an order of where the order lies.
double brightest_deg(const evaluation::ResponseMatrix& response, Eigen::Index row, int order,
                     Angle theta_i, Length wavelength) {
  double best = -1, angle = std::nan("");
  for (std::size_t j = 0; j < response.theta_r_deg.size(); ++j) {
    const double u = std::sin(theta_i.rad()) + std::sin(Angle::deg(response.theta_r_deg[j]).rad());
    if (!(std::abs(u * period_um / wavelength.um() - order) < 0.5)) continue;
    const double value = response.values(row, static_cast<Eigen::Index>(j));
    if (value > best) std::tie(best, angle) = std::pair(value, response.theta_r_deg[j]);
  }
  return angle;
}

}  // namespace

TEST_CASE("the orders of every profile lie where the grating equation puts them",
          "[oracle][grating_equation][long]") {
  const auto [method, model] =
      GENERATE(Case{"direct", SurfaceModel::isolated}, Case{"direct", SurfaceModel::periodic},
               Case{"direct", SurfaceModel::replicated}, Case{"chebyshev", SurfaceModel::isolated},
               Case{"chebyshev", SurfaceModel::periodic},
               Case{"chebyshev", SurfaceModel::replicated}, Case{"auto", SurfaceModel::isolated},
               Case{"taylor", SurfaceModel::periodic}, Case{"pq", SurfaceModel::replicated});
  CAPTURE(method, evaluation::name_of(model));
  int orders = 0;
  for (const brdf::ProfileParameters& profile :
       {brdf::ProfileParameters{Profile::sinusoid, Length::um(period_um), Length::nm(300)},
        {Profile::blazed, Length::um(period_um), Length::nm(200)},
        {Profile::blazed, Length::um(period_um), Length::nm(200), 0.5, Facing::minus_x},
        {Profile::lamellar, Length::um(period_um), Length::nm(120), 0.36},
        {Profile::triangle, Length::um(period_um), Length::nm(400)}}) {
    const HeightField field =
        brdf::synthetic_grating(profile, 1, periods * pixels_of_period,
                                Length::um(period_um / pixels_of_period), Length::um(1));
    const brdf::Surface surface = lit(field, model);
    for (const Angle theta_i : {Angle::deg(0), Angle::deg(30)}) {
      const auto asked = request(theta_i);
      const auto plan = evaluation::method_named(method).plan(surface, bounds_of(asked, 1e-6), {});
      const evaluation::Diffraction power(*plan, {brdf::Quantity::power});
      const auto response = sweep(asked, power, {2, {}});
      for (std::size_t row = 0; row < asked.lambda_nm.size(); ++row)
        for (int order = -6; order <= 6; ++order) {
          const Length wavelength = asked.wavelength(row);
          const auto expected =
              brdf::viewing_angle(order, Length::um(period_um), wavelength, theta_i);
          if (!expected || std::abs(expected->deg()) > 65) continue;
          const double c_per_um = query_in_plane(theta_i, *expected, wavelength).c_per_um;
          if (!(order_power(profile, order, c_per_um) > 1e-3)) continue;
          ++orders;
          const double found =
              brightest_deg(response, static_cast<Eigen::Index>(row), order, theta_i, wavelength);
          CAPTURE(static_cast<int>(profile.profile), theta_i.deg(), wavelength.nm(), order, found,
                  expected->deg());
          CHECK(std::abs(found - expected->deg()) <= step_deg);
        }
    }
  }
  CHECK(orders >= 80);
}
