// Every method and formula at its extremes, measured against 50 digits.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "evaluation/checks.h"

namespace evaluation {

/// Rows that belong together.
struct StabilityGroup {
  std::string_view name;
  std::vector<CheckRow> (*measure)();
};

/// All groups: factors at the orders, phase series, grazing directions, long patches, heights,
/// wavelengths, small patches, replicas. All together take some seconds.
///
/// Errors of amplitudes are relative to the peak of a flat patch, those of gains to their value.
/// The reference is the same sum in 50 digits from the same doubles (Boost.Multiprecision). A case
/// counts as refused where a method throws brdf::Error, or where its stated error bound is above
/// the tolerance asked for: the program then warns, and under --strict refuses; the error must
/// still be within the bound.
std::span<const StabilityGroup> stability_groups();

/// The rows of all groups.
std::vector<CheckRow> stability_rows();

}  // namespace evaluation
