// Advice as a page for people and as JSON, made from the same findings.
#pragma once

#include <string>
#include <vector>

#include "apps/options.h"
#include "evaluation/advice/advice.h"

namespace apps {

/// A number, and why it is what it is.
struct Finding {
  std::string key;  ///< in the JSON
  evaluation::Json value;
  std::string unit;    ///< "" for words and pure numbers
  std::string line;    ///< as people read it; "" where the page leaves it out
  std::string reason;  ///< formula or comparison
};

/// One question: a verdict of a fixed set, a sentence, and the numbers behind them.
struct Section {
  std::string key, verdict, sentence;
  std::vector<Finding> findings;
};

/// The sections in the order of the page: sampling, heights, tilt, spectrum, window, optics,
/// scalar, orders, steps, method.
std::vector<Section> sections_of(const evaluation::Advice& advice,
                                 const evaluation::AdviceScene& scene);

/// At most 100 columns.
std::string page(const std::vector<Section>& sections);

/// {section: {verdict, sentence, finding: {value, unit, reason}}}
evaluation::Json json(const std::vector<Section>& sections);

// Parts of sections_of, each in its own file.
std::vector<Section> input_sections(const evaluation::Advice& advice,
                                    const evaluation::AdviceScene& scene);
std::vector<Section> optics_sections(const evaluation::Advice& advice,
                                     const evaluation::AdviceScene& scene);
std::vector<Section> sweep_sections(const evaluation::Advice& advice,
                                    const evaluation::AdviceScene& scene);

/// Nanometres of a length [um].
double nm(double um);

/// Three digits; "any" for infinity.
std::string short_text(double value);

/// Degrees to three digits, what is below 1e-6 deg as 0: rounding is no angle.
std::string angle_text(brdf::Angle angle);

}  // namespace apps
