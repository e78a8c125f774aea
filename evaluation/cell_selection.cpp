#include "evaluation/cell_selection.h"

#include <algorithm>
#include <numeric>

namespace evaluation {

CellSelection CellSelection::all(const SweepRequest& request) {
  CellSelection cells(request.lambda_nm.size());
  cells.columns_.resize(request.theta_r_deg.size());
  std::iota(cells.columns_.begin(), cells.columns_.end(), std::size_t{0});
  return cells;
}

CellSelection CellSelection::within(const brdf::OrderBands& bands, const SweepRequest& request) {
  CellSelection cells(request.lambda_nm.size());
  const std::vector<brdf::Direction> omega_r = viewing_directions(request);
  const brdf::Direction omega_i = request.omega_i();
  cells.first_.push_back(0);
  for (std::size_t row = 0; row < cells.rows_; ++row) {
    for (std::size_t column = 0; column < omega_r.size(); ++column)
      if (bands.contains(query(omega_i, omega_r[column], request.wavelength(row), request.depth)))
        cells.columns_.push_back(column);
    cells.first_.push_back(cells.columns_.size());
  }
  return cells;
}

CellSelection::Cell CellSelection::operator[](std::size_t i) const {
  if (every_row_alike()) return {i / columns_.size(), columns_[i % columns_.size()]};
  const auto after = std::upper_bound(first_.begin(), first_.end(), i);
  return {static_cast<std::size_t>(after - first_.begin()) - 1, columns_[i]};
}

}  // namespace evaluation
