// The part of a colour that depends on the directions through their scattering vector alone.
#pragma once

#include <Eigen/Core>
#include <span>

#include "brdf/colour_matching.h"
#include "evaluation/diffraction.h"
#include "evaluation/direction_colours.h"

namespace evaluation {

/// V(u, v, w) = Int weight(lambda) f(lambda) abs(a(k u, k v, k w))^2 d lambda, as XYZ: the colour
/// but for the gain of the directions.
class ScatteringColours {
 public:
  virtual ~ScatteringColours() = default;
  /// colours[j] of scattering[j]; it depends on that vector only. May be called from many threads.
  virtual void evaluate(std::span<const Eigen::Vector3d> scattering,
                        std::span<brdf::Xyz> colours) const = 0;
};

/// The factor of a quantity that depends on the wavelength, f: 1, or (1 um / lambda)^2 of a
/// radiance. quantity: one that has a white, else Errc::invalid_argument.
double spectral_factor(brdf::Quantity quantity, brdf::Length wavelength);

/// 1 over the value of a quantity that is white: 1 for the relative reflectance; pi for the
/// radiance per intensity, of which a perfect diffuser that faces the light has 1 / pi. Throws
/// Errc::invalid_argument for a quantity without a white.
double white_scale(brdf::Quantity quantity);

/// Gain times V. Refers to V.
class DiffractionColours final : public DirectionColours {
 public:
  /// optics: of a quantity that has a white, else Errc::invalid_argument.
  DiffractionColours(const ScatteringColours& colours, const Optics& optics);

  void evaluate(std::span<const DirectionPair> pairs, std::span<brdf::Xyz> colours) const override;

 private:
  const ScatteringColours& colours_;
  Optics optics_;
  double scale_;
};

}  // namespace evaluation
