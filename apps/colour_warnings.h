// What is said about colours that are not what they seem.
#pragma once

#include <string>

#include "evaluation/response_colour.h"

namespace apps {

/// Warns of wavelengths that leave out a part of the visible, or lie too far apart.
void warn_of_coverage(const evaluation::SpectralCoverage& coverage, const std::string& file);

/// Warns of colours outside the gamut; says nothing where there are none.
/// what: "colours" or "pixels"; space: name of the gamut.
void warn_of_clipped(std::size_t clipped, std::size_t all, const std::string& what,
                     const std::string& space, const std::string& file);

/// A factor of the light: > 0 and finite.
double parse_exposure(const std::string& option, const std::string& text);

}  // namespace apps
