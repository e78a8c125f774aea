#include "evaluation/albedo.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "brdf/gauss_legendre.h"
#include "evaluation/parallel.h"

namespace evaluation {
namespace {

/// Where the correlation of the window, exp(-x^2 / (4 sigma^2)), is 1e-9.
constexpr double correlation_reach_sigma = 9.1;

/// Nodes beyond the highest frequency: Bessel functions of order X + 6 X^(1/3) + 12 are below 1e-9.
double with_margin(double frequency) {
  return frequency + 6 * std::cbrt(frequency) + 12;
}

constexpr double most_directions = 1e9;

double reach_um(const brdf::Surface& surface, const brdf::SurfaceAxis& axis) {
  const double window_um = correlation_reach_sigma * surface.window.sigma_um();
  const double surface_um =
      axis.length_um() * (1.0 + static_cast<double>(axis.last_copy - axis.first_copy));
  return surface.model == brdf::SurfaceModel::replicated ? surface_um
                                                         : std::min(surface_um, window_um);
}

brdf::Direction direction_at(double theta_rad, double phi_rad) {
  return brdf::direction(brdf::Angle::rad(theta_rad), brdf::Angle::rad(phi_rad));
}

/// Sums of a ring: of the albedo, and of that of an amplitude of 1.
struct RingSums {
  double albedo = 0, gain = 0;
};

}  // namespace

AlbedoQuadrature::AlbedoQuadrature(const brdf::Surface& surface, brdf::Length wavelength)
    : wavelength_(wavelength) {
  const double lag_um = std::hypot(reach_um(surface, brdf::x_axis(surface)),
                                   reach_um(surface, brdf::y_axis(surface))) +
                        2 * surface.heights->half_range_um();
  const double phase = brdf::wavenumber_per_um(wavelength) * lag_um;
  if (!(phase * phase / 4 <= most_directions))
    throw brdf::Error(brdf::Errc::over_limit,
                      "an albedo under " + brdf::text(lag_um) + " um of coherent surface needs " +
                          brdf::text(std::round(phase * phase / 4)) +
                          " directions, above 1e9; fewer copies or a smaller --sigma need less");
  // Over half of theta's interval, pi / 4, the phase turns by at most phase pi / 4; a rule of n
  // nodes is exact for degrees up to 2 n - 1.
  const int count = static_cast<int>(std::ceil(with_margin(phase * brdf::pi / 4) / 2));
  const brdf::QuadratureRule rule = brdf::gauss_legendre(count);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double theta_rad = rule.nodes[i] * brdf::pi / 2;
    const double azimuths = std::ceil(with_margin(phase * std::sin(theta_rad)));
    rings_.push_back(
        {theta_rad, rule.weights[i] * brdf::pi / 2 * std::sin(theta_rad) * 2 * brdf::pi / azimuths,
         static_cast<std::size_t>(azimuths)});
  }
}

std::size_t AlbedoQuadrature::directions() const {
  return std::transform_reduce(rings_.begin(), rings_.end(), std::size_t{0}, std::plus(),
                               [](const Ring& ring) { return ring.count; });
}

brdf::QueryBounds AlbedoQuadrature::bounds(std::span<const brdf::Direction> lights,
                                           double tolerance) const {
  const double k = brdf::wavenumber_per_um(wavelength_);
  std::vector<brdf::Query> of_light;  // without the viewer
  for (const brdf::Direction& omega_i : lights)
    of_light.push_back({-k * omega_i.x(), -k * omega_i.y(), -k * omega_i.z()});
  brdf::QueryBounds bounds = brdf::bounds_of(of_light, tolerance);
  const double reach = k * (1 + 1e-12);  // sines and cosines are rounded
  bounds.lo.qx_per_um -= reach;
  bounds.lo.qy_per_um -= reach;
  bounds.lo.c_per_um -= reach;
  bounds.hi.qx_per_um += reach;
  bounds.hi.qy_per_um += reach;
  bounds.count = lights.size() * directions();
  return bounds;
}

DirectionalAlbedo AlbedoQuadrature::integrate(const brdf::Direction& omega_i,
                                              const Amplitude& amplitude, const Optics& optics,
                                              const RunLimits& limits) const {
  std::vector<RingSums> sums(rings_.size());
  parallel_for(rings_.size(), limits.threads, [&](std::size_t i) {
    limits.check_time();
    const Ring& ring = rings_[i];
    std::vector<brdf::Direction> views;
    std::vector<brdf::Query> queries;
    for (std::size_t j = 0; j < ring.count; ++j) {
      const double turn = static_cast<double>(j) / static_cast<double>(ring.count);
      views.push_back(direction_at(ring.theta_rad, 2 * brdf::pi * turn));
      queries.push_back(brdf::query(omega_i, views.back(), wavelength_));
    }
    std::vector<std::complex<double>> amplitudes(ring.count);
    amplitude.evaluate(queries, amplitudes);
    for (std::size_t j = 0; j < ring.count; ++j) {
      const double factor =
          ring.weight * gain(optics, omega_i, views[j], wavelength_) * views[j].z();
      sums[i].albedo += factor * std::norm(amplitudes[j]);
      sums[i].gain += factor;
    }
  });
  // One ring after another: the same sum for any number of threads.
  RingSums all;
  for (const RingSums& ring : sums) {
    all.albedo += ring.albedo;
    all.gain += ring.gain;
  }
  const double error = amplitude.report().error_bound;
  const double of_error = error * error * all.gain;
  return {all.albedo, 2 * std::sqrt(all.albedo * of_error) + of_error, directions()};
}

}  // namespace evaluation
