// Pictures, drawn by gnuplot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/picture_format.h"
#include "evaluation/peaks.h"
#include "evaluation/period_fit.h"
#include "evaluation/response_matrix.h"

namespace apps {

/// What a picture of a response shows.
struct ResponsePicture {
  const evaluation::ResponseMatrix* response;
  evaluation::PlaneOfIncidence plane;
  int order;
  std::vector<evaluation::Peak> peaks;
  std::optional<evaluation::PeriodFit> fit;  ///< with the curve of the grating equation
  std::string title, value_label;
};

/// The bytes of a file: a heat map with peaks and fitted grating equation, and the period
/// wavelength by wavelength below.
///
/// Throws Errc::cannot_write where gnuplot is missing or fails.
std::string draw(const ResponsePicture& picture, PictureFormat format);

}  // namespace apps
