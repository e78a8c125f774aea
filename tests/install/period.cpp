// The compiled part: a small sweep of a blazed grating, its peaks and the fitted period.
#include <cmath>
#include <cstdio>

#include "brdf/surface.h"
#include "brdf/synthetic_surface.h"
#include "evaluation/diffraction.h"
#include "evaluation/methods.h"
#include "evaluation/period_fit.h"
#include "evaluation/sweep.h"

int main() {
  const double period_nm = 2500;
  const brdf::HeightField heights =
      brdf::synthetic_grating({.profile = brdf::Profile::blazed,
                               .period = brdf::Length::nm(period_nm),
                               .height = brdf::Length::nm(600)},
                              4, 650, brdf::Length::nm(100), brdf::Length::um(16.25));
  const brdf::Surface surface{&heights, brdf::GaussianWindow(brdf::Length::um(16.25)),
                              brdf::SurfaceModel::periodic};

  evaluation::SweepRequest request{.theta_i = brdf::Angle::deg(75)};
  for (int i = 0; i <= 8; ++i) request.lambda_nm.values.push_back(380 + 50 * i);
  for (int i = 0; i <= 300; ++i) request.theta_r_deg.values.push_back(-55 + 0.05 * i);

  const auto plan =
      evaluation::method_named("taylor").plan(surface, evaluation::bounds_of(request, 1e-6), {});
  const evaluation::ResponseMatrix response =
      evaluation::sweep(request, evaluation::Diffraction(*plan, {}), {});
  const evaluation::PlaneOfIncidence plane =
      evaluation::plane_of_incidence(request.theta_i, request.phi_i, request.phi_r);
  const auto peaks = evaluation::find_peaks(
      response, plane, {.order = 1, .period_guess = brdf::Length::nm(period_nm)});
  const evaluation::PeriodFit fit = evaluation::fit_period(peaks, plane, 1, 0);

  std::printf("period made %g nm, fitted %.4f nm\n", period_nm, fit.period_nm);
  // The neighbouring orders under the lobe's wings move its top; 1 nm is what they move it by here.
  const bool pass =
      fit.status == evaluation::FitStatus::converged && std::abs(fit.period_nm - period_nm) <= 1;
  return pass ? 0 : 1;
}
