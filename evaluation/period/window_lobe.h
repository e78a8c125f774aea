// The lobe of the coherence window, made ready to be asked many times.
#pragma once

#include <vector>

#include "brdf/amplitude.h"
#include "brdf/surface.h"

namespace evaluation {

/// The illumination of a patch, and the line in it that the scattering vectors run along.
struct Illumination {
  brdf::SurfaceModel model;
  brdf::GaussianWindow window;  ///< the replicated model ignores it
  brdf::SurfaceAxis x, y;       ///< as of `brdf::x_axis`
  brdf::LineDirection line;

  double lobe(double q_per_um) const;
};

/// W(q), the real transform of the illumination along the line, 1 at q = 0; and what of it reaches
/// far: the sidelobes of its cut edges.
class WindowLobe {
 public:
  /// Throws Errc::not_attainable where there is no lobe: a single pixel along the line.
  explicit WindowLobe(const Illumination& illumination);

  /// W at abs(q) <= reach(); beyond it, of `Illumination`. Within 1e-8 of the peak (cubic through
  /// samples at extent h = 0.05).
  double operator()(double q_per_um) const;

  /// Where the power W^2 is one half [rad/um].
  double half_width_per_um() const { return half_width_per_um_; }
  double reach_per_um() const { return reach_per_um_; }
  /// Half of the length that is lit along the line [um]: sidelobes are sines of q times it.
  double half_length_um() const { return half_length_um_; }
  /// The illumination at a distance from the middle along the line, 1 there.
  double illumination(double x_um) const;
  /// The sidelobes of a cut edge at q are at most this over q [rad/um]: 2 g(edge) / Int g; 0 of the
  /// periodic model.
  double edge_per_um() const { return edge_per_um_; }
  /// The lobe without its sidelobes, exp(-sigma^2 q^2 / 2); 0 for the replicated model.
  double core(double q_per_um) const;

 private:
  Illumination illumination_;
  double half_width_per_um_, reach_per_um_, half_length_um_, edge_per_um_, step_per_um_;
  std::vector<double> samples_;  ///< the first at -step
};

}  // namespace evaluation
