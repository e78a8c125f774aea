// Colours from spectra, wavelength by wavelength: of a diffraction amplitude, or of any
// reflectance.
#pragma once

#include <utility>
#include <variant>

#include "brdf/spectral_integral.h"
#include "evaluation/diffraction.h"
#include "evaluation/direction_colours.h"
#include "evaluation/methods.h"
#include "evaluation/scattering_colours.h"

namespace evaluation {

using SpectralIntegral =
    std::variant<brdf::StepIntegral, brdf::AdaptiveIntegral, brdf::BandIntegral>;

/// The most wavelengths that the colour of one direction takes.
std::size_t largest_count(const SpectralIntegral& integral);

/// V(s) = sum_j weight_j f(lambda_j) abs(a(k_j s))^2, f the `spectral_factor` of the quantity.
/// Refers to the amplitude.
class SpectralPower final : public ScatteringColours {
 public:
  SpectralPower(const Amplitude& amplitude, SpectralIntegral integral, brdf::Quantity quantity)
      : amplitude_(amplitude), integral_(std::move(integral)), quantity_(quantity) {}

  void evaluate(std::span<const Eigen::Vector3d> scattering,
                std::span<brdf::Xyz> colours) const override;

 private:
  const Amplitude& amplitude_;
  SpectralIntegral integral_;
  brdf::Quantity quantity_;
};

/// X = scale sum_j weight_j.x rho(lambda_j) of any reflectance. Refers to it.
class SpectralColours final : public DirectionColours {
 public:
  /// scale: 1 over the value that is white (`white_scale`).
  SpectralColours(const Reflectance& reflectance, SpectralIntegral integral, double scale)
      : reflectance_(reflectance), integral_(std::move(integral)), scale_(scale) {}

  void evaluate(std::span<const DirectionPair> pairs, std::span<brdf::Xyz> colours) const override;

 private:
  const Reflectance& reflectance_;
  SpectralIntegral integral_;
  double scale_;
};

}  // namespace evaluation
