// The options of `shedlight sweep` that turn an amplitude into what a detector sees.
#pragma once

#include <CLI/CLI.hpp>
#include <complex>
#include <optional>

#include "apps/options.h"
#include "evaluation/diffraction.h"

namespace apps {

extern const Choices<brdf::Quantity> quantity_choices;

struct OpticsOptions {
  std::optional<brdf::Quantity> quantity;
  std::optional<brdf::FresnelModel> fresnel;
  std::optional<std::complex<double>> index;
  std::optional<evaluation::Shadowing> shadowing;

  void add_to(CLI::App* sweep);
  /// Refuses factors of a reflectance beside the bare power, an index without a model that has
  /// one, and an index that no material has.
  void require_consistent() const;
  brdf::Fresnel facet() const;
  evaluation::Optics optics(const brdf::Surface& surface) const;
  /// Quantity, Fresnel and shadowing, for the sidecar.
  evaluation::Json parameters() const;
};

/// "1.5" or "0.97,1.87": n, or n and k.
std::complex<double> parse_index(const std::string& option, const std::string& text);

/// Model and index of a facet, for the sidecar.
evaluation::Json fresnel_json(const brdf::Fresnel& fresnel);
/// And back. Throws Errc::bad_input for what `fresnel_json` does not write.
brdf::Fresnel fresnel_from_json(const evaluation::Json& json);

extern const Choices<evaluation::Shadowing> shadowing_choices;

}  // namespace apps
