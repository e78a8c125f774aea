// The cells of a response that lie on the ridges of a grating's orders.
#pragma once

#include <optional>
#include <vector>

#include "evaluation/diffraction.h"
#include "evaluation/period/window_lobe.h"
#include "evaluation/response_matrix.h"

namespace evaluation {

/// What is known of the profile.
enum class Relief {
  may_have_edges,  ///< steps, whose places are rounded to pixels
  smooth,          ///< nothing narrower than some pixels
};

/// How a response came about.
struct JointScene {
  brdf::Angle theta_i, phi_i, phi_r;
  Optics optics;
  DepthFrequency depth = DepthFrequency::scattering_vector;
  brdf::SurfaceModel model = brdf::SurfaceModel::isolated;
  brdf::GaussianWindow window;
  brdf::SurfaceAxis x, y;  ///< of the patch, as of `brdf::x_axis`
  double floor = 0;  ///< largest value that the response's own error makes where nothing shines
  Relief relief = Relief::may_have_edges;
};

/// A response as power over frequency: row by row, in the order of the wavelengths.
///
/// q = k (sin theta_i + sin theta_r), m K at the order m, positive towards the light; c = k w.
class PowerView {
 public:
  /// Keeps at most max_rows wavelengths, spread evenly. Throws Errc::invalid_argument for a viewer
  /// outside the plane of incidence, Errc::bad_input for a value that is not finite.
  PowerView(const ResponseMatrix& response, const JointScene& scene, Eigen::Index max_rows);

  Eigen::Index rows() const { return power_.rows(); }
  Eigen::Index cols() const { return power_.cols(); }
  double lambda_nm(Eigen::Index row) const { return lambda_nm_[static_cast<std::size_t>(row)]; }
  double q_per_um(Eigen::Index row, Eigen::Index col) const { return q_per_um_(row, col); }
  double c_per_um(Eigen::Index row, Eigen::Index col) const { return c_per_um_(row, col); }
  double power(Eigen::Index row, Eigen::Index col) const { return power_(row, col); }
  /// The power that the response's floor amounts to; NaN where the gain is 0: such a cell says
  /// nothing.
  double floor(Eigen::Index row, Eigen::Index col) const { return floor_(row, col); }
  double lowest_q_per_um(Eigen::Index row) const { return q_per_um_.row(row).minCoeff(); }
  double highest_q_per_um(Eigen::Index row) const { return q_per_um_.row(row).maxCoeff(); }

 private:
  std::vector<double> lambda_nm_;
  brdf::HeightArray q_per_um_, c_per_um_, power_, floor_;
};

/// The cells around one order, a row of the view after the other.
struct OrderCells {
  int order;
  Eigen::ArrayXd q_per_um, c_per_um, power;
  std::vector<Eigen::Index> row;  ///< of each cell, in the view
  double c_low_per_um, c_high_per_um;
  double peak, floor;  ///< the largest power, and that of the response's floor there
  double middle;       ///< the largest power within half a half-width of the lobe

  Eigen::Index size() const { return power.size(); }
  std::size_t row_count() const;
};

/// The cells within half_width of each order but 0, in the rows that hold all of that stretch and
/// rise above the floor there. Left out are orders with fewer than 3 such rows, and those that what
/// leaks into them could make: in their middle no brighter than 4 times sum_m P_m of the other
/// orders' lobes there, sidelobes or core (amplitudes may add; the brightest of all is kept).
///
/// More than 15 cells a row are thinned evenly: five to a half-width of the lobe determine it.
std::vector<OrderCells> cells_of_orders(const PowerView& view, const WindowLobe& lobe,
                                        double k_grating_per_um, double half_width_per_um);

}  // namespace evaluation
