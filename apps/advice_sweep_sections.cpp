// The sections on the sweep: orders, steps, method.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "apps/advice_report.h"

namespace apps {
namespace {

using evaluation::Advice;
using evaluation::AdviceScene;
using evaluation::Json;
using evaluation::OrdersVerdict;
using evaluation::PropagatingOrder;
using evaluation::StepsVerdict;

const Choices<OrdersVerdict> orders_words{{"in_view", OrdersVerdict::in_view},
                                          {"out_of_view", OrdersVerdict::out_of_view},
                                          {"mirror_only", OrdersVerdict::mirror_only},
                                          {"no_period", OrdersVerdict::no_period}};
const Choices<StepsVerdict> steps_words{{"recommended", StepsVerdict::recommended},
                                        {"fine_enough", StepsVerdict::fine_enough},
                                        {"too_coarse", StepsVerdict::too_coarse}};

std::string orders_sentence(OrdersVerdict verdict) {
  switch (verdict) {
    case OrdersVerdict::in_view:
      return "other orders than the mirror's are in view: sin theta_r = m lambda/d - sin theta_i";
    case OrdersVerdict::out_of_view:
      return "other orders go out of view: sin theta_r = m lambda/d - sin theta_i, or aside";
    case OrdersVerdict::mirror_only:
      return "no order but the mirror's propagates";
    case OrdersVerdict::no_period:
      return "no period, no orders";
  }
  return "?";
}

Json orders_json(const evaluation::OrdersOfPeriod& orders, const Advice& advice) {
  Json nearest = Json::array();
  for (const PropagatingOrder& order : orders.nearest)
    nearest.push_back({{"m", order.order},
                       {"theta_r_deg", order.theta_r.deg()},
                       {"out_of_plane_deg", order.out_of_plane.deg()}});
  return {{"period_um", advice.surface.periods[orders.period].period.um()},
          {"lambda_nm", nm(orders.lambda_um)},
          {"first", orders.first},
          {"last", orders.last},
          {"in_view", orders.in_view},
          {"nearest", nearest}};
}

/// "; +1 at -57.2, +2 at -48.3 deg", the first orders beside 0, as many as there is room for.
std::string nearest_text(const evaluation::OrdersOfPeriod& orders) {
  constexpr std::size_t room = 34;  // of the page's 56, after the condition
  std::vector<PropagatingOrder> shown;
  for (const PropagatingOrder& order : orders.nearest)
    if (order.order != 0) shown.push_back(order);
  std::stable_sort(shown.begin(), shown.end(),
                   [](const PropagatingOrder& a, const PropagatingOrder& b) {
                     return std::abs(a.order) < std::abs(b.order);
                   });
  std::string text;
  for (const PropagatingOrder& order : shown) {
    std::string next = fmt::format("{}{:+d} at {:.1f}", text.empty() ? "; " : ", ", order.order,
                                   order.theta_r.deg());
    // Less is what one decimal shows as 0.
    if (std::abs(order.out_of_plane.deg()) >= 0.05)
      next += fmt::format(" ({:.1f} aside)", std::abs(order.out_of_plane.deg()));
    if (!text.empty() && text.size() + next.size() > room) break;
    text += next;
  }
  return text.empty() ? text : text + " deg";
}

Section orders(const Advice& advice) {
  const evaluation::OrdersAdvice& found = advice.orders;
  Section section{
      "orders", name_in(orders_words, found.verdict), orders_sentence(found.verdict), {}};
  Json all = Json::array();
  for (const auto& orders : found.cases) all.push_back(orders_json(orders, advice));
  section.findings = {{"cases", all, "", "",
                       "sin theta_r = m lambda / d - sin theta_i along the plane of incidence; per "
                       "period the shortest and the longest wavelength"}};
  for (std::size_t i = 0; i < std::min<std::size_t>(found.cases.size(), 2); ++i) {
    const evaluation::OrdersOfPeriod& orders = found.cases[i];
    section.findings.push_back({i == 0 ? "shortest" : "longest",
                                {orders.first, orders.last},
                                "",
                                fmt::format("{:.4g} um, {:.4g} nm: m = {} to {}",
                                            advice.surface.periods[orders.period].period.um(),
                                            nm(orders.lambda_um), orders.first, orders.last),
                                "|sin theta_r| <= 1" + nearest_text(orders)});
  }
  return section;
}

std::string asked_text(const std::optional<double>& asked, const char* unit) {
  return asked ? fmt::format(", asked {:.3g} {}", *asked, unit) : "";
}

Json or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

std::string steps_sentence(StepsVerdict verdict) {
  switch (verdict) {
    case StepsVerdict::recommended:
      return "three steps a lobe";
    case StepsVerdict::fine_enough:
      return "the steps asked for resolve a lobe";
    case StepsVerdict::too_coarse:
      return "the steps asked for are too coarse to resolve a lobe";
  }
  return "?";
}

Section steps(const Advice& advice, const AdviceScene& scene) {
  const evaluation::StepsAdvice& found = advice.steps;
  return {
      "steps",
      name_in(steps_words, found.verdict),
      steps_sentence(found.verdict),
      {{"theta_r", found.theta_deg, "deg",
        fmt::format("theta_r {:.3g} deg{}", found.theta_deg,
                    asked_text(found.asked_theta_deg, "deg")),
        fmt::format("<= {:.3g} = lobe/3/cos theta_r, sine {:.3g}/3, at {} deg",
                    found.needed_theta_deg, found.feature_sine,
                    angle_text(scene.nearest_to_normal()))},
       {"theta_r_needed", found.needed_theta_deg, "deg", "",
        "width at half maximum / 3 / cos theta_r"},
       {"theta_r_asked", or_null(found.asked_theta_deg), "deg", "", "null where it is not given"},
       {"lambda", found.lambda_nm, "nm",
        fmt::format("lambda {:.3g} nm{}", found.lambda_nm, asked_text(found.asked_lambda_nm, "nm")),
        fmt::format("<= {:.3g} = d cos theta_r dtheta/m = lambda dsine/|u|, 5",
                    found.needed_lambda_nm)},
       {"lambda_needed", found.needed_lambda_nm, "nm", "",
        "moves an order at the largest |u| by a third of the lobe; at most 5 nm, for colour"},
       {"lambda_asked", or_null(found.asked_lambda_nm), "nm", "", "null where it is not given"}}};
}

std::string memory_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.3g} MB", bytes / 1e6)
                     : fmt::format("{:.3g} GB", bytes / 1e9);
}

