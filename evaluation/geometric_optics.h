// Rough surfaces without diffraction, to hold the diffraction against.
#pragma once

#include <variant>

#include "brdf/gain.h"
#include "brdf/microfacet.h"
#include "evaluation/reflectance.h"

namespace evaluation {

/// The BRDF of a microfacet model or of Lambert's, or its radiance f cos theta_i.
class GeometricOptics final : public Reflectance {
 public:
  using Model = std::variant<brdf::Microfacet, brdf::Lambert>;

  /// quantity: brdf or radiance, else Errc::invalid_argument: the others compare with a flat
  /// patch under a coherence window. The model's parameters are checked.
  GeometricOptics(const Model& model, brdf::Quantity quantity);

  void evaluate(std::span<const Sample> samples, std::span<double> values) const override;

 private:
  Model model_;
  brdf::Quantity quantity_;
};

}  // namespace evaluation
