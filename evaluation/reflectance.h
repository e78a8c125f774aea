// What a sweep asks of a surface: a value per direction and wavelength.
#pragma once

#include <span>

#include "brdf/directions.h"

namespace evaluation {

/// A model of a surface that gives what a detector sees. Microfacets are one; so is an amplitude
/// with its gain.
class Reflectance {
 public:
  virtual ~Reflectance() = default;
  /// values[j] at omega_r[j]; it depends on that direction, the light and the wavelength only.
  /// May be called from many threads.
  virtual void evaluate(const brdf::Direction& omega_i, std::span<const brdf::Direction> omega_r,
                        brdf::Length wavelength, std::span<double> values) const = 0;
};

}  // namespace evaluation
