// How bright colours are shown, and how different two of them then look.
#pragma once

#include <span>

#include "brdf/colour_matching.h"

namespace evaluation {

/// The factor of the light by which, of the colours with any light, 1 % are brighter than white,
/// or those that hold half of all light where these are fewer: a grating sends nearly all of it to
/// a few directions. 1 where there is no light.
double automatic_exposure(std::span<const brdf::Xyz> colours);

/// CIEDE2000 of two colours times the exposure, each clipped to what sRGB can show.
double shown_difference(const brdf::Xyz& a, const brdf::Xyz& b, double exposure);

}  // namespace evaluation
