#include "evaluation/advice/sweep_plan.h"

#include <algorithm>
#include <cmath>

#include "brdf/grating_equation.h"
#include "evaluation/methods.h"

namespace evaluation {
namespace {

using brdf::Angle;
using brdf::Length;

/// Steps per full width at half maximum.
constexpr double steps_per_lobe = 3;
/// Orders listed on each side of the mirror direction.
constexpr int most_orders_listed = 20;

/// A grating vector seen from the plane of incidence, turned to its positive half.
struct GratingInPlane {
  double along, across;  ///< cosine and sine of the angle to the plane
};
GratingInPlane in_plane(const HeightPeriod& period, Angle phi_i) {
  const double turned = Angle::deg(period.azimuth.deg() - phi_i.deg()).rad();
  const double along = std::cos(turned), across = std::sin(turned);
  return along < 0 ? GratingInPlane{-along, -across} : GratingInPlane{along, across};
}

/// Where order m goes; empty where it is evanescent.
std::optional<PropagatingOrder> order_direction(int m, const GratingInPlane& grating,
                                                const HeightPeriod& period, double lambda_um,
                                                Angle theta_i) {
  const double across = m * lambda_um / period.period.um() * grating.across;
  const double along = m * lambda_um / period.period.um() * grating.along - std::sin(theta_i.rad());
  if (!(std::hypot(along, across) <= 1)) return std::nullopt;
  // Rounding must not take an order at the horizon beyond it.
  const double leaning = std::sqrt(std::max(1 - across * across, along * along));
  const Angle theta_r = leaning > 0 ? Angle::rad(std::asin(along / leaning)) : Angle{};
  return PropagatingOrder{m, theta_r, Angle::rad(std::asin(across))};
}

OrdersOfPeriod orders_of(std::size_t index, const HeightPeriod& period, double lambda_um,
                         const AdviceScene& scene) {
  const GratingInPlane grating = in_plane(period, scene.request.phi_i);
  const double reach = std::max(lobe_width_sine(scene.surface, scene.request.phi_i, lambda_um) / 2,
                                std::sin(scene.resolution.rad()));
  OrdersOfPeriod orders{index, lambda_um, 0, 0, {}, 0};
  // abs(sine) changes by at most 2 between the horizons.
  const int furthest = static_cast<int>(2 * period.period.um() / lambda_um) + 1;
  for (int m = -furthest; m <= furthest; ++m) {
    const auto order = order_direction(m, grating, period, lambda_um, scene.request.theta_i);
    if (!order) continue;
    orders.first = std::min(orders.first, m);
    orders.last = std::max(orders.last, m);
    if (std::abs(m) <= most_orders_listed) orders.nearest.push_back(*order);
    const double theta_deg = order->theta_r.deg();
    if (m != 0 && std::abs(std::sin(order->out_of_plane.rad())) <= reach &&
        theta_deg >= scene.request.theta_r_deg.front() &&
        theta_deg <= scene.request.theta_r_deg.back())
      ++orders.in_view;
  }
  return orders;
}

/// first, first + step, ... up to last.
Axis even_axis(double first, double last, double step) {
  Axis axis;
  // 1e-9 of a step: a whole number of steps may come out a rounding short.
  const auto steps = static_cast<std::size_t>((last - first) / step + 1e-9);
  for (std::size_t i = 0; i <= steps; ++i)
    axis.values.push_back(first + static_cast<double>(i) * step);
  return axis;
}

std::optional<double> step_of(const Axis& axis) {
  if (axis.size() < 2) return std::nullopt;
  return (axis.back() - axis.front()) / static_cast<double>(axis.size() - 1);
}

}  // namespace

OrdersAdvice advise_orders(const AdviceScene& scene, const SurfaceMeasures& surface) {
  OrdersAdvice advice{OrdersVerdict::no_period, {}};
  for (const std::size_t i : fundamentals(surface))
    for (const double lambda_um : {scene.shortest_um(), scene.longest_um()})
      advice.cases.push_back(orders_of(i, surface.periods[i], lambda_um, scene));
  const auto any = [&](auto holds) {
    return std::any_of(advice.cases.begin(), advice.cases.end(), holds);
  };
  if (any([](const OrdersOfPeriod& orders) { return orders.in_view > 0; }))
    advice.verdict = OrdersVerdict::in_view;
  else if (any([](const OrdersOfPeriod& orders) { return orders.first < 0 || orders.last > 0; }))
    advice.verdict = OrdersVerdict::out_of_view;
  else if (!advice.cases.empty())
    advice.verdict = OrdersVerdict::mirror_only;
  return advice;
}

double rounded_down(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {10.0, 5.0, 2.0})
    // A value that is one of them but for rounding is that one.
    if (digit * decade <= value * (1 + 1e-12)) return digit * decade;
  return decade;
}

