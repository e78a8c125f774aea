// Making a colour volume.
#pragma once

#include <vector>

#include "brdf/colour_volume.h"
#include "brdf/spectral_integral.h"
#include "evaluation/scattering_colours.h"
#include "evaluation/sweep.h"

namespace evaluation {

/// The grid that a surface needs: V is a sum over pairs of its points of exp(i k s . d), d as far
/// as `reach`, blurred by the eye's functions over k. Two points for the shortest period of either
/// along a ring and near the middle; the ratio of the rings by how far the blur lets the radius
/// oscillate (`brdf::BandQuadratures::alias`); the terms in w by Jacobi-Anger.
///
/// tolerance: 0 to 1, exclusive, of the local brightness.
brdf::VolumeShape volume_shape(const brdf::InterferenceReach& reach, double tolerance);

/// Scattering vectors at the corners of what a volume is made of: a plan for them is one for all.
std::vector<Eigen::Vector3d> volume_corners(const brdf::VolumeGrid& grid);

/// The numbers of a volume, as `brdf::ColourVolume` reads them. Bit-identical for any number of
/// threads. Throws as `colours_of`.
std::vector<float> bake(const brdf::VolumeGrid& grid, const ScatteringColours& colours,
                        const RunLimits& limits, const Progress& progress = {});

/// Scattering vectors of light and viewer from directions spread evenly over both hemispheres, the
/// same in every run.
std::vector<Eigen::Vector3d> spread_scattering(int count);

/// What the errors of a volume are held against: the luminance about a place, its mean over nine
/// places of its ring, one lobe apart, but at least `darkest`.
struct LocalBrightness {
  double lobe;  ///< distance in (u, v)
  double darkest;
};

/// Errors of the luminance as parts of the local brightness.
struct VolumeError {
  double rms = 0, worst = 0;
};

/// exact: the colours at the scattering vectors.
VolumeError volume_error(const brdf::ColourVolume& volume,
                         std::span<const Eigen::Vector3d> scattering,
                         std::span<const brdf::Xyz> exact, const LocalBrightness& brightness);

/// V from a volume. Refers to its numbers.
class BakedColours final : public ScatteringColours {
 public:
  explicit BakedColours(brdf::ColourVolume volume) : volume_(std::move(volume)) {}
  void evaluate(std::span<const Eigen::Vector3d> scattering,
                std::span<brdf::Xyz> colours) const override {
    for (std::size_t j = 0; j < scattering.size(); ++j)
      colours[j] = volume_(scattering[j].x(), scattering[j].y(), scattering[j].z());
  }

 private:
  brdf::ColourVolume volume_;
};

}  // namespace evaluation
