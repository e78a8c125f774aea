// What the surface does to a wave, pixel by pixel: its heights, or the phase that light takes.
#pragma once

#include <cmath>

#include "brdf/height_field.h"

namespace evaluation {

/// What a phase is counted from.
enum class PhaseOrigin {
  patch,        ///< the middle of the patch
  mirror_lobe,  ///< order 0 at the same place: a tilt or a bow, which turns all orders alike, drops
                ///< out
};

/// A complex field over the pixels of a patch; positions as in HeightField, from its middle.
struct SurfaceWave {
  brdf::HeightArray real, imaginary;  ///< rows x columns
  double dx_um, dy_um;
  PhaseOrigin phase_origin = PhaseOrigin::patch;

  Eigen::Index rows() const { return real.rows(); }
  Eigen::Index cols() const { return real.cols(); }
  double width_um() const { return dx_um * static_cast<double>(cols()); }
  double height_um() const { return dy_um * static_cast<double>(rows()); }
  double x_um(Eigen::Index col) const {
    return dx_um * (static_cast<double>(col) - static_cast<double>(cols() - 1) / 2);
  }
  double y_um(Eigen::Index row) const {
    return dy_um * (static_cast<double>(row) - static_cast<double>(rows() - 1) / 2);
  }
  /// Whether nothing changes along y, to the rounding of single precision, in which files hold
  /// heights.
  bool is_even_along_y() const {
    const auto even = [](const brdf::HeightArray& part) {
      const double range = part.maxCoeff() - part.minCoeff();
      return (part.rowwise() - part.row(0)).abs().maxCoeff() <= 1e-6 * range;
    };
    return rows() == 1 || (even(real) && even(imaginary));
  }
};

/// The heights [um] themselves.
inline SurfaceWave height_wave(const brdf::HeightField& field) {
  return {field.heights_um(), brdf::HeightArray::Zero(field.rows(), field.cols()), field.dx_um(),
          field.dy_um(), PhaseOrigin::patch};
}

/// exp(i c (h - h_mid)) (Thesis 1.12), c = k w [rad/um].
inline SurfaceWave light_wave(const brdf::HeightField& field, double c_per_um) {
  const brdf::HeightArray phase_rad = c_per_um * (field.heights_um() - field.mid_range_um());
  return {phase_rad.cos(), phase_rad.sin(), field.dx_um(), field.dy_um(), PhaseOrigin::mirror_lobe};
}

/// Rows first to first + count - 1.
inline SurfaceWave rows_of(const SurfaceWave& wave, Eigen::Index first, Eigen::Index count) {
  return {wave.real.middleRows(first, count), wave.imaginary.middleRows(first, count), wave.dx_um,
          wave.dy_um, wave.phase_origin};
}

inline SurfaceWave columns_of(const SurfaceWave& wave, Eigen::Index first, Eigen::Index count) {
  return {wave.real.middleCols(first, count), wave.imaginary.middleCols(first, count), wave.dx_um,
          wave.dy_um, wave.phase_origin};
}

}  // namespace evaluation
