// What a sweep asks of a surface: a value per direction and wavelength.
#pragma once

#include <span>
#include <vector>

#include "brdf/directions.h"

namespace evaluation {

/// Light and viewer at one point of a surface, both in the frame of the patch there and in its
/// upper half-space.
struct DirectionPair {
  brdf::Direction omega_i, omega_r;
};

/// (u, v, w) of each pair.
std::vector<Eigen::Vector3d> scattering_vectors(std::span<const DirectionPair> pairs);

/// One value that is asked for.
struct Sample {
  DirectionPair directions;
  brdf::Length wavelength;
};

/// A model of a surface that gives what a detector sees. Microfacets are one; so is an amplitude
/// with its gain.
class Reflectance {
 public:
  virtual ~Reflectance() = default;
  /// values[j] of samples[j]; it depends on that sample only. May be called from many threads.
  virtual void evaluate(std::span<const Sample> samples, std::span<double> values) const = 0;
};

}  // namespace evaluation
