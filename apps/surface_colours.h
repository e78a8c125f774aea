// Colours of a surface for the pictures of it: from a height field, or from a volume baked of one.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "apps/commands/checkpoint_options.h"
#include "apps/commands/geometric_options.h"
#include "apps/commands/illuminated_options.h"
#include "apps/commands/optics_options.h"
#include "apps/commands/run_options.h"
#include "apps/commands/selection_options.h"
#include "apps/options.h"
#include "apps/patch_colours.h"
#include "brdf/colour_volume.h"
#include "evaluation/direction_colours.h"

namespace apps {

/// Colours, and what a sidecar says of how they were made.
struct SurfaceColours {
  std::vector<brdf::Xyz> xyz;
  double seconds = 0;  ///< that the colours took, without reading and planning
  std::string input_sha256;
  evaluation::Json parameters, error;
  /// Sine of the angle around the mirror direction that the lobe of order 0 fills; 0 without one.
  double mirror_radius = 0;
  std::shared_ptr<evaluation::Checkpoint> checkpoint;  ///< null without one

  /// "205892 colours in 0.052 s"
  std::string summary() const;
};

/// Sine of the angle that the lobe of order 0 reaches at 780 nm: 4 sigma_f of the window, or four
/// zeros of a replicated surface.
double mirror_radius(const brdf::Surface& surface);

/// The options that `map`, `render` and `bake` share: the surface, its light and how exact it is.
class SurfaceColourOptions {
 public:
  /// Adds the positional FILE and all options of the surface.
  void add_to(CLI::App* app);
  const std::string& file() const { return heights_.file; }
  /// The colours of all pairs, with a progress line, warnings and an audit. The pairs are best
  /// listed block by block (evaluation/direction_colours.h).
  /// request: what the pairs come from, for a checkpoint of them.
  SurfaceColours colours(std::span<const evaluation::DirectionPair> pairs,
                         const CheckpointOptions& checkpoint = {},
                         const evaluation::Json& request = evaluation::Json::object()) const;

  /// Refuses what no volume can be made of: a volume, and a model without diffraction.
  void require_bakeable() const;
  /// The patch of a height file.
  std::unique_ptr<PatchColours> read_patch() const;
  /// Makes it ready for `count` colours at scattering vectors inside the box around those given.
  void prepare(PatchColours& patch, std::span<const Eigen::Vector3d> scattering,
               std::size_t count) const;
  /// The grid of a volume of a patch.
  brdf::VolumeGrid volume_grid(const PatchColours& patch) const;
  /// Amplitudes held against the direct sum; for the sidecar. Warns where they miss the tolerance.
  evaluation::Json audited(const PatchColours& patch,
                           std::span<const Eigen::Vector3d> scattering) const;
  brdf::Quantity quantity() const;
  const RunOptions& run() const { return run_; }

 private:
  void require_consistent() const;
  void require_free_of_patch_options() const;
  double tolerance() const;
  double colour_tolerance() const;
  /// First and last of the wavelengths.
  brdf::SpectralBand band() const;
  bool is_geometric() const { return GeometricOptions::has(method_); }
  std::vector<brdf::Length> wavelengths() const;
  evaluation::SpectralIntegral integral(const brdf::Surface& surface,
                                        std::span<const Eigen::Vector3d> scattering) const;
  evaluation::Json integral_json(const brdf::Surface& surface) const;
  OpticsOptions resolved_optics() const;
  void check_sampling(std::span<const Eigen::Vector3d> scattering,
                      const brdf::HeightField& field) const;
  /// Computes the colours of a result whose input and parameters are known.
  using Evaluate =
      std::function<void(const evaluation::DirectionColours& colours, SurfaceColours& result)>;
  SurfaceColours diffraction(std::span<const evaluation::DirectionPair> pairs,
                             const Evaluate& evaluate) const;
  SurfaceColours geometric(const Evaluate& evaluate) const;
  SurfaceColours baked(const Evaluate& evaluate) const;

  HeightOptions heights_;
  IlluminatedOptions illuminated_;
  OpticsOptions optics_;
  GeometricOptions geometric_;
  SelectionOptions selection_;
  std::string method_ = "auto";
  std::optional<double> tolerance_, colour_tolerance_;
  std::optional<evaluation::Axis> lambda_nm_;
  std::optional<int> audit_;
  RunOptions run_;
};

}  // namespace apps
