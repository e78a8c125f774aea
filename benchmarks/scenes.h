// The scenes that are timed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "brdf/amplitude.h"
#include "brdf/directions.h"
#include "brdf/synthetic_surface.h"

namespace benchmarks {

/// The sources' sampling: 65 um under a window of 4 sigma_s = 65 um.
inline constexpr double patch_um = 65;

/// A blazed grating of 2.5 um period over 65 um.
inline brdf::HeightField blazed(Eigen::Index pixels, brdf::Length depth = brdf::Length::nm(150),
                                double side_um = patch_um) {
  const brdf::Length pixel = brdf::Length::um(side_um / static_cast<double>(pixels));
  return brdf::synthetic_grating(
      {.profile = brdf::Profile::blazed, .period = brdf::Length::um(2.5), .height = depth}, pixels,
      pixels, pixel, pixel);
}

inline brdf::Surface lit(const brdf::HeightField& field, brdf::SurfaceModel model) {
  return {&field, brdf::GaussianWindow(brdf::Length::um(field.width_um() / 4)), model};
}

/// theta_i = 75 deg, 361 angles theta_r = -55 (0.1) -19 deg, 401 wavelengths 380 (1) 780 nm, angle
/// by angle. The range holds orders of the 2.5 um grating from 1 to 4.
inline std::vector<brdf::Query> in_plane_sweep() {
  std::vector<brdf::Query> queries;
  const brdf::Direction omega_i = brdf::direction(brdf::Angle::deg(75), {});
  for (int angle = 0; angle <= 360; ++angle) {
    const auto omega_r = brdf::direction(brdf::Angle::deg(-55 + 0.1 * angle), {});
    const Eigen::Vector3d uvw = brdf::scattering_vector(omega_i, omega_r);
    for (int nm = 380; nm <= 780; ++nm) {
      const Eigen::Vector3d q = brdf::wavenumber_per_um(brdf::Length::nm(nm)) * uvw;
      queries.push_back({q.x(), q.y(), q.z()});
    }
  }
  return queries;
}

/// Random (theta_i, phi_i, theta_r, phi_r, lambda): polar angles up to 89 deg, all azimuths, 380 to
/// 780 nm, each uniform.
inline std::vector<brdf::Query> random_directions(std::size_t count, std::uint64_t seed = 7) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  const auto direction = [&] {
    const double theta_deg = uniform(0, 89), phi_deg = uniform(0, 360);
    return brdf::direction(brdf::Angle::deg(theta_deg), brdf::Angle::deg(phi_deg));
  };
  std::vector<brdf::Query> queries;
  for (std::size_t i = 0; i < count; ++i) {
    const brdf::Direction omega_i = direction(), omega_r = direction();
    const Eigen::Vector3d q = brdf::wavenumber_per_um(brdf::Length::nm(uniform(380, 780))) *
                              brdf::scattering_vector(omega_i, omega_r);
    queries.push_back({q.x(), q.y(), q.z()});
  }
  return queries;
}

}  // namespace benchmarks