Section method(const Advice& advice, const AdviceScene& scene) {
  const evaluation::MethodAdvice& found = advice.method;
  const double cells = static_cast<double>(found.request.cells());
  if (found.optics == evaluation::OpticsVerdict::geometric)
    return {"method",
            "microfacet",
            "microfacet: facets with the slopes of the surface, no transform",
            {{"roughness", advice.surface.rms_slope, "",
              fmt::format("roughness {:.3g}", advice.surface.rms_slope),
              "RMS slope of the levelled heights (Beckmann's alpha)"},
             {"cells", found.request.cells(), "", fmt::format("{:.3g} cells", cells),
              "wavelengths x viewing angles, with the steps above"}}};
  const double seconds = found.plan.at("expected_seconds_one_thread").get<double>();
  const double bytes = found.plan.at("bytes").get<double>();
  const std::string path = found.plan.at("path").get<std::string>();
  std::string terms = "every pixel";
  if (found.plan.contains("terms")) {
    const int count = found.plan.at("terms").get<int>();
    terms = fmt::format("{} term{}", count, count == 1 ? "" : "s");
  }
  return {"method",
          "auto",
          fmt::format("auto: {}, {}, tolerance {:.3g}", path, terms, found.tolerance),
          {{"tolerance", found.tolerance, "", "",
            found.tolerance == scene.tolerance ? "as asked" : "what the stored heights can bear"},
           {"path", path, "", "", "chosen by the request's bounds"},
           {"plan", found.plan, "", "", "as sweep --explain"},
           {"seconds", seconds, "s",
            fmt::format("{:.2g} s on one thread, {}", seconds, memory_text(bytes)),
            fmt::format("{:.3g} cells of the sweep below, at their known cost", cells)},
           {"bytes", bytes, "B", "", "held by the plan"},
           {"cells", found.request.cells(), "", "", "wavelengths x viewing angles"}}};
}

}  // namespace

std::vector<Section> sweep_sections(const Advice& advice, const AdviceScene& scene) {
  return {orders(advice), steps(advice, scene), method(advice, scene)};
}

}  // namespace apps
