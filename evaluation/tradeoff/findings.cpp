#include "evaluation/tradeoff/findings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brdf/error.h"
#include "evaluation/exposure.h"
#include "evaluation/period_fit.h"
#include "evaluation/response_colour.h"

namespace evaluation {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The result of the work, or nothing where it says that there is none.
template <class Work>
auto where_attainable(Work work) -> std::optional<decltype(work())> {
  try {
    return work();
  } catch (const brdf::Error&) {
    return std::nullopt;
  }
}

std::optional<double> largest(const std::vector<double>& differences) {
  if (differences.empty()) return std::nullopt;
  return *std::ranges::max_element(differences);
}

std::vector<double> peak_differences(const std::vector<Peak>& peaks,
                                     const std::vector<Peak>& reference) {
  std::vector<double> differences;
  auto expected = reference.begin();
  for (const Peak& peak : peaks) {
    while (expected != reference.end() && expected->lambda_nm < peak.lambda_nm) ++expected;
    if (expected == reference.end()) break;
    if (expected->lambda_nm != peak.lambda_nm || !expected->theta_r_deg) continue;
    differences.push_back(peak.theta_r_deg ? std::abs(*peak.theta_r_deg - *expected->theta_r_deg)
                                           : infinite);
  }
  return differences;
}

std::vector<double> colour_differences(const std::vector<brdf::Xyz>& colours,
                                       const std::vector<brdf::Xyz>& reference) {
  std::vector<double> differences;
  const double exposure = automatic_exposure(reference);
  for (std::size_t i = 0; i < reference.size(); ++i)
    differences.push_back(shown_difference(colours[i], reference[i], exposure));
  return differences;
}

}  // namespace

Findings findings(const ResponseMatrix& response, const SweepRequest& request,
                  const PeakSearch& search, std::optional<double> sigma_f_per_um) {
  Findings found;
  if (auto plane = where_attainable(
          [&] { return plane_of_incidence(request.theta_i, request.phi_i, request.phi_r); })) {
    plane->sigma_f_per_um = sigma_f_per_um;
    found.peaks = find_peaks(response, *plane, search);
    if (const auto fit = where_attainable(
            [&] { return fit_period(found.peaks, *plane, search.order, /*angle_step_deg=*/0); });
        fit && fit->status == FitStatus::converged)
      found.period_nm = fit->period_nm;
  }
  if (const auto colours = where_attainable([&] { return response_colours(response); }))
    found.colours = colours->xyz;
  return found;
}

FindingErrors difference(const Findings& found, const Findings& reference) {
  FindingErrors errors;
  errors.peak_angle_deg = largest(peak_differences(found.peaks, reference.peaks));
  if (reference.period_nm)
    errors.period_relative =
        found.period_nm ? std::abs(*found.period_nm / *reference.period_nm - 1) : infinite;
  if (!found.colours.empty() && !reference.colours.empty())
    errors.ciede2000 = largest(colour_differences(found.colours, reference.colours));
  return errors;
}

}  // namespace evaluation
