// Small surfaces for the tests.
#pragma once

#include "brdf/surface.h"
#include "brdf/synthetic_surface.h"

/// The heights of a function h(x, y), origin in the middle of the pixel centres.
template <class Function>
brdf::HeightField sampled(Eigen::Index rows, Eigen::Index cols, double dx_um, double dy_um,
                          Function height_um) {
  brdf::HeightArray heights_um(rows, cols);
  for (Eigen::Index row = 0; row < rows; ++row)
    for (Eigen::Index col = 0; col < cols; ++col)
      heights_um(row, col) =
          height_um((static_cast<double>(col) - static_cast<double>(cols - 1) / 2) * dx_um,
                    (static_cast<double>(row) - static_cast<double>(rows - 1) / 2) * dy_um);
  return brdf::HeightField(std::move(heights_um), brdf::Length::um(dx_um), brdf::Length::um(dy_um));
}

/// One period of a profile in one row of n samples, the first at phase 0.
inline brdf::HeightField one_period(const brdf::ProfileParameters& profile, Eigen::Index n) {
  const double dx_um = profile.period.um() / static_cast<double>(n);
  brdf::HeightArray heights_um(1, n);
  for (Eigen::Index j = 0; j < n; ++j)
    heights_um(0, j) =
        profile.height.um() *
        brdf::profile_height(profile, static_cast<double>(j) / static_cast<double>(n));
  return brdf::HeightField(std::move(heights_um), brdf::Length::um(dx_um), brdf::Length::um(1));
}

/// A periodic surface under a window so wide against its length in x that its lines do not touch:
/// with sigma twice the length, the next line weighs exp(-(2 pi 2)^2 / 2) = 5e-35.
inline brdf::Surface separate_lines(const brdf::HeightField& field) {
  return {&field, brdf::GaussianWindow(brdf::Length::um(2 * field.width_um())),
          brdf::SurfaceModel::periodic};
}
