// Any directions and wavelengths in batches: a plan is made once and asked from many threads.
#include <complex>
#include <cstdio>
#include <numbers>
#include <span>
#include <thread>
#include <vector>

#include "brdf/chebyshev_series.h"
#include "brdf/direct_sum.h"
#include "brdf/synthetic_surface.h"

int main() {
  using brdf::Angle;
  using brdf::Length;

  const brdf::HeightField field =
      brdf::synthetic_grating({brdf::Profile::blazed, Length::nm(2500), Length::nm(600)}, 128, 128,
                              Length::nm(100), Length::um(1));
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(4)),
                              brdf::SurfaceModel::isolated};

  std::vector<brdf::Query> queries;
  for (int i = 0; i < 100'000; ++i) {
    const Angle turned = Angle::deg(360 * i * std::numbers::phi);  // spreads evenly
    queries.push_back(brdf::query(direction(Angle::deg(60), Angle::deg(0)),
                                  direction(Angle::deg(i % 80), turned),
                                  Length::nm(380 + i % 401)));
  }

  // An error of at most 1e-6, the peak of a flat patch being 1. evaluate() needs no lock.
  const brdf::QueryBounds bounds = bounds_of(queries, 1e-6);
  const brdf::ChebyshevSeriesPlan plan = brdf::ChebyshevSeries{}.plan(surface, bounds);
  std::vector<std::complex<double>> amplitudes(queries.size());
  const auto evaluate_half = [&](std::size_t first) {
    plan.evaluate(std::span(queries).subspan(first, 50'000),
                  std::span(amplitudes).subspan(first, 50'000));
  };
  { std::jthread one(evaluate_half, 0), two(evaluate_half, 50'000); }  // both have ended here

  std::complex<double> exact;
  brdf::DirectSum{}.plan(surface, bounds).evaluate({&queries[997], 1}, {&exact, 1});
  const double error = std::abs(amplitudes[997] - exact);
  std::printf("%zu amplitudes from %d terms; one of them is off the direct sum by %.1e\n",
              amplitudes.size(), plan.report().terms, error);
  return error <= bounds.tolerance ? 0 : 1;
}
