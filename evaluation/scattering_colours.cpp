#include "evaluation/scattering_colours.h"

namespace evaluation {
namespace {

/// Where the factor of the wavelength is 1.
constexpr auto reference = brdf::Length::um(1);

[[noreturn]] void refuse() {
  throw brdf::Error(brdf::Errc::invalid_argument,
                    "a colour needs a quantity that has a white: relative or radiance");
}

}  // namespace

double spectral_factor(brdf::Quantity quantity, brdf::Length wavelength) {
  const double ratio = reference.um() / wavelength.um();
  switch (quantity) {
    case brdf::Quantity::relative:
      return 1;
    case brdf::Quantity::radiance:
      return ratio * ratio;
    case brdf::Quantity::power:
    case brdf::Quantity::brdf:
      break;
  }
  refuse();
}

double white_scale(brdf::Quantity quantity) {
  switch (quantity) {
    case brdf::Quantity::relative:
      return 1;
    case brdf::Quantity::radiance:
      return brdf::pi;
    case brdf::Quantity::power:
    case brdf::Quantity::brdf:
      break;
  }
  refuse();
}

DiffractionColours::DiffractionColours(const ScatteringColours& colours, const Optics& optics)
    : colours_(colours), optics_(optics), scale_(white_scale(optics.quantity)) {}

void DiffractionColours::evaluate(std::span<const DirectionPair> pairs,
                                  std::span<brdf::Xyz> colours) const {
  colours_.evaluate(scattering_vectors(pairs), colours);
  for (std::size_t j = 0; j < pairs.size(); ++j)
    colours[j] = scale_ * gain(optics_, pairs[j].omega_i, pairs[j].omega_r, reference) * colours[j];
}

}  // namespace evaluation
