#include "apps/advice_report.h"

#include <fmt/format.h>

#include <cmath>

namespace apps {

double nm(double um) {
  return brdf::Length::um(um).nm();
}

std::string short_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", value) : "any";
}

std::string angle_text(brdf::Angle angle) {
  if (!std::isfinite(angle.deg())) return "any";
  return fmt::format("{:.3g}", std::round(angle.deg() * 1e6) / 1e6 + 0.0);
}

std::vector<Section> sections_of(const evaluation::Advice& advice,
                                 const evaluation::AdviceScene& scene) {
  std::vector<Section> sections = input_sections(advice, scene);
  for (const auto& part : {optics_sections(advice, scene), sweep_sections(advice, scene)})
    sections.insert(sections.end(), part.begin(), part.end());
  return sections;
}

std::string page(const std::vector<Section>& sections) {
  std::string text;
  for (const Section& section : sections) {
    text += fmt::format("{:<10}{}\n", section.key, section.sentence);
    for (const Finding& finding : section.findings)
      if (!finding.line.empty()) text += fmt::format("  {:<41} {}\n", finding.line, finding.reason);
  }
  return text;
}

evaluation::Json json(const std::vector<Section>& sections) {
  evaluation::Json all = evaluation::Json::object();
  for (const Section& section : sections) {
    evaluation::Json& one = all[section.key];
    one = {{"verdict", section.verdict}, {"sentence", section.sentence}};
    for (const Finding& finding : section.findings)
      one[finding.key] = {
          {"value", finding.value}, {"unit", finding.unit}, {"reason", finding.reason}};
  }
  return all;
}

}  // namespace apps
