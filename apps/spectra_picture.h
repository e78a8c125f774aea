// Pictures of the tables of a Taylor series.
#pragma once

#include <span>
#include <string>

#include "apps/picture_format.h"
#include "brdf/half_spectrum.h"
#include "brdf/spectrum_extrema.h"

namespace apps {

/// One table: log10 of its absolute values over the frequencies, 0 in the middle.
struct SpectrumPicture {
  const brdf::HalfSpectrum* spectrum;
  double dx_um, dy_um;  ///< pixel
  int power;
  std::string title;
};

/// The extrema of all tables over the power.
struct ExtremaPicture {
  std::span<const brdf::SpectrumExtrema> powers;
  std::string title;
};

// The bytes of a file. Both throw Errc::cannot_write where gnuplot is missing or fails.

/// Eight decades below the largest value are shown. Of a grid of more than 1024 bins along a side a
/// cell shows the largest of several, so that no line is lost.
std::string draw(const SpectrumPicture& picture, PictureFormat format);
/// On an axis that is linear up to 1, the share of one pixel, and logarithmic beyond, for both
/// signs.
std::string draw(const ExtremaPicture& picture, PictureFormat format);

}  // namespace apps
