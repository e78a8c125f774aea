// Which cells of a sweep are evaluated.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brdf/order_range.h"
#include "evaluation/sweep_request.h"

namespace evaluation {

/// Cells of a response matrix, row by row.
class CellSelection {
 public:
  static CellSelection all(const SweepRequest& request);
  /// Those whose query lies in a band around an order (Nmin/Nmax).
  static CellSelection within(const brdf::OrderBands& bands, const SweepRequest& request);

  std::span<const std::size_t> columns_of_row(std::size_t row) const {
    if (every_row_alike()) return columns_;
    return std::span(columns_).subspan(first_[row], first_[row + 1] - first_[row]);
  }
  std::size_t size() const { return every_row_alike() ? rows_ * columns_.size() : columns_.size(); }

  struct Cell {
    std::size_t row, column;
  };
  /// The i-th cell, i < size().
  Cell operator[](std::size_t i) const;

 private:
  explicit CellSelection(std::size_t rows) : rows_(rows) {}
  bool every_row_alike() const { return first_.empty(); }

  std::size_t rows_;
  std::vector<std::size_t> first_;    ///< of each row in columns_; empty where every row has all
  std::vector<std::size_t> columns_;  ///< of all rows in turn
};

}  // namespace evaluation
