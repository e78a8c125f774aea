// Height fields as text.
#pragma once

#include <string>

#include "brdf/height_field.h"

namespace evaluation {

/// A matrix in micrometres below the header that Gwyddion writes, cells parted by tabs. Numbers are
/// the shortest that read back the same.
std::string to_text(const brdf::HeightField& field, const std::string& title);

}  // namespace evaluation
