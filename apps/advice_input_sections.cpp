// The sections on the input: sampling, heights, tilt, spectrum.
#include <fmt/format.h>

#include <cmath>

#include "apps/advice_report.h"

namespace apps {
namespace {

using evaluation::Advice;
using evaluation::AdviceScene;
using evaluation::HeightPeriod;
using evaluation::Json;

Section sampling(const Advice& advice, const AdviceScene& scene) {
  const evaluation::SamplingAdvice& found = advice.sampling;
  const bool is_sampled = found.verdict == evaluation::SamplingVerdict::sampled;
  const double shortest_nm = nm(scene.shortest_um());
  Section section{"sampling", is_sampled ? "sampled" : "undersampled", {}, {}};
  Json safe;
  if (found.safe_deg) safe = {found.safe_deg->first, found.safe_deg->second};
  if (is_sampled)
    section.sentence = "fine enough for every direction of the scene";
  else
    section.sentence =
        found.safe_deg
            ? fmt::format("undersampled: at {:.4g} nm only {} to {} deg are safe", shortest_nm,
                          found.safe_deg->first, found.safe_deg->second)
            : fmt::format("undersampled: at {:.4g} nm no viewing angle asked for is safe",
                          shortest_nm);
  section.findings = {
      {"pixel", found.pixel_um, "um",
       fmt::format("pixel {} x {} nm", short_text(nm(found.pixel_um[0])),
                   short_text(nm(found.pixel_um[1]))),
       fmt::format("< {} x {} nm = lambda/(2|u|), {:.4g} nm, |u| <= {:.3g}",
                   short_text(nm(found.limit_um[0])), short_text(nm(found.limit_um[1])),
                   shortest_nm, scene.largest_abs_u())},
      {"pixel_limit", found.limit_um, "um", "", "lambda_min / (2 |u|max) along x and y"},
      {"safe_angles", safe, "deg", "", "first and last viewing angle with |k u| <= pi / pixel"}};
  return section;
}

Section heights(const Advice& advice, const AdviceScene& scene) {
  const evaluation::HeightsAdvice& found = advice.heights;
  const bool is_fine = found.verdict == evaluation::HeightsVerdict::fine_enough;
  Section section{"heights", is_fine ? "fine_enough" : "too_coarse", {}, {}};
  if (found.step_um == 0)
    section.sentence = "no step of the stored heights is known: nothing limits the accuracy";
  else if (is_fine)
    section.sentence = fmt::format("the stored steps bear a tolerance of {}", scene.tolerance);
  else
    section.sentence =
        fmt::format("the input cannot bear a tolerance of {}: its steps allow {:.2g}",
                    scene.tolerance, found.phase_error_rad);
  section.findings = {
      {"step", found.step_um, "um", fmt::format("step {:.4g} nm", nm(found.step_um)),
       fmt::format("k|w| step/2 = {:.3g} rad, |w| = {:.3g}, {:.4g} nm", found.phase_error_rad,
                   scene.largest_abs_w(), nm(scene.shortest_um()))},
      {"phase_error", found.phase_error_rad, "rad", "",
       "k |w| step / 2 at the shortest wavelength; the amplitude errs by no more"},
      {"tolerance", scene.tolerance, "", "",
       "of the amplitude, as asked; the flat patch's peak is 1"}};
  return section;
}

/// Nanometres without what only rounding leaves.
std::string whole_picometres(double length_um) {
  return fmt::format("{:.4g}", std::round(nm(length_um) * 1e3) / 1e3);
}

Section tilt(const Advice& advice) {
  const evaluation::TiltAdvice& found = advice.tilt;
  const bool is_tilted = found.verdict == evaluation::TiltVerdict::tilted;
  return {"tilt",
          is_tilted ? "tilted" : "level",
          is_tilted ? "tilted: take the plane off, --level plane" : "level enough",
          {{"plane",
            {found.along_x.deg(), found.along_y.deg()},
            "deg",
            fmt::format("plane {}, {} deg (x, y)", angle_text(found.along_x),
                        angle_text(found.along_y)),
            fmt::format("mirror moves {} deg, its lobe is {} deg wide",
                        angle_text(found.mirror_shift), short_text(found.lobe_width.deg()))},
           {"mirror_shift", found.mirror_shift.deg(), "deg", "", "2 x the plane's steepest angle"},
           {"lobe_width", found.lobe_width.deg(), "deg", "",
            "full width at half maximum, at the mirror direction and the shortest wavelength"},
           {"rise", found.rise_um, "um",
            fmt::format("rise {} nm of {} nm", whole_picometres(found.rise_um),
                        whole_picometres(found.peak_to_valley_um)),
            "corner to corner, of peak to valley; most is > half"},
           {"peak_to_valley", found.peak_to_valley_um, "um", "", "of the heights with the plane"}}};
}

std::string harmonics_of(const std::vector<HeightPeriod>& periods, std::size_t index) {
  std::string orders;
  for (const HeightPeriod& period : periods)
    if (period.harmonic && period.harmonic->of == index)
      orders += fmt::format("{}{}", orders.empty() ? "; harmonics " : " ", period.harmonic->order);
  return orders;
}

Json period_json(const HeightPeriod& period) {
  Json json{{"period_um", period.period.um()},
            {"azimuth_deg", period.azimuth.deg()},
            {"depth_um", period.depth_um},
            {"share", period.share},
            {"contrast", period.contrast}};
  if (period.harmonic) {
    json["harmonic"] = period.harmonic->order;
    json["harmonic_of"] = period.harmonic->of;
  }
  return json;
}

Section spectrum(const Advice& advice) {
  const auto& periods = advice.surface.periods;
  const auto base = evaluation::fundamentals(advice.surface);
  const bool is_flat = advice.optics.verdict == evaluation::OpticsVerdict::mirror;
  Section section{"spectrum", {}, {}, {}};
  Json all = Json::array();
  for (const HeightPeriod& period : periods) all.push_back(period_json(period));
  if (!base.empty()) {
    section.verdict = "periodic";
    section.sentence = fmt::format("{} period{} stand{} clear of the background", base.size(),
                                   base.size() == 1 ? "" : "s", base.size() == 1 ? "s" : "");
  } else {
    section.verdict = is_flat ? "flat" : "no_period";
    section.sentence = is_flat ? "flat: no period" : "no period: no maximum stands clear";
  }
  section.findings = {
      {"periods", all, "um, deg", "",
       "maxima of the spectrum, levelled, under a Gaussian window of a sixth of the patch: 30 x "
       "the "
       "background around, or half of the variance; depth is peak to valley of the sinusoid"}};
  for (const std::size_t i : base) {
    const HeightPeriod& period = periods[i];
    section.findings.push_back(
        {fmt::format("period_{}", section.findings.size()), period.period.um(), "um",
         fmt::format("{:.4g} um at {} deg, {:.4g} nm deep", period.period.um(),
                     angle_text(period.azimuth), nm(period.depth_um)),
         fmt::format("share {:.3g} %, {} background{}", 100 * period.share,
                     std::isfinite(period.contrast) ? fmt::format("{:.2g} x", period.contrast)
                                                    : std::string("no"),
                     harmonics_of(periods, i))});
  }
  return section;
}

}  // namespace

std::vector<Section> input_sections(const Advice& advice, const AdviceScene& scene) {
  return {sampling(advice, scene), heights(advice, scene), tilt(advice), spectrum(advice)};
}

}  // namespace apps
