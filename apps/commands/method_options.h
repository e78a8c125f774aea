// What commands say of --method and --tolerance alike.
#pragma once

#include <string>

namespace apps {

/// The amplitude methods of the table, as --help lists values: "direct|auto|...".
std::string amplitude_methods();

/// Refuses an error that is not between 0 and 1: a part of the flat patch's peak, or of a
/// brightness.
void require_tolerance(const std::string& option, double tolerance);

}  // namespace apps
