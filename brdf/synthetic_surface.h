// Surfaces made by formula: gratings in any direction, crossed, in disorder, side by side, noisy.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "brdf/height_field.h"
#include "brdf/line_pattern.h"

namespace brdf {

/// How a pixel takes its height.
enum class Edges {
  sampled,   ///< at its centre
  averaged,  ///< the mean over its width in x
};

/// A second grating beside the first: the same profile, layout and disorder, with draws of its own.
struct SecondPopulation {
  Length period = {};
  Angle direction = {};
  double share = 0.5;  ///< of the rows, those with the largest y; inside (0, 1)
};

/// What synthetic_surface makes.
struct SyntheticSurface {
  ProfileParameters grating = {};
  Angle direction = {};  ///< azimuth of the grating vector, from +x towards +y
  Layout layout = {};
  Disorder jitter = {};  ///< of the lines, crossed ones too; below a quarter of every period
  std::optional<SecondPopulation> second = {};
  Length noise = {};  ///< standard deviation of what is added to each pixel, white and normal
  Edges edges = Edges::sampled;
  std::uint64_t seed = 1;
};

namespace detail {

/// The patch that a pattern is drawn on, its middle the origin.
struct PatchGrid {
  Eigen::Index rows, cols;
  double dx_um, dy_um;

  /// Of the centre of a column; by column +- 1/2 of its borders.
  double x_um(double col) const { return (col - static_cast<double>(cols - 1) / 2) * dx_um; }
  double y_um(double row) const { return (row - static_cast<double>(rows - 1) / 2) * dy_um; }
  HalfExtent half() const {
    return {static_cast<double>(cols) / 2 * dx_um, static_cast<double>(rows) / 2 * dy_um};
  }
};

/// Heights [0, 1] of `count` rows from `first` on.
inline HeightArray drawn_rows(const LinePattern& pattern, Edges edges, const PatchGrid& grid,
                              Eigen::Index first, Eigen::Index count) {
  // Averaged patterns are straight lines along x.
  const bool same_rows = pattern.is_straight() && pattern.lines().is_constant_along_y();
  HeightArray rows(same_rows ? std::min<Eigen::Index>(count, 1) : count, grid.cols);
  for (Eigen::Index row = 0; row < rows.rows(); ++row)
    for (Eigen::Index col = 0; col < grid.cols; ++col) {
      const auto place = static_cast<double>(col);
      rows(row, col) =
          edges == Edges::averaged
              ? pattern.mean_height(grid.x_um(place - 0.5), grid.x_um(place + 0.5))
              : pattern.height(grid.x_um(place), grid.y_um(static_cast<double>(first + row)));
    }
  if (same_rows && count > 1) return rows.replicate(count, 1);
  return rows;
}

/// Draws a population over its rows; part: 0 for the first, 2 for the second.
inline void draw(const SyntheticSurface& s, Length period, Angle direction, std::uint32_t part,
                 const PatchGrid& grid, Eigen::Index first, Eigen::Index count,
                 HeightArray& heights_um) {
  ProfileParameters grating = s.grating;
  grating.period = period;
  require_valid(grating);
  const LinePattern pattern(grating, direction, s.layout, {s.jitter, s.seed, part}, grid.half());
  if (s.edges == Edges::averaged && !(pattern.is_straight() && pattern.lines().is_along_x()))
    throw Error(Errc::invalid_argument,
                "edges averaged: needs straight lines with the grating vector along x, "
                "direction 0 deg, neither crossed nor fingers");
  heights_um.middleRows(first, count) =
      s.grating.height.um() * drawn_rows(pattern, s.edges, grid, first, count);
}

}  // namespace detail

/// Heights over a patch whose middle has the phase 0 of every grating.
///
/// h = height p(t) [p'(t')] + noise, t the number of the line at the position x cos + y sin along
/// the grating vector: position / period in order, and drawn out between lines in disorder
/// (line_places.h). Random numbers come from engines of their own (random_numbers.h): parts 0 and 1
/// lines and crossed lines, 2 and 3 those of the second population, 4 the noise, row by row.
///
/// Throws Errc::invalid_argument for what require_valid, LinePlaces and LinePattern refuse, a share
/// outside (0, 1), a noise that is no number >= 0, and averaged edges of a pattern that is not
/// straight lines along x; Errc::bad_input for an empty grid.
///
/// Cost: a cosine a pixel, or a column where the rows are alike; 30 ns a pixel with noise.
inline HeightField synthetic_surface(const SyntheticSurface& s, Eigen::Index rows,
                                     Eigen::Index cols, Length pixel_x, Length pixel_y) {
  if (!(s.noise.um() >= 0 && std::isfinite(s.noise.um())))
    throw Error(Errc::invalid_argument, "noise " + text(s.noise.um()) + " um must be >= 0");
  const detail::PatchGrid grid{rows, cols, pixel_x.um(), pixel_y.um()};
  HeightArray heights_um(rows, cols);
  Eigen::Index second_rows = 0;
  if (s.second) {
    if (!(s.second->share > 0 && s.second->share < 1))
      throw Error(Errc::invalid_argument,
                  "second share " + text(s.second->share) + " must lie between 0 and 1");
    second_rows = std::llround(s.second->share * static_cast<double>(rows));
    at_place("second grating", [&] {
      detail::draw(s, s.second->period, s.second->direction, 2, grid, rows - second_rows,
                   second_rows, heights_um);
    });
  }
  detail::draw(s, s.grating.period, s.direction, 0, grid, 0, rows - second_rows, heights_um);
  if (s.noise.um() > 0) {
    RandomEngine engine = random_engine(s.seed, 4);
    for (double& height : heights_um.reshaped<Eigen::RowMajor>())
      height += s.noise.um() * random_normal(engine);
  }
  return HeightField(std::move(heights_um), pixel_x, pixel_y);
}

/// A grating along x, sampled at the pixel centres.
inline HeightField synthetic_grating(const ProfileParameters& p, Eigen::Index rows,
                                     Eigen::Index cols, Length pixel_x, Length pixel_y) {
  return synthetic_surface({.grating = p}, rows, cols, pixel_x, pixel_y);
}

}  // namespace brdf
