// What people take from a response: peaks, the period, colours; and how far two of them lie apart.
#pragma once

#include <optional>
#include <vector>

#include "brdf/colour_matching.h"
#include "evaluation/peaks.h"
#include "evaluation/response_matrix.h"
#include "evaluation/sweep_request.h"

namespace evaluation {

/// What was found in a relative reflectance. Parts are empty where the response has none: peaks and
/// period off the plane of incidence, colours for fewer than two wavelengths or none that are seen.
struct Findings {
  std::vector<Peak> peaks;
  std::optional<double> period_nm;
  std::vector<brdf::Xyz> colours;  ///< of the viewing angles
};

Findings findings(const ResponseMatrix& response, const SweepRequest& request,
                  const PeakSearch& search, std::optional<double> sigma_f_per_um);

/// Differences of findings; empty where the reference has not found it.
struct FindingErrors {
  std::optional<double> peak_angle_deg;   ///< largest, over the wavelengths of both; infinite where
                                          ///< a peak of the reference is missing
  std::optional<double> period_relative;  ///< infinite where there is no period
  std::optional<double> ciede2000;        ///< largest, over the angles, as shown
};

/// Colours are shown at the automatic exposure of the reference.
FindingErrors difference(const Findings& found, const Findings& reference);

}  // namespace evaluation
