// The sources' normalisation of stored transforms by their extrema.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <span>

#include "brdf/error.h"

namespace brdf {

/// Smallest and largest of some numbers.
struct Extrema {
  double min, max;
  double range() const { return max - min; }
};

/// Of the real and of the imaginary parts of one transform.
struct SpectrumExtrema {
  Extrema re, im;
};

/// Throws Errc::bad_input where there are no values or one is not finite.
inline SpectrumExtrema spectrum_extrema(std::span<const std::complex<double>> spectrum) {
  if (spectrum.empty()) throw Error(Errc::bad_input, "a spectrum without values has no extrema");
  const std::complex<double> first = spectrum.front();
  SpectrumExtrema extrema{{first.real(), first.real()}, {first.imag(), first.imag()}};
  const auto see = [](Extrema& part, double value) {
    if (!std::isfinite(value))
      throw Error(Errc::bad_input, "a value of a spectrum is " + text(value) + ", must be finite");
    part = {std::min(part.min, value), std::max(part.max, value)};
  };
  for (const std::complex<double>& value : spectrum) {
    see(extrema.re, value.real());
    see(extrema.im, value.imag());
  }
  return extrema;
}

/// (x - min) / (max - min), in [0, 1]; 0 where all values are the same (Implementation chapter).
inline double normalised(double value, const Extrema& extrema) {
  return extrema.range() > 0 ? (value - extrema.min) / extrema.range() : 0.0;
}

/// x (max - min) + min: the inverse, within 2 roundings of max - min and one of the result. The
/// printed x max + min (Errata E24) is off by x min.
inline double rescaled(double value, const Extrema& extrema) {
  return value * extrema.range() + extrema.min;
}

/// Bound on what `rescaled` of `normalised` changes in a value: nothing where all are the same.
inline double rescaling_bound(const Extrema& extrema) {
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  if (!(extrema.range() > 0)) return 0;
  return 2 * rounding * extrema.range() +
         rounding * std::max(std::abs(extrema.min), std::abs(extrema.max));
}
inline double rescaling_bound(const SpectrumExtrema& extrema) {
  return std::hypot(rescaling_bound(extrema.re), rescaling_bound(extrema.im));
}

/// Real and imaginary part alike.
inline std::complex<double> normalised(std::complex<double> value, const SpectrumExtrema& extrema) {
  return {normalised(value.real(), extrema.re), normalised(value.imag(), extrema.im)};
}
inline std::complex<double> rescaled(std::complex<double> value, const SpectrumExtrema& extrema) {
  return {rescaled(value.real(), extrema.re), rescaled(value.imag(), extrema.im)};
}

}  // namespace brdf
