// Advice on the sweep: orders to be seen, steps that resolve them, and the method with its cost.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "brdf/levelling.h"
#include "evaluation/advice/input.h"
#include "evaluation/advice/optics.h"

namespace evaluation {

/// A direction that light of one order takes.
struct PropagatingOrder {
  int order;
  brdf::Angle theta_r;       ///< signed, in the plane of incidence
  brdf::Angle out_of_plane;  ///< how far it leaves that plane
};

/// The orders of one period at one wavelength.
struct OrdersOfPeriod {
  std::size_t period;
  double lambda_um;
  int first, last;                        ///< of those that propagate; 0 always does
  std::vector<PropagatingOrder> nearest;  ///< at most 41, around 0
  int in_view;  ///< other than 0 in the plane and among the viewing angles
};

enum class OrdersVerdict {
  in_view,      ///< others than 0 lie in the plane and among the viewing angles
  out_of_view,  ///< others propagate, but not there
  mirror_only,  ///< order 0 alone propagates
  no_period,
};

struct OrdersAdvice {
  OrdersVerdict verdict;
  std::vector<OrdersOfPeriod> cases;  ///< shortest, then longest wavelength of each period
};
/// sin theta_r = m lambda / d - sin theta_i along the plane of incidence; an order counts as in the
/// plane where it leaves it by at most half a lobe or the viewer's resolution.
OrdersAdvice advise_orders(const AdviceScene& scene, const SurfaceMeasures& surface);

enum class StepsVerdict { recommended, fine_enough, too_coarse };

/// A third of a lobe: of a Gaussian its top is then hit to 8 %, its power summed to 1e-13.
struct StepsAdvice {
  StepsVerdict verdict;
  double feature_sine;  ///< full width at half maximum of what must be resolved
  double needed_theta_deg, needed_lambda_nm;  ///< largest that resolve it
  double theta_deg, lambda_nm;                ///< the same, rounded down to 1, 2 or 5 x 10^n
  std::optional<double> asked_theta_deg, asked_lambda_nm;
};
StepsAdvice advise_steps(const AdviceScene& scene, const OpticsAdvice& optics);

/// The trapezoid of colours takes at most this step whatever the lobes are (physics.md).
inline constexpr double colour_step_nm = 5;

struct MethodAdvice {
  OpticsVerdict optics;
  brdf::Level level;            ///< plane where the input is tilted
  double tolerance;             ///< as asked, or what the heights can bear
  SweepRequest request;         ///< with the steps recommended, and angles that are sampled
  nlohmann::ordered_json plan;  ///< of the method auto; empty for geometric optics
};
MethodAdvice advise_method(const AdviceScene& scene, const SurfaceMeasures& surface,
                           const SamplingAdvice& sampling, const HeightsAdvice& heights,
                           const TiltAdvice& tilt, const OpticsAdvice& optics,
                           const StepsAdvice& steps);

/// The largest of 1, 2, 5 x 10^n that is <= value. value: > 0.
double rounded_down(double value);

}  // namespace evaluation
