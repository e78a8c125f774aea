// The ridges of a response as a picture.
#pragma once

#include <string>

#include "apps/picture_format.h"
#include "evaluation/period/ridges.h"

namespace apps {

/// What a picture of ridges shows.
struct RidgesPicture {
  const evaluation::ResponseMatrix* response;
  evaluation::PlaneOfIncidence plane;
  const evaluation::Ridges* found;
  std::string title, value_label;
};

/// The bytes of a file: the heat map with the curve of every ridge, solid where it has a maximum
/// and the wider the stronger, numbered at its end and named in a key; below, the mean response
/// over f with the ridges' numbers.
///
/// Throws Errc::cannot_write where gnuplot is missing or fails.
std::string draw(const RidgesPicture& picture, PictureFormat format);

}  // namespace apps
