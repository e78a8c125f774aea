// A picture of several responses at one wavelength.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "apps/picture_format.h"

namespace apps {

enum class ValueScale { linear, logarithmic };

/// Curves of a response over the viewing angle.
struct CutPicture {
  struct Curve {
    std::string name;
    std::vector<std::pair<double, double>> points;  ///< viewing angle [deg], value
  };
  std::vector<Curve> curves;
  ValueScale scale;
  std::string title, value_label;
};

/// The bytes of a file. On a logarithmic scale six decades below the largest value are shown.
/// Throws Errc::cannot_write where gnuplot is missing or fails.
std::string draw(const CutPicture& picture, PictureFormat format);

}  // namespace apps
