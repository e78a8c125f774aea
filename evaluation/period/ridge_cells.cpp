#include "evaluation/period/ridge_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "brdf/error.h"
#include "evaluation/peaks.h"

namespace evaluation {
namespace {

constexpr Eigen::Index cells_of_row = 15;
constexpr std::size_t fewest_rows = 3;

/// Rows of a response by wavelength, at most max_rows of them.
std::vector<Eigen::Index> spread_rows(const ResponseMatrix& response, Eigen::Index max_rows) {
  std::vector<Eigen::Index> rows(response.lambda_nm.size());
  std::iota(rows.begin(), rows.end(), Eigen::Index{0});
  std::sort(rows.begin(), rows.end(), [&](Eigen::Index a, Eigen::Index b) {
    return response.lambda_nm[static_cast<std::size_t>(a)] <
           response.lambda_nm[static_cast<std::size_t>(b)];
  });
  const auto count = static_cast<Eigen::Index>(rows.size());
  if (count <= max_rows) return rows;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < max_rows; ++i)
    kept.push_back(rows[static_cast<std::size_t>(i * (count - 1) / (max_rows - 1))]);
  return kept;
}

struct RowCells {
  std::vector<Eigen::Index> cols;
  Eigen::Index brightest = -1;
};

/// The columns of a row around q; none where the row does not hold the stretch or it is dark.
RowCells cells_around(const PowerView& view, Eigen::Index row, double q_per_um,
                      double half_width_per_um) {
  RowCells found;
  if (!(view.lowest_q_per_um(row) <= q_per_um - half_width_per_um &&
        view.highest_q_per_um(row) >= q_per_um + half_width_per_um))
    return found;
  for (Eigen::Index col = 0; col < view.cols(); ++col) {
    if (!(std::abs(view.q_per_um(row, col) - q_per_um) <= half_width_per_um)) continue;
    if (!std::isfinite(view.floor(row, col))) return {};
    found.cols.push_back(col);
    if (found.brightest < 0 || view.power(row, col) > view.power(row, found.brightest))
      found.brightest = col;
  }
  if (found.cols.size() < 3 ||
      !(view.power(row, found.brightest) > view.floor(row, found.brightest)))
    return {};
  const auto count = static_cast<Eigen::Index>(found.cols.size());
  if (count <= cells_of_row) return found;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < cells_of_row; ++i)
    kept.push_back(found.cols[static_cast<std::size_t>(i * (count - 1) / (cells_of_row - 1))]);
  found.cols = std::move(kept);
  return found;
}

/// Largest power of the mirror's lobe.
double mirror_power(const PowerView& view, double half_width_per_um) {
  double largest = 0;
  for (Eigen::Index row = 0; row < view.rows(); ++row)
    for (Eigen::Index col = 0; col < view.cols(); ++col)
      if (std::abs(view.q_per_um(row, col)) <= half_width_per_um)
        largest = std::max(largest, view.power(row, col));
  return largest;
}

/// Leaves the orders that stand above what leaks into them.
void leave_standing(std::vector<OrderCells>& orders, const WindowLobe& lobe, double k,
                    double mirror) {
  constexpr double standing = 4;
  const auto leak = [&](double q_per_um) {
    const double side = lobe.edge_per_um() / q_per_um, core = lobe.core(q_per_um);
    return side * side + core * core;
  };
  std::vector<double> over(orders.size());
  for (std::size_t i = 0; i < orders.size(); ++i) {
    double leaked = mirror * leak(orders[i].order * k);
    for (const OrderCells& other : orders)
      if (other.order != orders[i].order)
        leaked += other.middle * leak((other.order - orders[i].order) * k);
    over[i] = orders[i].middle - standing * leaked;
  }
  const double best = over.empty() ? 0 : *std::max_element(over.begin(), over.end());
  std::size_t at = 0;
  std::erase_if(orders, [&](const OrderCells&) {
    const double above = over[at++];
    return !(above > 0 || above == best);
  });
}

}  // namespace

