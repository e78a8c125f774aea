// Seeded random numbers, surfaces and directions, the same with every standard library.
#pragma once

#include <cstdint>
#include <random>

#include "brdf/directions.h"
#include "brdf/height_field.h"

/// Uniform numbers from the upper 53 bits of mt19937_64; the standard distributions differ between
/// libraries.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  double operator()(double lo, double hi) {
    const double unit = static_cast<double>(engine_() >> 11) * 0x1p-53;
    return lo + (hi - lo) * unit;
  }

 private:
  std::mt19937_64 engine_;
};

struct Grid {
  Eigen::Index rows, cols;
  double dx_um, dy_um;
};

inline brdf::HeightField random_heights(Uniform& uniform, const Grid& grid, double lo_um,
                                        double hi_um) {
  brdf::HeightArray heights_um(grid.rows, grid.cols);
  for (double& height : heights_um.reshaped<Eigen::RowMajor>()) height = uniform(lo_um, hi_um);
  return brdf::HeightField(std::move(heights_um), brdf::Length::um(grid.dx_um),
                           brdf::Length::um(grid.dy_um));
}

/// Any direction up to a polar angle; out of every plane.
inline brdf::Direction random_direction(Uniform& uniform, double max_theta_deg = 89) {
  const double theta_deg = uniform(-max_theta_deg, max_theta_deg);
  const double phi_deg = uniform(0, 360);
  return brdf::direction(brdf::Angle::deg(theta_deg), brdf::Angle::deg(phi_deg));
}
