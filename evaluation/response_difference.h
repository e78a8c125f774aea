// Two responses held against each other.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "evaluation/response_matrix.h"

namespace evaluation {

/// Where one response is furthest from another, over all cells.
struct ResponseDifference {
  double worst = 0;  ///< largest abs(difference); infinite where one is not a finite number
  std::size_t row = 0, column = 0;
};

/// Where an axis has its values in another order than the reference has them: what stands there,
/// and what should.
struct OutOfOrder {
  double found, expected;
};

/// Whether the axes have the same values, to a millionth of the reference's smallest step: other
/// programs write them with fewer digits. `out_of_order` then says where the order differs first.
///
/// Throws Errc::bad_input, naming the axis and both spans, where they have other values.
std::optional<OutOfOrder> out_of_order(const Axis& axis, const Axis& reference,
                                       const std::string& name);

/// Cell by cell; the axes must match and be in order.
ResponseDifference response_difference(const ResponseMatrix& response,
                                       const ResponseMatrix& reference);

}  // namespace evaluation