PowerView::PowerView(const ResponseMatrix& response, const JointScene& scene,
                     Eigen::Index max_rows) {
  plane_of_incidence(scene.theta_i, scene.phi_i, scene.phi_r);  // refuses any other
  const brdf::Direction omega_i = brdf::direction(scene.theta_i, scene.phi_i);
  // The light's azimuth also where the light stands above the patch.
  const brdf::Direction towards = brdf::direction(brdf::Angle::deg(45), scene.phi_i);
  const double length = std::hypot(towards.x(), towards.y());
  const std::vector<Eigen::Index> rows = spread_rows(response, max_rows);
  const auto count = static_cast<Eigen::Index>(rows.size());
  const auto columns = static_cast<Eigen::Index>(response.theta_r_deg.size());
  for (brdf::HeightArray* array : {&q_per_um_, &c_per_um_, &power_, &floor_})
    array->resize(count, columns);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index from = rows[static_cast<std::size_t>(i)];
    const double lambda_nm = response.lambda_nm[static_cast<std::size_t>(from)];
    lambda_nm_.push_back(lambda_nm);
    for (Eigen::Index j = 0; j < columns; ++j) {
      const double value = response.values(from, j);
      const double theta_deg = response.theta_r_deg[static_cast<std::size_t>(j)];
      if (!std::isfinite(value))
        throw brdf::Error(brdf::Errc::bad_input, "the response at " + brdf::text(lambda_nm) +
                                                     " nm, " + brdf::text(theta_deg) +
                                                     " deg is not finite");
      const brdf::Direction omega_r = brdf::direction(brdf::Angle::deg(theta_deg), scene.phi_r);
      const brdf::Length wavelength = brdf::Length::nm(lambda_nm);
      const brdf::Query at = query(omega_i, omega_r, wavelength, scene.depth);
      q_per_um_(i, j) = -(at.qx_per_um * towards.x() + at.qy_per_um * towards.y()) / length;
      c_per_um_(i, j) = at.c_per_um;
      const double factor = gain(scene.optics, omega_i, omega_r, wavelength);
      const bool seen = factor > 0;
      power_(i, j) = seen ? value / factor : 0;
      floor_(i, j) = seen ? scene.floor / factor : std::numeric_limits<double>::quiet_NaN();
    }
  }
}

std::size_t OrderCells::row_count() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < row.size(); ++i) count += i == 0 || row[i] != row[i - 1] ? 1 : 0;
  return count;
}

std::vector<OrderCells> cells_of_orders(const PowerView& view, const WindowLobe& lobe,
                                        double k_grating_per_um, double half_width_per_um) {
  double lowest = 0, highest = 0;
  for (Eigen::Index row = 0; row < view.rows(); ++row) {
    lowest = std::min(lowest, view.lowest_q_per_um(row));
    highest = std::max(highest, view.highest_q_per_um(row));
  }
  std::vector<OrderCells> orders;
  const auto first = static_cast<int>(std::ceil(lowest / k_grating_per_um));
  const auto last = static_cast<int>(std::floor(highest / k_grating_per_um));
  for (int order = first; order <= last; ++order) {
    if (order == 0) continue;
    std::vector<double> q, c, power;
    OrderCells cells{order, {}, {}, {}, {}, 0, 0, 0, 0, 0};
    for (Eigen::Index row = 0; row < view.rows(); ++row) {
      const RowCells found = cells_around(view, row, order * k_grating_per_um, half_width_per_um);
      for (const Eigen::Index col : found.cols) {
        q.push_back(view.q_per_um(row, col));
        c.push_back(view.c_per_um(row, col));
        power.push_back(view.power(row, col));
        cells.row.push_back(row);
        cells.floor = std::max(cells.floor, view.floor(row, col));
        if (std::abs(q.back() - order * k_grating_per_um) <= lobe.half_width_per_um() / 2)
          cells.middle = std::max(cells.middle, power.back());
      }
    }
    if (cells.row_count() < fewest_rows) continue;
    const auto size = static_cast<Eigen::Index>(q.size());
    cells.q_per_um = Eigen::Map<const Eigen::ArrayXd>(q.data(), size);
    cells.c_per_um = Eigen::Map<const Eigen::ArrayXd>(c.data(), size);
    cells.power = Eigen::Map<const Eigen::ArrayXd>(power.data(), size);
    cells.c_low_per_um = cells.c_per_um.minCoeff();
    cells.c_high_per_um = cells.c_per_um.maxCoeff();
    cells.peak = cells.power.maxCoeff();
    if (cells.peak > 0) orders.push_back(std::move(cells));
  }
  leave_standing(orders, lobe, k_grating_per_um, mirror_power(view, lobe.half_width_per_um()));
  return orders;
}

}  // namespace evaluation
