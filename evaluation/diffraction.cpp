#include "evaluation/diffraction.h"

#include <complex>
#include <vector>

namespace evaluation {

double gain(const Optics& optics, const brdf::Direction& omega_i, const brdf::Direction& omega_r,
            brdf::Length wavelength) {
  switch (optics.quantity) {
    case brdf::Quantity::power:
      return 1;
    case brdf::Quantity::relative:
      return brdf::relative_gain(omega_i, omega_r);
    case brdf::Quantity::brdf:
      return brdf::brdf_gain(omega_i, omega_r, wavelength, optics.coherence_area_um2);
    case brdf::Quantity::radiance:
      return brdf::radiance_gain(omega_i, omega_r, wavelength, optics.coherence_area_um2);
  }
  return 1;
}

void Diffraction::evaluate(const brdf::Direction& omega_i, std::span<const brdf::Direction> omega_r,
                           brdf::Length wavelength, std::span<double> values) const {
  std::vector<brdf::Query> queries;
  for (const brdf::Direction& direction : omega_r)
    queries.push_back(query(omega_i, direction, wavelength, depth_));
  std::vector<std::complex<double>> amplitudes(queries.size());
  amplitude_.evaluate(queries, amplitudes);
  for (std::size_t j = 0; j < values.size(); ++j)
    values[j] = gain(optics_, omega_i, omega_r[j], wavelength) * std::norm(amplitudes[j]);
}

}  // namespace evaluation
