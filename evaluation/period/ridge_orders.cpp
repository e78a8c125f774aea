#include "evaluation/period/ridge_orders.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "brdf/error.h"

namespace evaluation {
namespace {

/// Populations that differ by less stay one order; half of the distance between them is left.
constexpr double most_off_order = 0.25;
constexpr int most_multiple = 10;
constexpr double explained_share = 0.9;

std::optional<int> order_at(double f_per_um, double fundamental_per_um) {
  const double ratio = f_per_um / fundamental_per_um, nearest = std::round(ratio);
  if (nearest == 0 || !(std::abs(ratio - nearest) <= most_off_order)) return std::nullopt;
  return static_cast<int>(nearest);
}

double fundamental(const std::vector<RidgePlace>& ridges, const RidgePlace& strongest) {
  double all = 0;
  for (const RidgePlace& ridge : ridges) all += ridge.strength;
  for (int n = 1; n <= most_multiple; ++n) {
    const double f0 = std::abs(strongest.f_per_um) / n;
    double explained = 0;
    for (const RidgePlace& ridge : ridges)
      if (order_at(ridge.f_per_um, f0)) explained += ridge.strength;
    if (explained >= explained_share * all) return f0;
  }
  return std::abs(strongest.f_per_um);
}

}  // namespace

RidgeOrders number_ridges(const std::vector<RidgePlace>& ridges, std::optional<int> order,
                          std::optional<brdf::Length> period_guess) {
  const RidgePlace& strongest = *std::ranges::max_element(ridges, {}, &RidgePlace::strength);
  RidgeOrders numbered;
  if (period_guess)
    numbered.fundamental_per_um = 1 / period_guess->um();
  else if (order)
    numbered.fundamental_per_um = std::abs(strongest.f_per_um / *order);
  else
    numbered.fundamental_per_um = fundamental(ridges, strongest);
  for (const RidgePlace& ridge : ridges)
    numbered.orders.push_back(order_at(ridge.f_per_um, numbered.fundamental_per_um));
  return numbered;
}

}  // namespace evaluation
