// Any directions and wavelengths in batches: a plan is made once and asked from many threads.
#include <algorithm>
#include <complex>
#include <cstdio>
#include <numbers>
#include <span>
#include <thread>
#include <vector>

#include "brdf/chebyshev_series.h"
#include "brdf/direct_sum.h"
#include "brdf/directions.h"
#include "brdf/synthetic_profile.h"

int main() {
  using brdf::Angle;
  using brdf::Length;

  // A blazed grating of period 2.5 um and depth 0.6 um, lit coherently over sigma = 4 um.
  const brdf::HeightField field =
      brdf::synthetic_grating({brdf::Profile::blazed, Length::nm(2500), Length::nm(600)}, 128, 128,
                              Length::nm(100), Length::um(1));
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(4)),
                              brdf::SurfaceModel::isolated};

  // Each pair of directions and wavelength is one query: k times the scattering vector.
  std::vector<brdf::Query> queries;
  for (int i = 0; i < 100'000; ++i) {
    const double turn = i * std::numbers::phi;  // spreads evenly over angles and colours
    const brdf::Direction omega_i = direction(Angle::deg(60), Angle::deg(360 * turn));
    const brdf::Direction omega_r = direction(Angle::deg(i % 80), Angle::deg(360 * turn * turn));
    const Length wavelength = Length::nm(380 + i % 401);
    const Eigen::Vector3d q =
        brdf::wavenumber_per_um(wavelength) * brdf::scattering_vector(omega_i, omega_r);
    queries.push_back({q.x(), q.y(), q.z()});
  }

  // The plan holds for all queries within these bounds, with an error of at most 1e-6 where the
  // flat patch's peak is 1. evaluate() is const: threads need no lock.
  const brdf::QueryBounds bounds = bounds_of(queries, 1e-6);
  const brdf::ChebyshevSeriesPlan plan = brdf::ChebyshevSeries{}.plan(surface, bounds);
  std::vector<std::complex<double>> amplitudes(queries.size());
  const auto evaluate_part = [&](std::size_t first, std::size_t count) {
    plan.evaluate(std::span(queries).subspan(first, count),
                  std::span(amplitudes).subspan(first, count));
  };
  {
    const std::size_t half = queries.size() / 2;
    std::jthread one(evaluate_part, 0, half), two(evaluate_part, half, queries.size() - half);
  }  // both have ended here

  // A few of them pixel by pixel.
  const brdf::DirectSumPlan exact = brdf::DirectSum{}.plan(surface, bounds);
  double largest = 0;
  for (std::size_t i = 0; i < queries.size(); i += 997) {
    std::complex<double> a;
    exact.evaluate(std::span(&queries[i], 1), std::span(&a, 1));
    largest = std::max(largest, std::abs(amplitudes[i] - a));
  }
  std::printf("%zu amplitudes from %d terms; largest difference to the direct sum %.1e\n",
              amplitudes.size(), plan.report().terms, largest);
  return largest <= bounds.tolerance ? 0 : 1;
}
