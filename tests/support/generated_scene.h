// Small surfaces, directions and wavelengths for properties.
#pragma once

#include <rapidcheck.h>

#include "brdf/surface.h"
#include "tests/support/amplitudes.h"

/// A patch of up to 6 x 6 pixels with all that a query of it needs.
struct GeneratedScene {
  brdf::HeightArray heights_um;
  double dx_um, dy_um, sigma_um;
  brdf::Direction omega_i, omega_r;
  double lambda_um;

  brdf::HeightField field() const {
    return brdf::HeightField(heights_um, brdf::Length::um(dx_um), brdf::Length::um(dy_um));
  }
  brdf::Query query() const { return brdf::query(omega_i, omega_r, brdf::Length::um(lambda_um)); }
  /// Largest phase of a pixel [rad]: the amplitude is right to a few roundings of it.
  double largest_phase_rad() const {
    const brdf::Query q = query();
    const double far_um = dx_um * static_cast<double>(heights_um.cols()) +
                          dy_um * static_cast<double>(heights_um.rows());
    return 1 + std::abs(q.c_per_um) * heights_um.abs().maxCoeff() +
           std::hypot(q.qx_per_um, q.qy_per_um) * far_um;
  }
};

inline void showValue(const GeneratedScene& scene, std::ostream& out) {
  out << "heights_um\n"
      << scene.heights_um << "\npixel " << scene.dx_um << ", " << scene.dy_um << " um, sigma "
      << scene.sigma_um << " um, omega_i " << scene.omega_i.transpose() << ", omega_r "
      << scene.omega_r.transpose() << ", lambda " << scene.lambda_um << " um";
}

/// A number in [lo, hi] on a grid of 10^6 steps, so that a case shrinks towards lo.
inline rc::Gen<double> number_between(double lo, double hi) {
  constexpr int steps = 1000000;
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, steps + 1)),
                      [=](int step) { return lo + (hi - lo) * step / steps; });
}

/// Angles up to 85 degrees: the surface is seen from above.
inline rc::Gen<brdf::Direction> any_direction() {
  return rc::gen::map(rc::gen::pair(number_between(-85, 85), number_between(0, 360)),
                      [](const std::pair<double, double>& deg) {
                        return brdf::direction(brdf::Angle::deg(deg.first),
                                               brdf::Angle::deg(deg.second));
                      });
}

inline GeneratedScene any_scene() {
  const auto side = rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Eigen::Index>(1, 7));
  GeneratedScene scene;
  scene.heights_um.resize(*side, *side);
  for (double& height : scene.heights_um.reshaped()) height = *number_between(-1, 1);
  scene.dx_um = *number_between(0.05, 1);
  scene.dy_um = *number_between(0.05, 1);
  scene.sigma_um = *number_between(0.2, 5);
  scene.omega_i = *any_direction();
  scene.omega_r = *any_direction();
  scene.lambda_um = *number_between(0.38, 0.78);
  return scene;
}
