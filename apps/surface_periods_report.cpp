#include "apps/surface_periods_report.h"

#include <fmt/format.h>

namespace apps {
namespace {

using evaluation::Interval;
using evaluation::Json;
using evaluation::LightPeriod;
using evaluation::LocalPeriod;
using evaluation::PeriodEstimate;
using evaluation::SurfacePeriod;

Json json_of(const Interval& interval) {
  return {interval.lo, interval.hi};
}

Json json_of(const std::vector<LocalPeriod>& places) {
  Json list = Json::array();
  for (const LocalPeriod& one : places)
    list.push_back({{"x_um", one.x_um}, {"y_um", one.y_um}, {"period_nm", one.period_nm}});
  return list;
}

Json json_of(const std::optional<LightPeriod>& light) {
  if (!light) return nullptr;
  return {{"period_nm", light->period_nm},
          {"interval_nm", json_of(light->interval_nm)},
          {"lambda_nm", light->lambdas_nm}};
}

Json json_of(const PeriodEstimate& estimate) {
  Json json{{"period_nm", estimate.period_nm},
            {"interval_nm", json_of(estimate.interval_nm)},
            {"azimuth_deg", estimate.frequency.azimuth().deg()},
            {"uncertainty_nm",
             {{"fit", estimate.parts.fit_nm},
              {"drift", estimate.parts.drift_nm},
              {"sub_patches", estimate.parts.patches_nm},
              {"window_positions", estimate.parts.window_nm}}},
            {"by_sub_patch", json_of(estimate.by_patch)},
            {"by_window_position", json_of(estimate.by_window)}};
  if (estimate.lines > 0) {
    json["lines"] = estimate.lines;
    json["drift_probability"] = estimate.drift_share;
    json["bow_probability"] = estimate.bow_share;
  }
  return json;
}

std::string light_line(const char* side, const std::optional<LightPeriod>& light) {
  if (!light) return fmt::format("   light, {:<6} its lobes cannot be told\n", side);
  std::string lambdas;
  for (const double lambda : light->lambdas_nm)
    lambdas += (lambdas.empty() ? "" : ", ") + fmt::format("{:.0f}", lambda);
  return fmt::format("   light, {:<6} {:.3f} nm, 95 % {:.3f} to {:.3f} nm (at {} nm)\n", side,
                     light->period_nm, light->interval_nm.lo, light->interval_nm.hi, lambdas);
}

std::string parts_line(const PeriodEstimate& estimate) {
  const auto& parts = estimate.parts;
  std::string text = fmt::format("   uncertainty   fit {:.3g}", parts.fit_nm);
  if (estimate.lines > 0) text += fmt::format(", drift {:.3g}", parts.drift_nm);
  if (!estimate.by_patch.empty()) text += fmt::format(", sub-patches {:.3g}", parts.patches_nm);
  text += fmt::format(", window positions {:.3g} nm (standard deviations)", parts.window_nm);
  if (estimate.lines > 0)
    text += fmt::format("; {} lines, drifting with probability {:.2f}, bowed {:.2f}",
                        estimate.lines, estimate.drift_share, estimate.bow_share);
  return text + "\n";
}

std::string section(std::size_t number, const SurfacePeriod& period) {
  const auto& found = period.found;
  if (!period.heights)
    return fmt::format("{}  about {:.4g} nm, azimuth {:.2f} deg: no period is given, {}\n", number,
                       found.period.nm(), found.azimuth.deg(), period.reason);
  const PeriodEstimate& estimate = *period.heights;
  return fmt::format("{}  period {:.3f} nm, 95 % {:.3f} to {:.3f} nm, azimuth {:.2f} deg{}\n",
                     number, estimate.period_nm, estimate.interval_nm.lo, estimate.interval_nm.hi,
                     estimate.frequency.azimuth().deg(),
                     period.in_group ? "; one of several close together" : "") +
         parts_line(estimate) + light_line("left", period.left) +
         light_line("right", period.right) +
         fmt::format("   heights and light {}\n", period.agree() ? "agree" : "do not agree");
}

}  // namespace

Json to_json(const std::vector<SurfacePeriod>& periods) {
  Json list = Json::array();
  for (const SurfacePeriod& period : periods) {
    Json one{{"spectrum",
              {{"period_nm", period.found.period.nm()},
               {"azimuth_deg", period.found.azimuth.deg()},
               {"depth_nm", brdf::Length::um(period.found.depth_um).nm()},
               {"share_of_variance", period.found.share}}}};
    if (period.heights) {
      one.update(json_of(*period.heights));
      one["light_left"] = json_of(period.left);
      one["light_right"] = json_of(period.right);
      one["agree"] = period.agree();
      one["in_group"] = period.in_group;
    } else {
      one["reason"] = period.reason;
    }
    list.push_back(std::move(one));
  }
  Json json{{"periods", std::move(list)}};
  if (const auto lattice = evaluation::lattice_of(periods))
    json["lattice"] = {lattice->first + 1, lattice->second + 1};
  return json;
}

std::string for_people(const std::vector<SurfacePeriod>& periods) {
  std::string text;
  for (std::size_t i = 0; i < periods.size(); ++i) text += section(i + 1, periods[i]);
  if (const auto lattice = evaluation::lattice_of(periods))
    text += fmt::format("lattice of {} and {}\n", lattice->first + 1, lattice->second + 1);
  return text;
}

}  // namespace apps
