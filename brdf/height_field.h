// A sampled surface h(x, y) on a rectangular grid.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "brdf/error.h"
#include "brdf/units.h"

namespace brdf {

using HeightArray = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Heights [um] at the centres of the pixels: rows x columns as stored in the file, x along the
/// columns, y along the rows with the row index. Pixels need not be square.
class HeightField {
 public:
  /// heights_um: at least 1 x 1, all finite. pixel_x, pixel_y: > 0, finite.
  /// height_step: spacing of the codes that the heights were stored in, 0 if not known.
  /// Throws Errc::bad_input naming the first height that is not finite, and
  /// Errc::invalid_argument for a pixel that is not positive.
  HeightField(HeightArray heights_um, Length pixel_x, Length pixel_y, Length height_step = {})
      : heights_um_(std::move(heights_um)),
        dx_um_(pixel_x.um()),
        dy_um_(pixel_y.um()),
        height_step_um_(height_step.um()) {
    if (heights_um_.size() == 0) throw Error(Errc::bad_input, "height field has no pixels");
    for (const double pixel : {dx_um_, dy_um_})
      if (!(pixel > 0 && std::isfinite(pixel)))
        throw Error(Errc::invalid_argument, "pixel " + text(pixel) + " um must be > 0 and finite");
    require_finite();
  }

  Eigen::Index rows() const { return heights_um_.rows(); }
  Eigen::Index cols() const { return heights_um_.cols(); }
  double dx_um() const { return dx_um_; }
  double dy_um() const { return dy_um_; }
  double width_um() const { return dx_um_ * static_cast<double>(cols()); }
  double height_um() const { return dy_um_ * static_cast<double>(rows()); }
  double height_step_um() const { return height_step_um_; }
  const HeightArray& heights_um() const { return heights_um_; }

  /// Middle of the range of heights, (max + min) / 2 [um].
  double mid_range_um() const { return std::midpoint(min_um_, max_um_); }
  /// Half of the range of heights, (max - min) / 2 [um].
  double half_range_um() const { return (max_um_ - min_um_) / 2; }
  double min_um() const { return min_um_; }
  double max_um() const { return max_um_; }

 private:
  void require_finite() {
    for (Eigen::Index row = 0; row < rows(); ++row)
      for (Eigen::Index col = 0; col < cols(); ++col)
        if (!std::isfinite(heights_um_(row, col)))
          throw Error(Errc::bad_input, "height at row " + std::to_string(row) + ", column " +
                                           std::to_string(col) + " is " +
                                           text(heights_um_(row, col)) + ", must be finite");
    min_um_ = heights_um_.minCoeff();
    max_um_ = heights_um_.maxCoeff();
  }

  HeightArray heights_um_;
  double dx_um_, dy_um_, height_step_um_;
  double min_um_ = 0, max_um_ = 0;
};

}  // namespace brdf
