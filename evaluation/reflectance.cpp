#include "evaluation/reflectance.h"

namespace evaluation {

std::vector<Eigen::Vector3d> scattering_vectors(std::span<const DirectionPair> pairs) {
  std::vector<Eigen::Vector3d> vectors;
  vectors.reserve(pairs.size());
  for (const DirectionPair& pair : pairs)
    vectors.push_back(brdf::scattering_vector(pair.omega_i, pair.omega_r));
  return vectors;
}

}  // namespace evaluation
