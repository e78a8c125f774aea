// Quadratures over wavelength that turn a spectrum into a colour.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "brdf/colour.h"

namespace brdf {

/// A wavelength and its weight: X = sum of weight.x rho.
struct SpectralNode {
  Length wavelength;
  Xyz weight;
};

/// First and last wavelength of an integral.
struct SpectralBand {
  Length first = Length::nm(380), last = Length::nm(780);

  double k_lo_per_um() const { return wavenumber_per_um(last); }
  double k_hi_per_um() const { return wavenumber_per_um(first); }
  double k_half_per_um() const { return (k_hi_per_um() - k_lo_per_um()) / 2; }
};

/// Int S ybar d lambda [um] of a band, by steps of about this length, both ends whole: the Y of rho
/// = 1 before it is made 1.
inline double luminance_um(const SpectralBand& band, double step_nm) {
  const double length_nm = band.last.nm() - band.first.nm();
  const int steps = static_cast<int>(std::ceil(length_nm / step_nm));
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const Length at = Length::nm(band.first.nm() + length_nm * i / steps);
    sum += 1e-3 * length_nm / steps * illuminant_d65(at) * colour_matching(at).y;
  }
  return sum;
}

/// A node of even steps in k: d lambda = lambda^2 / (2 pi) dk.
inline SpectralNode node_of_step(Length at, double step_per_um, double luminance_um) {
  const double measure_um = step_per_um * at.um() * at.um() / (2 * pi);
  return {at, measure_um / luminance_um * illuminant_d65(at) * colour_matching(at)};
}

/// Quadratures of a band that are exact for spectra whose phases run through a limited range.
///
/// In k a spectrum is band-limited: t from -1 to 1 along the band, it is a sum of exp(i x t) with
/// abs(x) at most `InterferenceReach::phase_rad`.
class BandQuadratures {
 public:
  /// largest: nodes of the largest polynomial. Errc::invalid_argument for a band without length.
  BandQuadratures(const SpectralBand& band, int largest)
      : k_mid_per_um_((band.k_lo_per_um() + band.k_hi_per_um()) / 2),
        k_half_per_um_(band.k_half_per_um()),
        moments_(static_cast<std::size_t>(largest)) {
    if (!(band.first.um() > 0 && band.first < band.last))
      throw Error(Errc::invalid_argument, "wavelengths " + text(band.first.nm()) + " to " +
                                              text(band.last.nm()) + " nm must be > 0 and ascend");
    // The tables are straight between their 5 nm; 0.1 nm also resolves the highest polynomial.
    constexpr double step_nm = 0.1;
    const double length_nm = band.last.nm() - band.first.nm();
    const int steps = static_cast<int>(std::ceil(length_nm / step_nm));
    std::vector<Length> wavelengths;
    for (int i = 0; i <= steps; ++i)
      wavelengths.push_back(Length::nm(band.first.nm() + length_nm * i / steps));
    weights_ = colour_weights(wavelengths);
    luminance_um_ = luminance_um(band, step_nm);
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      places_.push_back(std::clamp(
          (wavenumber_per_um(wavelengths[i]) - k_mid_per_um_) / k_half_per_um_, -1.0, 1.0));
      double current = 1, next = places_[i];
      for (Xyz& moment : moments_) {
        moment = moment + current * weights_[i];
        current = std::exchange(next, 2 * places_[i] * next - current);
      }
    }
  }

  /// The integral of the polynomial through the spectrum at N Chebyshev nodes in k,
  /// X = sum_j rho(k_j) Int l_j S xbar d lambda:
  /// w_j = (m_0 + 2 sum_{0 < n < N} m_n T_n(t_j)) / N, t_j = cos(pi (j + 1/2) / N), m_n the
  /// integral with T_n(t) for rho. count: at most the largest.
  std::vector<SpectralNode> polynomial(int count) const {
    std::vector<SpectralNode> nodes;
    for (int j = 0; j < count; ++j) {
      const double t = std::cos(pi * (j + 0.5) / count);
      Xyz sum = moments_.front();
      double current = t, next = 2 * t * t - 1;
      for (int n = 1; n < count; ++n) {
        sum = sum + 2 * current * moments_[static_cast<std::size_t>(n)];
        current = std::exchange(next, 2 * t * next - current);
      }
      nodes.push_back({wavelength(t), 1.0 / count * sum});
    }
    return nodes;
  }

  /// Least N for which the terms left out of exp(i x t), 2 abs(J_m(x)) for m >= N, sum to less than
  /// half the tolerance: each counts twice, as it is seen as another below N.
  static int polynomial_count(double phase_rad, double tolerance) {
    // Beyond m = x + 12 x^(1/3) + 16 every term is below 1e-17.
    int m = static_cast<int>(phase_rad + 12 * std::cbrt(phase_rad) + 16);
    double left_out = 0;
    for (; m > 1; --m) {
      left_out += 4 * std::abs(std::cyl_bessel_j(m, phase_rad));
      if (!(left_out <= tolerance)) break;
    }
    return m + 1;
  }

  /// The trapezoid at even steps in k, in the middle of each.
  std::vector<SpectralNode> even_steps(int count) const {
    std::vector<SpectralNode> nodes;
    for (int j = 0; j < count; ++j)
      nodes.push_back(node_of_step(wavelength((2.0 * j + 1) / count - 1),
                                   2 * k_half_per_um_ / count, luminance_um_));
    return nodes;
  }

  /// Steps for which the trapezoid errs by less than the tolerance: it sees a phase x also as
  /// x + pi N and x - pi N, at which the transform of the eye's functions, Int S xbar exp(i y t)
  /// d lambda, must be below a fourth of the tolerance, as two aliases of the oscillation meet two
  /// of the mean. y is looked for up to `farthest_alias_rad`; 0 where that is not enough.
  int even_count(double phase_rad, double tolerance) const {
    const double alias_rad = alias(tolerance / 4);
    return alias_rad < farthest_alias_rad
               ? static_cast<int>(std::ceil((phase_rad + alias_rad) / pi))
               : 0;
  }

  static constexpr double farthest_alias_rad = 400;

  /// Least y beyond which the transform of the weights, Int S xbar exp(i y t) d lambda, stays below
  /// a limit; at most `farthest_alias_rad`.
  double alias(double limit) const {
    for (double y = farthest_alias_rad; y > 0; y -= 1) {
      double re[3] = {}, im[3] = {};
      for (std::size_t i = 0; i < weights_.size(); ++i) {
        const double cosine = std::cos(y * places_[i]), sine = std::sin(y * places_[i]);
        const double weight[3] = {weights_[i].x, weights_[i].y, weights_[i].z};
        for (int c = 0; c < 3; ++c) {
          re[c] += weight[c] * cosine;
          im[c] += weight[c] * sine;
        }
      }
      for (int c = 0; c < 3; ++c)
        if (!(std::hypot(re[c], im[c]) <= limit)) return y + 1;
    }
    return 0;
  }

 private:
  Length wavelength(double t) const {
    return Length::um(2 * pi / (k_mid_per_um_ + k_half_per_um_ * t));
  }

  double k_mid_per_um_, k_half_per_um_, luminance_um_ = 0;
  std::vector<Xyz> weights_, moments_;
  std::vector<double> places_;
};

}  // namespace brdf
