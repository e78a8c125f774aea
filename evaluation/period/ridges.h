// The ridges of a response: every population of periods that it shows, over all wavelengths at
// once.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/period/ridge_shape.h"

namespace evaluation {

/// What is looked for.
struct RidgeSearch {
  std::optional<int> order;                                           ///< see number_ridges; not 0
  std::optional<brdf::Length> period_guess;                           ///< of the grating, > 0
  std::optional<std::pair<brdf::Length, brdf::Length>> period_range;  ///< only these periods
  std::optional<std::pair<double, double>> theta_r_deg;               ///< only these angles
  double floor = 0;            ///< what the error of the response could make
  double least_contrast = 10;  ///< over the background, > 1
};

/// Another ridge that one cannot be told from at some wavelengths: there is one maximum for both.
struct RidgeMerge {
  std::size_t with;         ///< its index
  std::size_t wavelengths;  ///< how many
};

/// A curve f = (sin theta_i + sin theta_r) / lambda = m / d along which a response has its maxima.
struct Ridge {
  double f_per_um;           ///< of its maxima, the median weighted with their power
  double f_spread_per_um;    ///< their standard deviation over the wavelengths, weighted
  std::optional<int> order;  ///< m, positive towards the light
  double period_nm;          ///< m / f; 1 / |f| where the order is not known
  double strength;           ///< S there, in its mean over the frequencies in view; to 1 %
  double relative;           ///< to the strongest of the ridges
  double contrast;           ///< S over the background; infinite where that is 0
  std::optional<double> width_per_um;   ///< FWHM in f; empty where it does not fall to a half
  std::optional<double> window_widths;  ///< the same in widths of the window, 2 sqrt(ln 2) sigma_f
  std::vector<WavelengthSpan> spans;    ///< where it has a maximum
  double present;                       ///< share of the wavelengths in whose view it lies
  double brightest;                     ///< share in which it is the brightest of its order
  std::vector<RidgeMerge> merged_with;
};

/// Changes of ridge along the track of the brightest maximum per wavelength among an order's.
struct OrderJumps {
  int order;
  std::size_t jumps;
};

struct Ridges {
  std::vector<Ridge> ridges;  ///< strongest first
  std::vector<OrderJumps> jumps;
  std::vector<double> f_per_um, mean;  ///< S(f), for pictures; 0 in the mirror lobe
};

/// Finds the ridges.
///
/// S(f), the mean over the wavelengths of the response that `over_frequency` normalises, has a
/// ridge at a maximum that
/// - is `least_contrast` times the background, the median of S over an octave around, on the same
///   side of the mirror direction, over ln 2. Of a rough surface that is the mean power, which a
///   grain of its speckle exceeds 10 times with probability exp(-10); 4 of 100 simulated views of
///   150 grains had a ridge. Speckle that changes with the wavelength averages to less;
/// - falls by a fifth within 5 sigma_f on both sides: what is wider is a trend, not a ridge;
/// - is the highest within sigma_f: two equal lobes of the window at 1.4 sigma_f have one maximum;
/// - exceeds (sigma_f / (6 distance))^2 times every stronger one, mirror lobe included: more than
/// the
///   sidelobes of a Gaussian cut at 2 sigma. Patches shorter than 4 sigma have higher ones;
/// - has its own maximum at 3 wavelengths and a fifth of those that see it: one bright speckle is
///   no ridge.
/// Members are found by `assign_members`, orders by `number_ridges`. With a guess and an order only
/// that order's ridges are kept; with a range only those with a period in it; lastly numbers and
/// strengths count among those kept.
///
/// Accuracy, measured in ridges.tests.cpp: of lobes 5 sigma_f apart f to 5e-3
/// sigma_f. Lobes nearer
/// to each other than about 2 sigma_f pull each other's maxima by tenths of it, and interfere. The
/// gain across a row is not divided out. A ridge need not be a population of the surface: a rough
/// patch of finite size has grains at constant f too, which only the contrast tells from a grating.
/// No ridge is an empty result. Throws Errc::not_attainable for fewer than 3 wavelengths,
/// Errc::invalid_argument for order 0, a contrast or a period out of range, Errc::bad_input for a
/// value that is not finite.
Ridges find_ridges(const ResponseMatrix& response, const PlaneOfIncidence& plane,
                   const RidgeSearch& search);

/// One row per ridge: number,order,side,period_nm,f_per_um,f_spread_per_um,strength,relative,
/// contrast,width_per_um,window_widths,present,brightest,spans_nm,merged_with. Spans are FIRST-LAST
/// and numbers of ridges, several of each separated by semicolons; what is not known is empty.
std::string to_csv(const std::vector<Ridge>& ridges);

}  // namespace evaluation
