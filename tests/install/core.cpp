// The header-only core alone: the Taylor series and the direct sum agree on a small grating.
#include <complex>
#include <cstdio>
#include <span>

#include "brdf/direct_sum.h"
#include "brdf/synthetic_surface.h"
#include "brdf/taylor_series.h"

int main() {
  const brdf::HeightField heights =
      brdf::synthetic_grating({.profile = brdf::Profile::blazed,
                               .period = brdf::Length::nm(2500),
                               .height = brdf::Length::nm(300)},
                              20, 100, brdf::Length::nm(100), brdf::Length::nm(500));
  const brdf::Surface surface{&heights, brdf::GaussianWindow(brdf::Length::um(2.5)),
                              brdf::SurfaceModel::periodic};
  // k u of order 1, at a phase depth of 3 rad.
  const brdf::Query query[] = {{-2 * brdf::pi / 2.5, 0, -10}};
  const double tolerance = 1e-9;
  const brdf::QueryBounds bounds = brdf::bounds_of(query, tolerance);

  std::complex<double> taylor[1], direct[1];
  brdf::TaylorSeries().plan(surface, bounds).evaluate(query, taylor);
  brdf::DirectSum().plan(surface, bounds).evaluate(query, direct);

  const double error = std::abs(taylor[0] - direct[0]);
  std::printf("|a| = %.12f by the direct sum, Taylor differs by %.1e\n", std::abs(direct[0]),
              error);
  const bool pass = error <= tolerance && std::abs(direct[0]) > 0.01;
  return pass ? 0 : 1;
}
