// What is taken off a scan before it is used: a constant, a plane, fine detail.
#pragma once

#include <string>

#include "brdf/height_field.h"

namespace brdf {

/// What is subtracted from the heights.
enum class Level {
  none,
  mean,   ///< the mean height
  plane,  ///< the least-squares plane a + b x + c y
};

/// The slopes (dh/dx, dh/dy) of the least-squares plane through a height field.
///
/// On a full rectangular grid the centred coordinates are orthogonal, so each slope is a
/// one-dimensional regression: b = sum (x - x0) h / sum (x - x0)^2. An axis with one pixel has
/// slope 0.
inline Eigen::Vector2d plane_slopes(const HeightField& field) {
  const auto slope = [](const Eigen::ArrayXd& profile, double pixel_um) {
    const Eigen::Index count = profile.size();
    if (count < 2) return 0.0;
    const double half = static_cast<double>(count - 1) / 2;
    const Eigen::ArrayXd position = pixel_um * Eigen::ArrayXd::LinSpaced(count, -half, half);
    return (position * (profile - profile.mean())).sum() / position.square().sum();
  };
  const Eigen::ArrayXd along_x = field.heights_um().colwise().mean().transpose();
  const Eigen::ArrayXd along_y = field.heights_um().rowwise().mean();
  return {slope(along_x, field.dx_um()), slope(along_y, field.dy_um())};
}

/// The height field less its mean or its least-squares plane. Cost: two passes over the pixels.
inline HeightField levelled(const HeightField& field, Level level) {
  if (level == Level::none) return field;
  HeightArray heights_um = field.heights_um() - field.heights_um().mean();
  if (level == Level::plane) {
    const Eigen::Vector2d slopes = plane_slopes(field);
    const double half_cols = static_cast<double>(field.cols() - 1) / 2;
    const double half_rows = static_cast<double>(field.rows() - 1) / 2;
    for (Eigen::Index row = 0; row < field.rows(); ++row)
      for (Eigen::Index col = 0; col < field.cols(); ++col)
        heights_um(row, col) -=
            slopes.x() * field.dx_um() * (static_cast<double>(col) - half_cols) +
            slopes.y() * field.dy_um() * (static_cast<double>(row) - half_rows);
  }
  return HeightField(std::move(heights_um), Length::um(field.dx_um()), Length::um(field.dy_um()),
                     Length::um(field.height_step_um()));
}

/// The means over factor x factor blocks of pixels; the pixel grows by the factor.
///
/// Throws Errc::invalid_argument where the factor is below 1 or does not divide both sides.
inline HeightField reduced(const HeightField& field, int factor) {
  if (factor < 1 || field.rows() % factor != 0 || field.cols() % factor != 0)
    throw Error(Errc::invalid_argument, "reduction " + std::to_string(factor) +
                                            " must be >= 1 and divide both sides of the " +
                                            std::to_string(field.cols()) + " x " +
                                            std::to_string(field.rows()) + " pixels");
  if (factor == 1) return field;
  HeightArray heights_um(field.rows() / factor, field.cols() / factor);
  for (Eigen::Index row = 0; row < heights_um.rows(); ++row)
    for (Eigen::Index col = 0; col < heights_um.cols(); ++col)
      heights_um(row, col) =
          field.heights_um().block(row * factor, col * factor, factor, factor).mean();
  return HeightField(std::move(heights_um), Length::um(field.dx_um() * factor),
                     Length::um(field.dy_um() * factor), Length::um(field.height_step_um()));
}

}  // namespace brdf
