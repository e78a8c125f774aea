// Names of units of length.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "brdf/units.h"

namespace evaluation {

/// One of the unit named: pm, nm, um (also µm), mm, cm, m. Empty for any other name.
std::optional<brdf::Length> length_unit(std::string_view name);

/// The names, for a message: "pm, nm, um, mm, cm, m".
std::string length_unit_names();

/// Power of ten from metres: -9 for nm. Empty for any other name.
std::optional<int> length_unit_exponent(std::string_view name);

}  // namespace evaluation
