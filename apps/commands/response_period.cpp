#include "apps/commands/response_period.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/joint_scene.h"
#include "apps/options.h"
#include "evaluation/period/joint_fit.h"
#include "evaluation/period/ridges.h"

namespace apps {
namespace {

using brdf::Errc;
using brdf::Error;
using evaluation::Json;
using evaluation::Relief;

const Choices<PeriodBy> by_choices{{"lobes", PeriodBy::lobes}, {"peaks", PeriodBy::peaks}};
const Choices<Relief> relief_choices{{"edges", Relief::may_have_edges}, {"smooth", Relief::smooth}};

/// How far a ridge's period, which the slope of the efficiency shifts, may lie from that of the
/// lobes.
constexpr double same_ridge = 0.02;
/// Of its strength, from which another ridge of the same order speaks for a second period.
constexpr double rival_strength = 0.3;
constexpr const char* hint =
    "`shedlight ridges` lists what there is, --by peaks follows the brightest angles";

/// "none", all of a few, or the number and the span of many.
std::string outliers_text(const Json& lambdas_nm) {
  constexpr std::size_t few = 8;
  if (lambdas_nm.empty()) return "none";
  if (lambdas_nm.size() > few)
    return fmt::format("{} wavelengths between {} and {} nm; --json names them", lambdas_nm.size(),
                       lambdas_nm.front().get<double>(), lambdas_nm.back().get<double>());
  std::string names;
  for (const auto& lambda : lambdas_nm)
    names += (names.empty() ? "" : ", ") + evaluation::number_text(lambda.get<double>());
  return names + " nm";
}

/// The fit to the brightest angles, and the sources' own estimate.
Json by_peaks(const ResponseInput& input, const std::string& file) {
  const std::vector<evaluation::Peak> peaks = input.peaks();
  const int order = input.search.order;
  const evaluation::PeriodFit fit = brdf::at_place(
      file, [&] { return fit_period(peaks, input.plane, order, input.angle_step_deg()); });
  if (fit.status != evaluation::FitStatus::converged)
    throw Error(Errc::not_attainable, file + ": the fit did not converge: " + fit.message);
  const evaluation::PeriodSpread spread = period_spread(peaks, input.plane, order);
  Json result;
  result["by"] = "peaks";
  result["period_nm"] = fit.period_nm;
  result["std_error_nm"] = fit.std_error_nm;
  result["order"] = order;
  result["side"] = evaluation::side_of(order);
  result["outliers"] = fit.outlier_lambdas_nm;
  result["status"] = "converged";
  result["source_mean_nm"] = spread.mean_nm;
  result["source_std_nm"] = spread.std_nm;
  result["wavelengths"] = peaks.size();
  result["wavelengths_with_peak"] = fit.residuals_deg.size();
  return result;
}

/// Refuses a period that no ridge stands for, and one of several.
void require_one_ridge(const ResponseInput& input, double period_nm, const std::string& file) {
  evaluation::RidgeSearch search;
  search.period_guess = brdf::Length::nm(period_nm);
  search.theta_r_deg = input.search.theta_r_deg;
  search.floor = input.search.floor;
  const auto found = find_ridges(input.response, input.plane, search);
  const auto refuse = [&](const std::string& why) {
    throw Error(Errc::not_attainable,
                fmt::format("{}: no period is given: {}; {}", file, why, hint));
  };
  const auto own = std::ranges::find_if(found.ridges, [&](const evaluation::Ridge& ridge) {
    return std::abs(ridge.period_nm / period_nm - 1) <= same_ridge;
  });
  if (own == found.ridges.end())
    refuse(fmt::format("no ridge at {:.4g} nm stands {:g} times above the background", period_nm,
                       search.least_contrast));
  const auto rivals = std::ranges::count_if(found.ridges, [&](const evaluation::Ridge& ridge) {
    return ridge.order == own->order && &ridge != &*own &&
           ridge.strength >= rival_strength * own->strength;
  });
  if (rivals > 0)
    refuse(
        fmt::format("{} ridges of order {:+d} are of its strength, this surface has no single "
                    "period",
                    rivals + 1, own->order.value_or(0)));
}

Json by_lobes(const ResponsePeriodOptions& options, const ResponseInput& input, Json peaks) {
  const std::string& file = options.response.file;
  evaluation::JointScene scene = joint_scene(input, file);
  scene.relief = options.relief.value_or(Relief::may_have_edges);
  const brdf::Length start = brdf::Length::nm(peaks["period_nm"].get<double>());
  const evaluation::JointFit fit = [&] {
    try {
      return fit_period_jointly(input.response, scene, start);
    } catch (const Error& error) {
      if (error.code() != Errc::not_attainable) throw;
      throw Error(Errc::not_attainable,
                  fmt::format("{}: no period is given: {}; --by peaks follows the brightest angles",
                              file, error.what()));
    }
  }();
  if (fit.status != evaluation::JointStatus::converged)
    throw Error(Errc::not_attainable, fmt::format("{}: no period is given: {}; {}", file,
                                                  fit.status == evaluation::JointStatus::cannot_tell
                                                      ? "it could lie anywhere within a tenth of it"
                                                      : "the fit did not converge: " + fit.message,
                                                  hint));
  require_one_ridge(input, fit.period_nm, file);
  Json result{{"by", "lobes"}, {"period_nm", fit.period_nm}};
  result["interval_nm"] = {fit.low_nm, fit.high_nm};
  result["uncertainty_nm"] = {{"fit", fit.uncertainty_nm.fit},
                              {"orders", fit.uncertainty_nm.orders},
                              {"wavelength_blocks", fit.uncertainty_nm.blocks},
                              {"pixel", fit.uncertainty_nm.pixel},
                              {"model", fit.uncertainty_nm.model}};
  result["relief"] = name_in(relief_choices, scene.relief);
  result["lobe_width"] = fit.relative_width;
  result["explained"] = fit.explained;
  result["orders"] = fit.orders;
  result["wavelengths"] = fit.wavelengths;
  result["cells"] = fit.cells;
  result["status"] = "converged";
  result["peaks"] = std::move(peaks);
  return result;
}

std::string peaks_text(const Json& result) {
  const auto number = [&](const char* key) { return result[key].get<double>(); };
  return fmt::format(
             "period by peaks   {:.3f} nm, standard error of the fit {:.3f} nm (converged)\n"
             "order             {:+d}, {}; {} of {} wavelengths have a peak\n"
             "sources' way      {:.3f} nm mean, {:.3f} nm standard deviation over the "
             "wavelengths\n",
             number("period_nm"), number("std_error_nm"), result["order"].get<int>(),
             result["side"].get<std::string>(), result["wavelengths_with_peak"].get<std::size_t>(),
             result["wavelengths"].get<std::size_t>(), number("source_mean_nm"),
             number("source_std_nm")) +
         "outliers          " + outliers_text(result["outliers"]) + "\n";
}

}  // namespace

void ResponsePeriodOptions::add_to(CLI::App* app) {
  response.add_settings_to(app);
  add_choice(app, "--by", by, by_choices,
             "all lobes at once, or the brightest angle of each wavelength (default lobes, where a "
             "sidecar says how the response came about)");
  add_choice(app, "--relief", relief, relief_choices,
             "lobes: smooth leaves out what sharp edges rounded to pixels would make uncertain "
             "(default edges)");
}

Json response_period(const ResponsePeriodOptions& options) {
  const ResponseInput input = options.response.read();
  const PeriodBy by = options.by.value_or(
      has_joint_scene(input, options.response.file) ? PeriodBy::lobes : PeriodBy::peaks);
  if (by == PeriodBy::peaks && options.relief)
    throw Error(Errc::invalid_argument, "--relief has no meaning for --by peaks");
  Json peaks = by_peaks(input, options.response.file);
  return by == PeriodBy::peaks ? peaks : by_lobes(options, input, std::move(peaks));
}

std::string response_period_text(const Json& result) {
  if (result["by"] == "peaks") return peaks_text(result);
  const auto number = [&](const char* key) { return result[key].get<double>(); };
  const Json& parts = result["uncertainty_nm"];
  const auto part = [&](const char* key) { return parts[key].get<double>(); };
  return fmt::format(
             "period            {:.3f} nm, 95 % {:.3f} to {:.3f} nm\n"
             "uncertainty       fit {:.2g}, orders {:.2g}, wavelengths {:.2g}, pixel {:.2g}, model "
             "{:.2g} nm (standard deviations)\n"
             "from              {} orders, {} wavelengths; lobes {:.2f} times as wide as the "
             "window's\n",
             number("period_nm"), result["interval_nm"][0].get<double>(),
             result["interval_nm"][1].get<double>(), part("fit"), part("orders"),
             part("wavelength_blocks"), part("pixel"), part("model"), result["orders"].get<int>(),
             result["wavelengths"].get<int>(), number("lobe_width")) +
         peaks_text(result["peaks"]);
}

}  // namespace apps
