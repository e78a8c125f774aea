// Which order of diffraction a ridge is.
#pragma once

#include <optional>
#include <vector>

#include "brdf/units.h"

namespace evaluation {

/// A ridge for this purpose.
struct RidgePlace {
  double f_per_um;
  double strength;
};

/// The frequency 1 / d [1/um] of the first order, and the order of each ridge; empty where a ridge
/// lies more than a quarter of an order from any, or nearest to order 0.
struct RidgeOrders {
  double fundamental_per_um;
  std::vector<std::optional<int>> orders;
};

/// Numbers the ridges.
///
/// With a guess of the period the first order is at its frequency. With an order alone the
/// strongest ridge is of that order (its sign gives way to the side that the ridge is on). With
/// neither the first order is the strongest ridge's frequency over n, for the least n from 1 to 10
/// at which nine tenths of the strength of the ridges, summed, lie within a quarter of an order of
/// one; n = 1 where there is none.
///
/// What cannot be known: a single order in view is taken as order 1 or -1, whatever it is, and so
/// are orders 2 and 4 without 1 and 3. Populations whose periods differ by more than a quarter are
/// taken as different orders or as none. ridges: at least one.
RidgeOrders number_ridges(const std::vector<RidgePlace>& ridges, std::optional<int> order,
                          std::optional<brdf::Length> period_guess);

}  // namespace evaluation
