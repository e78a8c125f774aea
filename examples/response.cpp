// From a height field to the period of its grating, as a program of your own.
#include <cstdio>

#include "brdf/synthetic_surface.h"
#include "evaluation/diffraction.h"
#include "evaluation/period_fit.h"
#include "evaluation/sweep.h"

int main() {
  using brdf::Angle;
  using brdf::Length;

  const brdf::HeightField field =
      brdf::synthetic_grating({brdf::Profile::blazed, Length::nm(2500), Length::nm(600)}, 64, 650,
                              Length::nm(100), Length::um(1));
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(16)),
                              brdf::SurfaceModel::periodic};

  evaluation::SweepRequest request{Angle::deg(75), Angle::deg(0), Angle::deg(0), {}, {}};
  for (int nm = 380; nm <= 780; nm += 5) request.lambda_nm.values.push_back(nm);
  for (int i = -550; i <= -400; ++i) request.theta_r_deg.values.push_back(i / 10.0);

  const evaluation::Method& taylor = evaluation::method_named("taylor");
  const auto plan = taylor.plan(surface, bounds_of(request, 1e-6), {});
  const evaluation::ResponseMatrix response =
      sweep(request, evaluation::Diffraction(*plan, {}), {});

  evaluation::PlaneOfIncidence plane =
      evaluation::plane_of_incidence(request.theta_i, request.phi_i, request.phi_r);
  plane.sigma_f_per_um = surface.window.sigma_f_per_um();
  evaluation::PeakSearch search;
  search.period_guess = Length::um(2.5);
  const evaluation::PeriodFit fit =
      fit_period(find_peaks(response, plane, search), plane, search.order, 0);

  std::printf("amplitude error at most %.1e\n", plan->report().error_bound);
  std::printf("period %.2f nm, standard error of the fit %.2f nm\n", fit.period_nm,
              fit.std_error_nm);
}
