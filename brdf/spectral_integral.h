// The integral of a spectrum over wavelength to a colour, with no more wavelengths than it takes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "brdf/amplitude.h"
#include "brdf/band_quadratures.h"
#include "brdf/colour.h"
#include "brdf/order_range.h"
#include "brdf/surface.h"

namespace brdf {

/// Wavelengths of the user's own, by the trapezoid (`colour_weights`): the same for all directions.
class StepIntegral {
 public:
  explicit StepIntegral(std::span<const Length> wavelengths) {
    const std::vector<Xyz> weights = colour_weights(wavelengths);
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (weights[i] != Xyz{}) nodes_.push_back({wavelengths[i], weights[i]});
  }

  std::span<const SpectralNode> nodes(const Eigen::Vector3d&) const { return nodes_; }
  std::size_t largest_count() const { return nodes_.size(); }

 private:
  std::vector<SpectralNode> nodes_;
};

/// How far apart two points of a surface are that still interfere: the power abs(a)^2 is a sum of
/// exp(i k s . d) over their distances d, s the scattering vector.
struct InterferenceReach {
  double lateral_um, vertical_um;

  /// Half the range of the phases of that sum while k runs through the band [rad].
  double phase_rad(const Eigen::Vector3d& s, const SpectralBand& band) const {
    return band.k_half_per_um() *
           (std::hypot(s.x(), s.y()) * lateral_um + std::abs(s.z()) * vertical_um);
  }
};

/// The reach beyond which the autocorrelation of the window, exp(-d^2 / (4 sigma_s^2)), is below
/// the tolerance; no farther than the surface itself where that ends.
///
/// tolerance: 0 to 1, exclusive.
inline InterferenceReach interference_reach(const Surface& surface, double tolerance) {
  const HeightField& field = *surface.heights;
  const double window_um = 2 * surface.window.sigma_um() * std::sqrt(-std::log(tolerance));
  const double vertical_um = 2 * field.half_range_um();
  if (surface.model == SurfaceModel::periodic) return {window_um, vertical_um};
  const auto extent = [](const SurfaceAxis& axis) {
    return axis.length_um() * (1 + axis.last_copy - axis.first_copy);
  };
  const double diagonal_um = std::hypot(extent(x_axis(surface)), extent(y_axis(surface)));
  return {
      surface.model == SurfaceModel::replicated ? diagonal_um : std::min(window_um, diagonal_um),
      vertical_um};
}

/// As many wavelengths as the direction needs: near the mirror direction a polynomial in k through
/// a dozen, far from it even steps in k, whichever are fewer (`BandQuadratures`).
///
/// Where the spectrum oscillates faster than the user's own steps, these alias; this does not.
/// Measured in spectral_integral.tests.cpp: within the tolerance of steps of 0.01 nm.
class AdaptiveIntegral {
 public:
  /// tolerance: of the colour against the brightest that the spectrum could give; 0 to 1,
  /// exclusive. farthest_rad: of the directions to come. Errc::invalid_argument for a band of no
  /// length, and for more than `most_rad`.
  AdaptiveIntegral(const SpectralBand& band, const InterferenceReach& reach, double tolerance,
                   double farthest_rad)
      : band_(band), reach_(reach) {
    if (!(farthest_rad <= most_rad))
      throw Error(Errc::invalid_argument,
                  "the spectrum of this surface oscillates through " + text(farthest_rad) +
                      " rad, more than " + text(most_rad) +
                      ": give wavelengths (--lambda) or the period (--orders-only)");
    std::vector<double> phases{2};
    while (phases.back() < farthest_rad) phases.push_back(1.15 * phases.back());
    const BandQuadratures quadratures(band,
                                      BandQuadratures::polynomial_count(phases.back(), tolerance));
    const int even_offset = quadratures.even_count(0, tolerance);
    for (const double phase_rad : phases) {
      const int polynomial = BandQuadratures::polynomial_count(phase_rad, tolerance),
                even = even_offset + static_cast<int>(std::ceil(phase_rad / pi));
      const bool few = even_offset == 0 || polynomial <= even;
      levels_.push_back(
          {phase_rad, few ? quadratures.polynomial(polynomial) : quadratures.even_steps(even)});
    }
  }

  std::span<const SpectralNode> nodes(const Eigen::Vector3d& s) const {
    const double phase_rad = reach_.phase_rad(s, band_);
    const auto level = std::find_if(levels_.begin(), levels_.end() - 1,
                                    [&](const Level& l) { return phase_rad <= l.phase_rad; });
    return level->nodes;
  }
  std::size_t largest_count() const { return levels_.back().nodes.size(); }

  static constexpr double most_rad = 3000;

 private:
  struct Level {
    double phase_rad;
    std::vector<SpectralNode> nodes;
  };

  SpectralBand band_;
  InterferenceReach reach_;
  std::vector<Level> levels_;
};

/// The integral over the bands of a grating's orders alone (Nmin/Nmax), each with its measure:
/// the trapezoid in k at even steps, of which those whose query lies in a band
/// (`OrderBands::contains`) are kept; d lambda = lambda^2 / (2 pi) dk (Erratum E16).
///
/// In k an order is a Gaussian lobe of the window, in which steps of sigma_f leave 1e-4 of it out;
/// they are never longer than 5 nm at 560 nm, which the eye's functions need. Bands that overlap
/// count once, as their steps are the same. What lies between the bands is left out: nothing for a
/// periodic surface, the sidelobes of a cut window, and whatever a real surface sends elsewhere.
class BandIntegral {
 public:
  BandIntegral(const SpectralBand& band, const OrderBands& bands)
      : band_(band), bands_(bands), luminance_um_(luminance_um(band, 1)) {
    if (!(luminance_um_ > 0))
      throw Error(Errc::invalid_argument, "a colour needs wavelengths between " +
                                              text(table_first_nm) + " and " + text(table_last_nm) +
                                              " nm");
  }

  std::vector<SpectralNode> nodes(const Eigen::Vector3d& s) const {
    std::vector<SpectralNode> nodes;
    const double step_per_um = step(s);
    const auto first = static_cast<long>(std::ceil(band_.k_lo_per_um() / step_per_um)),
               last = static_cast<long>(std::floor(band_.k_hi_per_um() / step_per_um));
    for (long j = first; j <= last; ++j) {
      const double k = static_cast<double>(j) * step_per_um;
      if (!bands_.contains(query(s, k))) continue;
      nodes.push_back(node_of_step(Length::um(2 * pi / k), step_per_um, luminance_um_));
    }
    return nodes;
  }
  /// Of directions up to abs(s) = 2.
  std::size_t largest_count() const {
    return 1 +
           static_cast<std::size_t>((band_.k_hi_per_um() - band_.k_lo_per_um()) / step({2, 0, 0}));
  }

 private:
  double step(const Eigen::Vector3d& s) const {
    const double eye = 2 * pi * 0.005 / (0.56 * 0.56);
    return std::min(eye, 2 * pi * bands_.resolution_per_um() / std::hypot(s.x(), s.y()));
  }

  SpectralBand band_;
  OrderBands bands_;
  double luminance_um_;
};

}  // namespace brdf
