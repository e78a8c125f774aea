// Height fields as Gwyddion Simple Field files.
#pragma once

#include <string>

#include "brdf/height_field.h"

namespace evaluation {

/// The bytes of a GSF file: heights in metres as 32-bit floats, lateral size in metres.
std::string to_gsf(const brdf::HeightField& field, const std::string& title);

}  // namespace evaluation
