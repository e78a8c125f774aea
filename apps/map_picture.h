// Drawing of hemispheres of viewing directions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/picture_format.h"
#include "brdf/units.h"

namespace apps {

/// Where the orders of a grating are expected.
struct OrderArcs {
  brdf::Length period;
  brdf::Angle azimuth;  ///< of the grating vector
};

/// One hemisphere.
struct MapPanel {
  std::vector<std::uint8_t> rgba;  ///< size x size x 4, the row of the smallest y first
  brdf::Angle theta_i, phi_i;
  std::string caption;
};

/// A sheet of hemispheres, side by side.
struct MapPicture {
  std::string title;
  int size;  ///< pixels along a side of a hemisphere
  std::vector<MapPanel> panels;
  std::optional<OrderArcs> arcs;
  std::optional<double> mirror_radius;  ///< where the mirror lobe is left out [sine]
};

/// The bytes of a file. Throws Errc::cannot_write where gnuplot is missing or fails.
std::string draw(const MapPicture& picture, PictureFormat format);

}  // namespace apps
