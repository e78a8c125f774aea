// The colour of a diffracting surface as a table over the scattering vector.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brdf/colour_matching.h"
#include "brdf/error.h"
#include "brdf/units.h"

namespace brdf {

/// Numbers that fix the grid of a volume.
struct VolumeShape {
  double centre_step;    ///< distance of rings near r = 0
  double relative_step;  ///< distance of rings over r, far from 0
  double angles_per_r;   ///< points of a ring of radius 1
  int terms;             ///< Chebyshev terms in w
};

/// Where V(u, v, w) is known: on rings (u, v) = r (cos phi, sin phi), at w by a Chebyshev series
/// over -2 <= w <= 0.
///
/// White light blurs a surface's speckle along the radius, u = q lambda / (2 pi), and not around
/// it. So the radii r_j = r_0 sinh(j delta) grow with a fixed ratio except near the mirror
/// direction, while a ring has points in proportion to its length: some four times fewer than a
/// square lattice. The last ring lies `margin` rings beyond abs(u, v) = 2.
class VolumeGrid {
 public:
  static constexpr int taps = 6, margin = taps / 2;

  /// Errc::invalid_argument for steps that are not positive and finite, or below 1e-4 (more than
  /// 2^31 points); terms outside 1 to 256.
  explicit VolumeGrid(const VolumeShape& shape) : shape_(shape) {
    const auto require = [](const char* what, double value, double lo, double hi) {
      if (!(value >= lo && value <= hi))
        throw Error(Errc::invalid_argument, std::string("volume: ") + what + " " + text(value) +
                                                " must lie between " + text(lo) + " and " +
                                                text(hi));
    };
    require("centre step", shape.centre_step, 1e-5, 1);
    require("relative step", shape.relative_step, 1e-4, 1);
    require("angles per r", shape.angles_per_r, 1, 1e5);
    require("terms", shape.terms, 1, 256);
    const int last = static_cast<int>(std::ceil(std::asinh(2 / r0()) / shape.relative_step));
    for (int ring = 0; ring <= last + margin; ++ring) {
      first_.push_back(points_);
      points_ += static_cast<std::size_t>(angles(ring));
    }
  }

  const VolumeShape& shape() const { return shape_; }
  int rings() const { return static_cast<int>(first_.size()); }
  std::size_t points() const { return points_; }
  /// Numbers in a table: three for each term of each point.
  std::size_t size() const { return points_ * static_cast<std::size_t>(shape_.terms) * 3; }
  double radius(int ring) const { return r0() * std::sinh(ring * shape_.relative_step); }
  /// Points of a ring, at the azimuths 2 pi i / angles: those of a radius larger by 0.1, since the
  /// mirror lobe stands out by five decades and its skirts are to be right as well.
  int angles(int ring) const {
    return ring == 0 ? 1 : 2 * taps + static_cast<int>(shape_.angles_per_r * (radius(ring) + 0.1));
  }
  std::size_t first(int ring) const { return first_[static_cast<std::size_t>(ring)]; }
  /// Position among the rings, not whole.
  double ring_of(double r) const { return std::asinh(r / r0()) / shape_.relative_step; }

 private:
  double r0() const { return shape_.centre_step / shape_.relative_step; }

  VolumeShape shape_;
  std::vector<std::size_t> first_;
  std::size_t points_ = 0;
};

namespace detail {

/// Lagrange's weights of the points -2 ... 3 at 0 <= t < 1.
inline std::array<double, VolumeGrid::taps> lagrange_weights(double t) {
  constexpr int taps = VolumeGrid::taps;
  std::array<double, taps> weights;
  for (int i = 0; i < taps; ++i) {
    double weight = 1;
    for (int j = 0; j < taps; ++j)
      if (j != i) weight *= (t - (j - 2)) / (i - j);
    weights[static_cast<std::size_t>(i)] = weight;
  }
  return weights;
}

}  // namespace detail

/// Reads V(u, v, w) from a table. Refers to the numbers: [point][term][X, Y, Z].
///
/// Polynomials of degree 5 through the nearest 6 points along the ring and across the rings, the
/// series in w. Cost: 36 times 3 terms products. The error is that of the table's steps: measured
/// when it is made (evaluation/bake.h), and in colour_volume.tests.cpp.
class ColourVolume {
 public:
  /// numbers: of the size of the grid, else Errc::invalid_argument.
  ColourVolume(VolumeGrid grid, std::span<const float> numbers)
      : grid_(std::move(grid)), numbers_(numbers) {
    if (numbers.size() != grid_.size())
      throw Error(Errc::invalid_argument, "volume: " + std::to_string(numbers.size()) +
                                              " numbers, the grid has " +
                                              std::to_string(grid_.size()));
  }

  const VolumeGrid& grid() const { return grid_; }

  /// abs(u, v) <= 2 and -2 <= w <= 0, as of any two directions; rounded into that.
  Xyz operator()(double u, double v, double w) const {
    constexpr int taps = VolumeGrid::taps;
    const auto row = static_cast<std::size_t>(grid_.shape().terms) * 3;
    const double r = std::min(std::hypot(u, v), 2.0), azimuth = std::atan2(v, u);
    const double place = grid_.ring_of(r);
    const int below = static_cast<int>(std::floor(place));
    const auto across = detail::lagrange_weights(place - below);
    std::array<float, 3 * 256> sums;
    std::fill_n(sums.begin(), row, 0.0f);
    for (int i = 0; i < taps; ++i)
      add_ring(below - 2 + i, azimuth, across[static_cast<std::size_t>(i)], sums.data());
    return series(sums.data(), std::clamp(w + 1, -1.0, 1.0));
  }

 private:
  /// A ring of negative number is the one on the other side of the middle.
  void add_ring(int ring, double azimuth, double share, float* sums) const {
    constexpr int taps = VolumeGrid::taps;
    const auto row = static_cast<std::size_t>(grid_.shape().terms) * 3;
    const int number = std::abs(ring), angles = grid_.angles(number);
    const double turn = azimuth / (2 * pi) + (ring < 0 ? 0.5 : 0.0);
    const double place = (turn - std::floor(turn)) * angles;
    const int below = static_cast<int>(place);
    const auto along = detail::lagrange_weights(place - below);
    for (int i = 0; i < taps; ++i) {
      const int point = ((below - 2 + i) % angles + angles) % angles;
      const float* from = &numbers_[(grid_.first(number) + static_cast<std::size_t>(point)) * row];
      const auto weight = static_cast<float>(share * along[static_cast<std::size_t>(i)]);
      for (std::size_t n = 0; n < row; ++n) sums[n] += weight * from[n];
    }
  }

  Xyz series(const float* sums, double t) const {
    Xyz colour;
    double current = 1, next = t;
    for (int n = 0; n < grid_.shape().terms; ++n) {
      const float* term = sums + 3 * n;
      colour = colour + current * Xyz{term[0], term[1], term[2]};
      current = std::exchange(next, 2 * t * next - current);
    }
    return colour;
  }

  VolumeGrid grid_;
  std::span<const float> numbers_;
};

}  // namespace brdf
