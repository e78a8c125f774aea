// What a detector sees of a diffraction amplitude.
#pragma once

#include "brdf/fresnel.h"
#include "brdf/gain.h"
#include "evaluation/methods.h"
#include "evaluation/reflectance.h"
#include "evaluation/sweep_request.h"

namespace evaluation {

/// Light lost between the facets of the surface.
enum class Shadowing {
  none,
  v_cavity,  ///< V-shaped grooves (brdf/shadowing.h)
};

/// The analytic factors between the power of an amplitude and a value of the response.
struct Optics {
  brdf::Quantity quantity = brdf::Quantity::relative;
  double coherence_area_um2 = 1;  ///< for absolute quantities
  brdf::Fresnel fresnel = {};
  Shadowing shadowing = Shadowing::none;
};

/// Factor between abs(a)^2 and the quantity: the gain of the directions, times R at the half vector
/// (for the relative reflectance R / R_0), times the shadowing. 1 for the power.
double gain(const Optics& optics, const brdf::Direction& omega_i, const brdf::Direction& omega_r,
            brdf::Length wavelength);

/// abs(a)^2 times the factors. Refers to the amplitude.
class Diffraction final : public Reflectance {
 public:
  Diffraction(const Amplitude& amplitude, const Optics& optics,
              DepthFrequency depth = DepthFrequency::scattering_vector)
      : amplitude_(amplitude), optics_(optics), depth_(depth) {}

  void evaluate(std::span<const Sample> samples, std::span<double> values) const override;

 private:
  const Amplitude& amplitude_;
  Optics optics_;
  DepthFrequency depth_;
};

}  // namespace evaluation
