#include "evaluation/geometric_optics.h"

namespace evaluation {
namespace {

struct Brdf {
  const brdf::Direction &omega_i, &omega_r;
  brdf::Length wavelength;

  double operator()(const brdf::Microfacet& surface) const {
    return surface.brdf(omega_i, omega_r, wavelength);
  }
  double operator()(const brdf::Lambert& surface) const { return surface.brdf(); }
};

}  // namespace

GeometricOptics::GeometricOptics(const Model& model, brdf::Quantity quantity)
    : model_(model), quantity_(quantity) {
  if (quantity != brdf::Quantity::brdf && quantity != brdf::Quantity::radiance)
    throw brdf::Error(brdf::Errc::invalid_argument,
                      "geometric optics has a BRDF and a radiance; power and relative reflectance "
                      "are those of a diffracting patch");
  std::visit([](const auto& surface) { require_valid(surface); }, model_);
}

void GeometricOptics::evaluate(std::span<const Sample> samples, std::span<double> values) const {
  for (std::size_t j = 0; j < values.size(); ++j) {
    const auto& [directions, wavelength] = samples[j];
    const double factor = quantity_ == brdf::Quantity::radiance ? directions.omega_i.z() : 1.0;
    values[j] =
        factor * std::visit(Brdf{directions.omega_i, directions.omega_r, wavelength}, model_);
  }
}

}  // namespace evaluation
