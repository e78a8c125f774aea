#include "evaluation/diffraction.h"

#include <complex>
#include <vector>

#include "brdf/shadowing.h"

namespace evaluation {

namespace {

double visible(Shadowing shadowing, const brdf::Direction& omega_i,
               const brdf::Direction& omega_r) {
  return shadowing == Shadowing::v_cavity ? brdf::v_cavity_shadowing(omega_i, omega_r) : 1.0;
}

}  // namespace

double gain(const Optics& optics, const brdf::Direction& omega_i, const brdf::Direction& omega_r,
            brdf::Length wavelength) {
  const auto reflected = [&] {
    return visible(optics.shadowing, omega_i, omega_r) *
           optics.fresnel.reflectance(brdf::cos_half(omega_i, omega_r));
  };
  switch (optics.quantity) {
    case brdf::Quantity::power:
      return 1;
    case brdf::Quantity::relative:
      return visible(optics.shadowing, omega_i, omega_r) *
             optics.fresnel.relative_reflectance(brdf::cos_half(omega_i, omega_r)) *
             brdf::relative_gain(omega_i, omega_r);
    case brdf::Quantity::brdf:
      return reflected() * brdf::brdf_gain(omega_i, omega_r, wavelength, optics.coherence_area_um2);
    case brdf::Quantity::radiance:
      return reflected() *
             brdf::radiance_gain(omega_i, omega_r, wavelength, optics.coherence_area_um2);
  }
  return 1;
}

void Diffraction::evaluate(std::span<const Sample> samples, std::span<double> values) const {
  std::vector<brdf::Query> queries;
  queries.reserve(samples.size());
  for (const auto& [directions, wavelength] : samples)
    queries.push_back(query(directions.omega_i, directions.omega_r, wavelength, depth_));
  std::vector<std::complex<double>> amplitudes(queries.size());
  amplitude_.evaluate(queries, amplitudes);
  for (std::size_t j = 0; j < values.size(); ++j) {
    const auto& [directions, wavelength] = samples[j];
    values[j] = gain(optics_, directions.omega_i, directions.omega_r, wavelength) *
                std::norm(amplitudes[j]);
  }
}

}  // namespace evaluation
