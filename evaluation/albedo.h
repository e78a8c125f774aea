// How much of the light a surface sends back, by the scalar theory.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "evaluation/diffraction.h"
#include "evaluation/sweep.h"

namespace evaluation {

/// Directional albedo: the integral of f_r cos theta_r over the hemisphere of viewing directions.
struct DirectionalAlbedo {
  double value;
  /// Largest effect of the amplitude's own error e: by Cauchy and Schwarz
  /// 2 sqrt(albedo E) + E, E the albedo that e alone would have.
  double error_bound;
  std::size_t directions;  ///< nodes of the quadrature

  /// A surface sends back no more than it gets. What lies above 1 by more than this, a thousandth,
  /// is outside the scalar theory: its obliquity factor is not that of a wave that conserves
  /// energy, and a flat patch itself has 1.001 at 75 deg.
  static constexpr double physical_excess = 1e-3;
  bool is_physical() const { return value <= 1 + physical_excess; }
};

/// The viewing directions of an albedo and their weights, at one wavelength, for any light.
///
/// With r = sin theta_r the integrand is a band-limited function of the place on the disk: under
/// the window it holds no lag beyond the patch, nor beyond where the window's own correlation
/// exp(-x^2 / (4 sigma_s^2)) has fallen to 1e-9. A Gauss-Legendre rule in theta_r and even steps in
/// phi_r that resolve that lag are exact to about 1e-9, measured against the closed forms and
/// against more nodes in albedo.tests.cpp; the rim is no singularity in theta_r. Cost: about
/// (k D)^2 / 4 amplitudes, D the largest lag.
class AlbedoQuadrature {
 public:
  /// Throws Errc::over_limit for more nodes than 1e9: many copies, or a wide window.
  AlbedoQuadrature(const brdf::Surface& surface, brdf::Length wavelength);

  std::size_t directions() const;
  /// The box of all queries of one albedo for each light, with their number: one plan serves all.
  brdf::QueryBounds bounds(std::span<const brdf::Direction> lights, double tolerance) const;
  /// Throws Errc::over_limit past the time limit. The value is the same for any number of threads.
  DirectionalAlbedo integrate(const brdf::Direction& omega_i, const Amplitude& amplitude,
                              const Optics& optics, const RunLimits& limits) const;

 private:
  struct Ring {
    double theta_rad, weight;
    std::size_t count;  ///< of azimuths
  };

  brdf::Length wavelength_;
  std::vector<Ring> rings_;
};

}  // namespace evaluation
