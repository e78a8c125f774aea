// Advice on the model: coherence, diffraction or geometric optics, the limits of scalar theory.
#pragma once

#include <optional>
#include <vector>

#include "brdf/scalar_validity.h"
#include "evaluation/advice/scene.h"

namespace evaluation {

enum class WindowVerdict {
  smooth,    ///< isolated: the window has faded at the patch's edge
  cut,       ///< isolated: the edge cuts it, which makes sidelobes
  repeated,  ///< periodic: the whole Gaussian, over copies of the patch
  even,      ///< replicated: no window
};

struct CoherenceAdvice {
  WindowVerdict verdict;
  double sigma_um, area_um2;
  double length_um;                    ///< in the plane of incidence, see coherence_length_um
  double edge_x, edge_y;               ///< exp(-(L/2)^2 / (2 sigma^2))
  std::vector<double> periods_inside;  ///< coherence length along each period / the period
};
CoherenceAdvice advise_coherence(const AdviceScene& scene, const SurfaceMeasures& surface);

/// The jump that the edge leaves in the window. Its sidelobes are below this part of the
/// amplitude's peak, of the power 1e-4: as far down as the eye sees beside a bright order.
inline constexpr double smooth_edge = 1e-2;

enum class OpticsVerdict {
  mirror,       ///< nothing but the mirror lobe, to the tolerance
  diffraction,  ///< the wave must be computed
  geometric,    ///< rays off facets say the same to this viewer
};

/// What decided an OpticsVerdict.
enum class OpticsReason {
  no_phase,  ///< the heights move the phase by less than the tolerance
  resolved,  ///< the viewer sees orders, or grains of speckle, apart
  shallow,   ///< unresolved, but the heights are too low for rays
  deep,      ///< unresolved, and deep
};

struct OpticsAdvice {
  OpticsVerdict verdict;
  OpticsReason reason;
  std::optional<std::size_t> period;  ///< whose orders are furthest apart; empty without a period
  brdf::Angle spacing;  ///< of its orders, or the lobe's own width: the size of a grain of speckle
  brdf::Angle lobe_width;  ///< full, at half maximum; like the spacing at the longest wavelength
  brdf::Angle seen_at;     ///< viewing angle nearest to the mirror direction
  double phase_depth_rad;  ///< k abs(w) peak to valley, there and at the longest wavelength
  brdf::Angle slope_lobe;  ///< full width at half maximum of the light that facets mirror, there
};
OpticsAdvice advise_optics(const AdviceScene& scene, const SurfaceMeasures& surface);

/// Half a turn between the highest and the lowest point: two times Rayleigh's limit of a rough
/// surface, pi / 2. At less, part of the light is still mirrored as by a plane.
inline constexpr double deep_phase_rad = brdf::pi;

/// One period at one wavelength against the rigorous limits.
struct ScalarCase {
  std::size_t period;  ///< index among the measured periods
  double lambda_um, period_over_lambda;
  double component_over_lambda;       ///< peak to valley of the component
  double peak_to_valley_over_lambda;  ///< of all heights
  brdf::ScalarLimit limit;
  brdf::ScalarVerdict verdict;
};

struct ScalarAdvice {
  std::optional<brdf::ScalarVerdict> verdict;  ///< the worst; empty without a period
  std::vector<ScalarCase> cases;               ///< shortest, then longest wavelength of each period
};
ScalarAdvice advise_scalar(const AdviceScene& scene, const SurfaceMeasures& surface);

/// Indices of the periods that are no harmonics.
std::vector<std::size_t> fundamentals(const SurfaceMeasures& surface);

}  // namespace evaluation