StepsAdvice advise_steps(const AdviceScene& scene, const OpticsAdvice& optics) {
  const double lobe_sine = lobe_width_sine(scene.surface, scene.request.phi_i, scene.shortest_um());
  const bool is_geometric = optics.verdict == OpticsVerdict::geometric;
  const double cosine = std::cos(scene.nearest_to_normal().rad());
  StepsAdvice advice{};
  // Facets spread the light by their slopes, the same at all wavelengths.
  advice.feature_sine =
      is_geometric ? optics.slope_lobe.rad() * std::cos(optics.seen_at.rad()) : lobe_sine;
  const double step_sine = advice.feature_sine / steps_per_lobe;
  // A lobe wider than the hemisphere needs no more than a step of a radian.
  advice.needed_theta_deg = Angle::rad(std::min(step_sine / cosine, 1.0)).deg();
  const double moving_nm = Length::um(scene.shortest_um() * step_sine / scene.largest_abs_u()).nm();
  advice.needed_lambda_nm = is_geometric || optics.verdict == OpticsVerdict::mirror
                                ? colour_step_nm
                                : std::min(moving_nm, colour_step_nm);
  advice.theta_deg = rounded_down(advice.needed_theta_deg);
  advice.lambda_nm = rounded_down(advice.needed_lambda_nm);
  if (scene.theta_r_origin == AxisOrigin::asked)
    advice.asked_theta_deg = step_of(scene.request.theta_r_deg);
  if (scene.lambda_origin == AxisOrigin::asked)
    advice.asked_lambda_nm = step_of(scene.request.lambda_nm);
  // 1e-9: the axes' values are decimals, their differences carry rounding.
  const auto too_coarse = [](const std::optional<double>& asked, double needed) {
    return asked && *asked > needed * (1 + 1e-9);
  };
  if (too_coarse(advice.asked_theta_deg, advice.needed_theta_deg) ||
      too_coarse(advice.asked_lambda_nm, advice.needed_lambda_nm))
    advice.verdict = StepsVerdict::too_coarse;
  else if (advice.asked_theta_deg || advice.asked_lambda_nm)
    advice.verdict = StepsVerdict::fine_enough;
  else
    advice.verdict = StepsVerdict::recommended;
  return advice;
}

MethodAdvice advise_method(const AdviceScene& scene, const SurfaceMeasures& surface,
                           const SamplingAdvice& sampling, const HeightsAdvice& heights,
                           const TiltAdvice& tilt, const OpticsAdvice& optics,
                           const StepsAdvice& steps) {
  MethodAdvice advice{optics.verdict,
                      tilt.verdict == TiltVerdict::tilted ? brdf::Level::plane : brdf::Level::none,
                      scene.tolerance,
                      scene.request,
                      {}};
  if (heights.verdict == HeightsVerdict::too_coarse)
    advice.tolerance = std::min(rounded_down(heights.phase_error_rad), 0.5);
  const auto [first, last] = sampling.safe_deg.value_or(
      std::pair(scene.request.theta_r_deg.front(), scene.request.theta_r_deg.back()));
  advice.request.theta_r_deg = even_axis(first, last, steps.theta_deg);
  advice.request.lambda_nm =
      even_axis(scene.request.lambda_nm.front(), scene.request.lambda_nm.back(), steps.lambda_nm);
  if (optics.verdict == OpticsVerdict::geometric) return advice;
  brdf::Surface planned = scene.surface;
  if (advice.level == brdf::Level::plane) planned.heights = &surface.levelled;
  const brdf::QueryBounds bounds = bounds_of(advice.request, advice.tolerance);
  advice.plan = method_named("auto").explain(planned, bounds, MethodSettings{});
  return advice;
}

}  // namespace evaluation
