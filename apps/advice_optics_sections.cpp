// The sections on the model: window, diffraction or geometric optics, scalar theory.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/advice_report.h"

namespace apps {
namespace {

using brdf::ScalarVerdict;
using evaluation::Advice;
using evaluation::AdviceScene;
using evaluation::Json;
using evaluation::OpticsReason;
using evaluation::OpticsVerdict;
using evaluation::ScalarCase;
using evaluation::WindowVerdict;

const Choices<WindowVerdict> window_words{{"smooth", WindowVerdict::smooth},
                                          {"cut", WindowVerdict::cut},
                                          {"repeated", WindowVerdict::repeated},
                                          {"even", WindowVerdict::even}};
const Choices<OpticsVerdict> optics_words{{"mirror", OpticsVerdict::mirror},
                                          {"diffraction", OpticsVerdict::diffraction},
                                          {"geometric", OpticsVerdict::geometric}};
const Choices<OpticsReason> reason_words{{"no_phase", OpticsReason::no_phase},
                                         {"resolved", OpticsReason::resolved},
                                         {"shallow", OpticsReason::shallow},
                                         {"deep", OpticsReason::deep}};
const Choices<ScalarVerdict> scalar_words{{"valid", ScalarVerdict::valid},
                                          {"doubtful", ScalarVerdict::doubtful},
                                          {"invalid", ScalarVerdict::invalid}};
const Choices<brdf::TablePlace> place_words{{"below", brdf::TablePlace::below},
                                            {"inside", brdf::TablePlace::inside},
                                            {"beyond", brdf::TablePlace::beyond}};

std::string window_sentence(WindowVerdict verdict) {
  switch (verdict) {
    case WindowVerdict::smooth:
      return "isolated patch: the window has faded at its edge";
    case WindowVerdict::cut:
      return "isolated patch: its edge cuts the window, expect sidelobes between the orders";
    case WindowVerdict::repeated:
      return "periodic: the whole window over copies of the patch, no edge";
    case WindowVerdict::even:
      return "replicated: evenly lit copies, sidelobes of a sharp edge";
  }
  return "?";
}

Section window(const Advice& advice, const AdviceScene& scene) {
  const evaluation::CoherenceAdvice& found = advice.coherence;
  const bool has_window = scene.surface.model != brdf::SurfaceModel::replicated;
  Section section{
      "window", name_in(window_words, found.verdict), window_sentence(found.verdict), {}};
  section.findings = {
      {"coherence_length", found.length_um, "um",
       fmt::format("coherent {} um, area {:.3g} um2", short_text(found.length_um), found.area_um2),
       has_window ? fmt::format("lambda / lobe width in the plane; sigma {:.4g} um", found.sigma_um)
                  : "lambda / lobe width in the plane; (Int g)^2 / Int g^2"},
      {"coherence_area", found.area_um2, "um2", "",
       "(Int g)^2 / Int g^2, 4 pi sigma^2 of a whole window"},
      {"periods_inside", found.periods_inside, "",
       found.periods_inside.empty()
           ? ""
           : fmt::format("{:.3g} periods inside", found.periods_inside.front()),
       "coherence length/period = order spacing/lobe width"}};
  if (has_window) {
    section.findings.push_back({"sigma", found.sigma_um, "um", "",
                                "of the window, as asked or a quarter of the shorter side"});
    section.findings.push_back(
        {"edge",
         {found.edge_x, found.edge_y},
         "",
         fmt::format("edge {:.2g}, {:.2g} (x, y)", found.edge_x, found.edge_y),
         fmt::format("exp(-(L/2)^2/(2 sigma^2)); smooth up to {}", evaluation::smooth_edge)});
  }
  return section;
}

std::string optics_sentence(const evaluation::OpticsAdvice& found) {
  switch (found.reason) {
    case OpticsReason::no_phase:
      return "only the mirror lobe: the heights move the phase by less than the tolerance";
    case OpticsReason::resolved:
      return found.period ? "diffraction is needed: the orders are seen apart"
                          : "diffraction is needed: the grains of the speckle are seen apart";
    case OpticsReason::shallow:
      return "diffraction is needed: nothing is seen apart, but it is too shallow for rays";
    case OpticsReason::deep:
      return found.period
                 ? "geometric optics is enough: the orders blur, and the surface is deep"
                 : "geometric optics is enough: the speckle blurs, and the surface is deep";
  }
  return "?";
}

Section optics(const Advice& advice, const AdviceScene& scene) {
  const evaluation::OpticsAdvice& found = advice.optics;
  const double longest_nm = nm(scene.longest_um());
  Section section{"optics", name_in(optics_words, found.verdict), optics_sentence(found), {}};
  Json correlation;
  std::string features = fmt::format("RMS slope {:.3g}", advice.surface.rms_slope);
  if (advice.surface.correlation_length_um) {
    correlation = *advice.surface.correlation_length_um;
    features += fmt::format(", correlation {:.3g} um", *advice.surface.correlation_length_um);
  }
  section.findings = {{"decided_by", name_in(reason_words, found.reason), "", "",
                       "no_phase, resolved, shallow or deep"},
                      {"rms_slope", advice.surface.rms_slope, "", features,
                       "of |grad h|, levelled; 1/e of the autocorrelation"},
                      {"correlation_length", correlation, "um", "",
                       "1/e of the autocorrelation, in the direction where it falls fastest"}};
  const std::string lobe = short_text(found.lobe_width.deg()) + " deg";
  std::string seen = "speckle " + lobe;
  if (found.period)
    seen = fmt::format("orders {:.3g} deg apart, lobe {}", found.spacing.deg(), lobe);
  if (found.verdict == OpticsVerdict::mirror) seen = "mirror lobe " + lobe;
  section.findings.push_back(
      {"spacing", found.spacing.deg(), "deg", seen,
       fmt::format("{}, {:.4g} nm, {} deg",
                   found.period ? "lambda/(d cos theta_r)" : "lambda/(length cos theta_r)",
                   longest_nm, angle_text(found.seen_at))});
  section.findings.push_back(
      {"lobe_width", found.lobe_width.deg(), "deg", "",
       "full width at half maximum of the power, lambda/length/cos theta_r"});
  section.findings.push_back({"resolution", scene.resolution.deg(), "deg",
                              fmt::format("viewer resolves {:.3g} deg", scene.resolution.deg()),
                              "seen apart: a spacing above it and above the lobe"});
  section.findings.push_back(
      {"phase_depth", found.phase_depth_rad, "rad",
       fmt::format("phase depth {:.3g} rad", found.phase_depth_rad),
       fmt::format("k|w| {:.3g} um peak to valley, |w| {:.3g}; deep from pi on",
                   advice.surface.peak_to_valley_um, scene.mirror_abs_w())});
  section.findings.push_back({"slope_lobe", found.slope_lobe.deg(), "deg",
                              fmt::format("facets spread {:.3g} deg", found.slope_lobe.deg()),
                              "2.35 |w| RMS slope/cos theta_r; rays: above the lobe"});
  return section;
}

std::string scalar_sentence(const std::optional<ScalarVerdict>& verdict, double theta_i_deg) {
  const std::string at = fmt::format(" at {:.3g} deg", theta_i_deg);
  if (!verdict) return "no period to hold against the rigorous limits";
  switch (*verdict) {
    case ScalarVerdict::valid:
      return "directions and strengths are right" + at + ", to 0.02";
    case ScalarVerdict::doubtful:
      return "directions are right, strengths are doubtful" + at;
    case ScalarVerdict::invalid:
      return "directions are right, strengths are not" + at;
  }
  return "?";
}

Json case_json(const ScalarCase& at, const Advice& advice) {
  return {{"period_um", advice.surface.periods[at.period].period.um()},
          {"lambda_nm", nm(at.lambda_um)},
          {"verdict", name_in(scalar_words, at.verdict)},
          {"period_over_lambda", at.period_over_lambda},
          {"component_depth_over_lambda", at.component_over_lambda},
          {"peak_to_valley_over_lambda", at.peak_to_valley_over_lambda},
          {"limit_over_lambda", at.limit.depth_over_lambda},
          {"limit_theta_i_deg", at.limit.theta_i.deg()},
          {"table", name_in(place_words, at.limit.place)},
          {"limit_is_deepest_tested", at.limit.kind == brdf::LimitKind::untested}};
}

std::string case_reason(const ScalarCase& at) {
  if (at.limit.place == brdf::TablePlace::below)
    return "no strength is right below d/lambda = 1.63";
  std::string limit =
      fmt::format("h/lambda {:.2g} sine, {:.2g} all; limit {:.3g}", at.component_over_lambda,
                  at.peak_to_valley_over_lambda, at.limit.depth_over_lambda);
  if (at.limit.place == brdf::TablePlace::beyond) return limit + ", outside table";
  return at.limit.kind == brdf::LimitKind::untested ? limit + ", deepest" : limit;
}

Section scalar(const Advice& advice, const AdviceScene& scene) {
  const evaluation::ScalarAdvice& found = advice.scalar;
  Section section{"scalar",
                  found.verdict ? name_in(scalar_words, *found.verdict) : "no_period",
                  scalar_sentence(found.verdict, scene.request.theta_i.deg()),
                  {}};
  if (!found.cases.empty() && std::abs(scene.request.theta_i.deg()) > 75)
    section.sentence += "; the table ends at 75 deg";
  Json all = Json::array();
  for (const ScalarCase& at : found.cases) all.push_back(case_json(at, advice));
  section.findings = {
      {"cases", all, "", "",
       "depth / lambda against the largest with errors below 0.02 (perfectly "
       "conducting sinusoids, rigorous); the smallest of the tabulated neighbours"}};
  // The page has room for the strongest period: shortest and longest wavelength.
  for (std::size_t i = 0; i < std::min<std::size_t>(found.cases.size(), 2); ++i) {
    const ScalarCase& at = found.cases[i];
    section.findings.push_back(
        {i == 0 ? "shortest" : "longest", name_in(scalar_words, at.verdict), "",
         fmt::format("{:.4g} nm: d/lambda {:.3g}: {}", nm(at.lambda_um), at.period_over_lambda,
                     name_in(scalar_words, at.verdict)),
         case_reason(at)});
  }
  return section;
}

}  // namespace

std::vector<Section> optics_sections(const Advice& advice, const AdviceScene& scene) {
  return {window(advice, scene), optics(advice, scene), scalar(advice, scene)};
}

}  // namespace apps
