// A response over the spatial frequency of the grating equation, the same for all wavelengths.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "evaluation/peaks.h"

namespace evaluation {

/// The points of an axis that a wavelength sees: from `begin` to before `end`.
struct SeenPoints {
  std::size_t begin = 0, end = 0;

  bool holds(std::size_t point) const { return point >= begin && point < end; }
};

/// R(lambda, f) over f = (sin theta_i + sin theta_r) / lambda [1/um], where an order m of a period
/// d stays at m / d at every wavelength; positive towards the light.
struct FrequencyResponse {
  double first_per_um, step_per_um;
  double sigma_f_per_um;          ///< of the coherence window; where unknown from the lobes' width
  double sidelobe;                ///< largest amplitude of a lobe's sidelobes x distance / sigma_f
  brdf::HeightArray values;       ///< wavelengths x points: R over `gain`; 0 where not seen
  std::vector<SeenPoints> seen;   ///< per wavelength; none of a dark one
  std::vector<double> gain;       ///< per wavelength: how it outshines the others
  std::vector<double> mean;       ///< per point: S(f), over the wavelengths that see it
  std::vector<std::size_t> rows;  ///< per point: how many do

  std::size_t points() const { return mean.size(); }
  double frequency(double point) const { return first_per_um + point * step_per_um; }
  /// Whether a point lies where the mirror direction shines: within 6 sigma_f of it.
  bool in_mirror(std::size_t point) const;
};

/// Resamples a response, and takes out what makes one wavelength outshine another.
///
/// A value is the mean of the linearly interpolated cells over one step, which is sigma_f / 6, or
/// the median distance of the cells in f where that is more: a lobe exp(-f^2 / sigma_f^2) gets 0.2
/// % wider. Where sigma_f is not known it is the median over the wavelengths of that of the
/// brightest lobe, at least one step. Sidelobes are those of a Gaussian cut at 2 sigma, 0.113, with
/// half as much again for the gain along a row; where sigma_f is not known of an evenly lit length.
/// gain(lambda) and S(f) solve R = gain S in the mean over rows and columns, outside of the mirror
/// lobe, so that wavelengths that see different frequencies compare; the mean of S is 1 there.
/// theta_r_deg: only cells at these angles, if given. Empty of points where no row has 3 of them,
/// or all are dark. Throws Errc::bad_input for a value that is not finite. Cost: some passes over
/// the points, at most 8 times as many as there are cells.
FrequencyResponse over_frequency(const ResponseMatrix& response, const PlaneOfIncidence& plane,
                                 const std::optional<std::pair<double, double>>& theta_r_deg);

}  // namespace evaluation
