#include "apps/commands/optics_options.h"

#include <algorithm>

#include "apps/quantities.h"

namespace apps {

using brdf::FresnelModel;
using brdf::Quantity;
using evaluation::Shadowing;

const Choices<Quantity> quantity_choices{{"power", Quantity::power},
                                         {"relative", Quantity::relative},
                                         {"brdf", Quantity::brdf},
                                         {"radiance", Quantity::radiance}};

namespace {

const Choices<FresnelModel> fresnel_choices{{"none", FresnelModel::none},
                                            {"schlick", FresnelModel::schlick},
                                            {"schlick-amplitude", FresnelModel::schlick_amplitude},
                                            {"dielectric", FresnelModel::dielectric},
                                            {"conductor", FresnelModel::conductor}};

}  // namespace

const Choices<Shadowing> shadowing_choices{{"none", Shadowing::none},
                                           {"v-cavity", Shadowing::v_cavity}};

std::complex<double> parse_index(const std::string& option, const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return parse_number(option, text);
  return {parse_number(option, text.substr(0, comma)),
          parse_number(option, text.substr(comma + 1))};
}

void OpticsOptions::add_to(CLI::App* sweep) {
  add_choice(sweep, "--quantity", quantity, quantity_choices,
             "abs(a)^2, relative reflectance (default), BRDF in 1/sr, or radiance per intensity");
  add_choice(sweep, "--fresnel", fresnel, fresnel_choices,
             "reflectance of the material at the half vector (default none: a perfect mirror); "
             "schlick-amplitude squares Schlick's R as the sources do");
  add_parsed(sweep, "--index", index, parse_index,
             "its refractive index (default 1.5); n,k for a conductor", "N[,K]");
  add_choice(sweep, "--shadowing", shadowing, shadowing_choices,
             "light lost in V-shaped grooves (default none)");
}

void OpticsOptions::require_consistent() const {
  const auto refuse = [](const char* what) {
    throw brdf::Error(brdf::Errc::invalid_argument, what);
  };
  const FresnelModel model = fresnel.value_or(FresnelModel::none);
  const bool bare = quantity == Quantity::power;
  if (bare && model != FresnelModel::none)
    refuse("--fresnel has no meaning for --quantity power, the bare abs(a)^2");
  if (bare && shadowing.value_or(Shadowing::none) != Shadowing::none)
    refuse("--shadowing has no meaning for --quantity power, the bare abs(a)^2");
  if (index && model == FresnelModel::none)
    refuse("--index needs --fresnel schlick, dielectric or conductor");
  if (model == FresnelModel::conductor && !index)
    refuse("--fresnel conductor needs --index n,k of the metal");
  require_valid(facet());
}

brdf::Fresnel OpticsOptions::facet() const {
  brdf::Fresnel facet;
  facet.model = fresnel.value_or(facet.model);
  facet.index = index.value_or(facet.index);
  return facet;
}

evaluation::Optics OpticsOptions::optics(const brdf::Surface& surface) const {
  return {*quantity, coherence_area_um2(surface), facet(), shadowing.value_or(Shadowing::none)};
}

evaluation::Json fresnel_json(const brdf::Fresnel& fresnel) {
  evaluation::Json json{{"model", name_in(fresnel_choices, fresnel.model)}};
  if (fresnel.model != FresnelModel::none)
    json["index"] = {fresnel.index.real(), fresnel.index.imag()};
  return json;
}

brdf::Fresnel fresnel_from_json(const evaluation::Json& json) {
  brdf::Fresnel fresnel;
  const std::string name = json.is_object() ? json.value("model", "") : "";
  const auto known = std::find_if(fresnel_choices.begin(), fresnel_choices.end(),
                                  [&](const auto& choice) { return choice.first == name; });
  if (known == fresnel_choices.end())
    throw brdf::Error(brdf::Errc::bad_input, "reflectance model '" + name + "' is not known");
  fresnel.model = known->second;
  if (const auto index = json.find("index"); index != json.end()) {
    if (!(index->is_array() && index->size() == 2 && (*index)[0].is_number() &&
          (*index)[1].is_number()))
      throw brdf::Error(brdf::Errc::bad_input, "refractive index is no pair of numbers");
    fresnel.index = {(*index)[0].get<double>(), (*index)[1].get<double>()};
  }
  require_valid(fresnel);
  return fresnel;
}

evaluation::Json OpticsOptions::parameters() const {
  return {{"quantity", name_in(quantity_choices, *quantity)},
          {"fresnel", fresnel_json(facet())},
          {"shadowing", name_in(shadowing_choices, shadowing.value_or(Shadowing::none))}};
}

}  // namespace apps
