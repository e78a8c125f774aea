#include "apps/commands/geometric_options.h"

#include "apps/quantities.h"
#include "brdf/slope.h"

namespace apps {
namespace {

using brdf::Distribution;
using brdf::Masking;

const Choices<Distribution> distribution_choices{{"ggx", Distribution::ggx},
                                                 {"beckmann", Distribution::beckmann},
                                                 {"blinn-phong", Distribution::blinn_phong},
                                                 {"gtr", Distribution::gtr}};
const Choices<Masking> masking_choices{{"smith", Masking::smith},
                                       {"cook-torrance", Masking::cook_torrance},
                                       {"kelemen", Masking::kelemen},
                                       {"implicit", Masking::implicit}};

const std::string microfacet = "microfacet", lambert = "lambert";

void refuse_where(bool given, const std::string& option, const std::string& method,
                  const std::string& other) {
  if (given)
    throw brdf::Error(
        brdf::Errc::invalid_argument,
        option + " has no meaning for --method " + method + "; it goes with --method " + other);
}

struct ModelJson {
  evaluation::Json operator()(const brdf::Microfacet& surface) const {
    evaluation::Json json{
        {"distribution", name_in(distribution_choices, surface.roughness.distribution)},
        {"roughness", surface.roughness.alpha},
        {"masking", name_in(masking_choices, surface.masking)}};
    if (surface.roughness.distribution == Distribution::gtr) json["tail"] = surface.roughness.gamma;
    if (const auto* material = std::get_if<brdf::ReflectanceMaterial>(&surface.reflectance))
      json["material"] = material->name;
    else
      json["fresnel"] = fresnel_json(std::get<brdf::Fresnel>(surface.reflectance));
    return json;
  }
  evaluation::Json operator()(const brdf::Lambert& surface) const {
    return {{"albedo", surface.albedo}};
  }
};

}  // namespace

void GeometricOptions::add_to(CLI::App* sweep) {
  add_choice(sweep, "--distribution", distribution, distribution_choices,
             "microfacet: of the facets' normals (default beckmann)");
  add_parsed(sweep, "--roughness", roughness, parse_number,
             "microfacet: alpha (default: the root mean square slope of the heights)", "NUMBER");
  add_parsed(sweep, "--tail", tail, parse_number, "microfacet: exponent of gtr (default 2, ggx)",
             "NUMBER");
  add_choice(sweep, "--masking", masking, masking_choices,
             "microfacet: of hidden facets (default smith)");
  std::string materials;
  for (const auto& known : brdf::reflectance_materials)
    materials.append(materials.empty() ? "" : "|").append(known.name);
  add_parsed(
      sweep, "--material", material,
      [](const std::string&, const std::string& text) {
        return std::string(brdf::material_named(text).name);
      },
      "microfacet: reflectance at normal incidence from a table, by Schlick at other angles",
      "NAME");
  add_parsed(sweep, "--albedo", albedo, parse_number, "lambert: reflected part (default 1)",
             "NUMBER");
}

std::string GeometricOptions::names() {
  return microfacet + "|" + lambert;
}

bool GeometricOptions::has(const std::string& method) {
  return method == microfacet || method == lambert;
}

void GeometricOptions::require_consistent(const std::string& method,
                                          const OpticsOptions& optics) const {
  if (method != microfacet) {
    refuse_where(distribution.has_value(), "--distribution", method, microfacet);
    refuse_where(roughness.has_value(), "--roughness", method, microfacet);
    refuse_where(tail.has_value(), "--tail", method, microfacet);
    refuse_where(masking.has_value(), "--masking", method, microfacet);
    refuse_where(material.has_value(), "--material", method, microfacet);
  }
  if (method != lambert) refuse_where(albedo.has_value(), "--albedo", method, lambert);
  if (method == lambert)
    refuse_where(optics.fresnel.has_value(), "--fresnel", method, "microfacet or diffraction");
  if (material && optics.fresnel)
    throw brdf::Error(brdf::Errc::invalid_argument,
                      "--material and --fresnel exclude each other: the material has its own "
                      "reflectance");
  if (tail && distribution != Distribution::gtr)
    throw brdf::Error(brdf::Errc::invalid_argument, "--tail needs --distribution gtr");
}

evaluation::GeometricOptics::Model GeometricOptions::model(const std::string& method,
                                                           const OpticsOptions& optics,
                                                           const brdf::HeightField& field) const {
  if (method == lambert) {
    brdf::Lambert surface;
    surface.albedo = albedo.value_or(surface.albedo);
    return surface;
  }
  brdf::Microfacet surface;
  surface.roughness.distribution = distribution.value_or(Distribution::beckmann);
  surface.roughness.gamma = tail.value_or(surface.roughness.gamma);
  surface.roughness.alpha = roughness ? *roughness : rms_slope(field);
  surface.masking = masking.value_or(surface.masking);
  surface.reflectance = optics.facet();
  if (material) surface.reflectance = brdf::material_named(*material);
  return surface;
}

evaluation::Json model_json(const evaluation::GeometricOptics::Model& model) {
  return std::visit(ModelJson{}, model);
}

}  // namespace apps
