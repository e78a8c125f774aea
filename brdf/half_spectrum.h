// The transform of real samples, of which one half is stored.
#pragma once

#include <cmath>
#include <complex>
#include <span>

#include "brdf/units.h"

namespace brdf {

/// The two-dimensional transform of real samples, read at any integers from the half that is
/// stored. Refers to memory that must outlive it.
///
/// `half`, rows x (cols / 2 + 1), is the transform with the minus sign, not normalised, as FFTW's
/// real transform and numpy.fft.rfft2 lay it out. Read is the one with the plus sign,
/// F(j, l) = sum_{r, c} s(r, c) exp(+2 pi i (j r / rows + l c / cols)).
struct HalfSpectrum {
  std::span<const std::complex<double>> half;
  long rows, cols;

  long half_cols() const { return cols / 2 + 1; }

  /// F(j, l) for any integers: bins repeat with the period of the grid. For real samples the plus
  /// sign is the conjugate of the minus sign, and the other half its mirror.
  std::complex<double> bin(long j, long l) const {
    const long row = wrap(j, rows), col = wrap(l, cols);
    if (col < half_cols()) return std::conj(at(row, col));
    return at(wrap(-row, rows), cols - col);
  }

 private:
  std::complex<double> at(long row, long col) const {
    return half[static_cast<std::size_t>(row * half_cols() + col)];
  }
  static long wrap(long index, long count) {
    const long remainder = index % count;
    return remainder < 0 ? remainder + count : remainder;
  }
};

/// exp(-2 pi i bin x0 / count), x0 the origin's pixel, in halves of a pixel: moves a transform's
/// origin there. The phase is reduced in whole half-pixels before it meets pi.
inline std::complex<double> origin_phase(long bin, long origin_half_pixels, long count) {
  const long turn = 2 * count;
  const long reduced = (bin % turn) * origin_half_pixels % turn;
  return std::polar(1.0, -2 * pi * static_cast<double>(reduced) / static_cast<double>(turn));
}

}  // namespace brdf
