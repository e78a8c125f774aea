#include "evaluation/spectral_colours.h"

#include <complex>
#include <vector>

namespace evaluation {
namespace {

/// Lists each direction's wavelengths, has all their values evaluated at once, and sums them up.
/// evaluate: (direction, wavelength) of each value, values.
template <class Evaluate>
void integrate(const SpectralIntegral& integral, std::span<const Eigen::Vector3d> scattering,
               Evaluate evaluate, std::span<brdf::Xyz> colours) {
  std::vector<std::pair<std::size_t, brdf::Length>> places;
  std::vector<brdf::Xyz> weights;
  for (std::size_t i = 0; i < scattering.size(); ++i)
    std::visit(
        [&](const auto& each) {
          for (const auto& [wavelength, weight] : each.nodes(scattering[i])) {
            places.emplace_back(i, wavelength);
            weights.push_back(weight);
          }
        },
        integral);
  std::vector<double> values(places.size());
  if (!places.empty()) evaluate(std::as_const(places), values);
  std::fill(colours.begin(), colours.end(), brdf::Xyz{});
  for (std::size_t j = 0; j < values.size(); ++j) {
    brdf::Xyz& colour = colours[places[j].first];
    colour = colour + values[j] * weights[j];
  }
}

}  // namespace

std::size_t largest_count(const SpectralIntegral& integral) {
  return std::visit([](const auto& each) { return each.largest_count(); }, integral);
}

void SpectralPower::evaluate(std::span<const Eigen::Vector3d> scattering,
                             std::span<brdf::Xyz> colours) const {
  const auto power = [&](const auto& places, std::vector<double>& values) {
    std::vector<brdf::Query> queries;
    queries.reserve(places.size());
    for (const auto& [i, wavelength] : places)
      queries.push_back(brdf::query(scattering[i], brdf::wavenumber_per_um(wavelength)));
    std::vector<std::complex<double>> amplitudes(queries.size());
    amplitude_.evaluate(queries, amplitudes);
    for (std::size_t j = 0; j < values.size(); ++j)
      values[j] = spectral_factor(quantity_, places[j].second) * std::norm(amplitudes[j]);
  };
  integrate(integral_, scattering, power, colours);
}

void SpectralColours::evaluate(std::span<const DirectionPair> pairs,
                               std::span<brdf::Xyz> colours) const {
  const auto values_of = [&](const auto& places, std::vector<double>& values) {
    std::vector<Sample> samples;
    for (const auto& [i, wavelength] : places) samples.push_back({pairs[i], wavelength});
    reflectance_.evaluate(samples, values);
  };
  integrate(integral_, scattering_vectors(pairs), values_of, colours);
  for (brdf::Xyz& colour : colours) colour = scale_ * colour;
}

}  // namespace evaluation
