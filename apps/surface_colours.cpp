#include "apps/surface_colours.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/colour_warnings.h"
#include "apps/console.h"
#include "apps/memory_limit.h"
#include "apps/quantities.h"
#include "apps/response_input.h"
#include "evaluation/audit.h"
#include "evaluation/bake.h"
#include "evaluation/colour_volume_file.h"
#include "evaluation/geometric_optics.h"
#include "evaluation/npy.h"

namespace apps {
namespace {

using brdf::Errc;
using brdf::Error;
using brdf::Length;
using evaluation::DirectionPair;
using evaluation::Json;

constexpr int default_audit = 32;

[[noreturn]] void refuse(const std::string& what) {
  throw Error(Errc::invalid_argument, what);
}

/// The box of all queries: they are straight lines in k.
brdf::QueryBounds bounds_of(std::span<const Eigen::Vector3d> scattering,
                            const brdf::SpectralBand& band, double tolerance) {
  std::vector<brdf::Query> ends;
  ends.reserve(2 * scattering.size());
  for (const Eigen::Vector3d& s : scattering) {
    ends.push_back(brdf::query(s, band.k_lo_per_um()));
    ends.push_back(brdf::query(s, band.k_hi_per_um()));
  }
  brdf::QueryBounds bounds = brdf::bounds_of(ends, tolerance);
  // A little wider: nodes at the ends of the band are rounded.
  for (double* lo : {&bounds.lo.qx_per_um, &bounds.lo.qy_per_um, &bounds.lo.c_per_um})
    *lo -= 1e-12 * (1 + std::abs(*lo));
  for (double* hi : {&bounds.hi.qx_per_um, &bounds.hi.qy_per_um, &bounds.hi.c_per_um})
    *hi += 1e-12 * (1 + std::abs(*hi));
  return bounds;
}

}  // namespace

double mirror_radius(const brdf::Surface& surface) {
  const brdf::OrderBands around(surface, {Length::um(1)}, 4);
  return std::max(around.along_per_um(), around.across_per_um()) * brdf::SpectralBand().last.um();
}

std::string SurfaceColours::summary() const {
  return fmt::format("{} colours in {:.3g} s", xyz.size(), seconds);
}

brdf::SpectralBand SurfaceColourOptions::band() const {
  if (!lambda_nm_) return {};
  return {Length::nm(lambda_nm_->front()), Length::nm(lambda_nm_->back())};
}

std::vector<Length> SurfaceColourOptions::wavelengths() const {
  std::vector<Length> wavelengths;
  if (lambda_nm_)
    for (const double nm : lambda_nm_->values) wavelengths.push_back(Length::nm(nm));
  else
    for (int nm = 380; nm <= 780; nm += 5) wavelengths.push_back(Length::nm(nm));
  return wavelengths;
}

evaluation::SpectralIntegral SurfaceColourOptions::integral(
    const brdf::Surface& surface, std::span<const Eigen::Vector3d> scattering) const {
  if (lambda_nm_) return brdf::StepIntegral(wavelengths());
  if (selection_.orders_only) return brdf::BandIntegral(band(), selection_.bands(surface, {}));
  const brdf::InterferenceReach reach = interference_reach(surface, colour_tolerance());
  double farthest_rad = 0;
  for (const Eigen::Vector3d& s : scattering)
    farthest_rad = std::max(farthest_rad, reach.phase_rad(s, band()));
  return brdf::AdaptiveIntegral(band(), reach, colour_tolerance(), farthest_rad);
}

Json SurfaceColourOptions::integral_json(const brdf::Surface& surface) const {
  if (lambda_nm_) return {{"by", "trapezoid"}, {"lambda_nm", axis_json(*lambda_nm_)}};
  Json json{{"by", selection_.orders_only ? "bands of the orders" : "adaptive"},
            {"first_nm", band().first.nm()},
            {"last_nm", band().last.nm()}};
  if (selection_.orders_only)
    json["bands"] = selection_.bands_json(surface, {});
  else
    json["tolerance"] = colour_tolerance();
  return json;
}

void SurfaceColourOptions::check_sampling(std::span<const Eigen::Vector3d> scattering,
                                          const brdf::HeightField& field) const {
  const Length shortest = band().first;
  const double k = brdf::wavenumber_per_um(shortest);
  const bool beyond = std::any_of(scattering.begin(), scattering.end(), [&](const auto& s) {
    return evaluation::is_beyond_nyquist(brdf::query(s, k), field);
  });
  if (!beyond) return;
  report_unattained(
      fmt::format(
          "{}: at {} nm directions beyond abs(u) = {:.3g}, abs(v) = {:.3g} of the scattering "
          "vector go past the Nyquist limit of its {} x {} um pixels",
          file(), shortest.nm(), brdf::pi / (k * field.dx_um()), brdf::pi / (k * field.dy_um()),
          field.dx_um(), field.dy_um()),
      run_.attainability());
}

std::unique_ptr<PatchColours> SurfaceColourOptions::read_patch() const {
  IlluminatedOptions illuminated = illuminated_;
  illuminated.resolve(evaluation::method_named(method_));
  return std::make_unique<PatchColours>(heights_.read(), illuminated);
}

void SurfaceColourOptions::prepare(PatchColours& patch, std::span<const Eigen::Vector3d> scattering,
                                   std::size_t count) const {
  const brdf::HeightField& field = patch.input.field;
  check_sampling(scattering, field);
  if (lambda_nm_) warn_of_coverage(evaluation::coverage_of(*lambda_nm_), file());

  evaluation::SpectralIntegral spectrum =
      brdf::at_place(file(), [&] { return integral(patch.surface, scattering); });
  brdf::QueryBounds bounds = bounds_of(scattering, band(), tolerance());
  bounds.count = count * evaluation::largest_count(spectrum);
  const evaluation::Method& method = evaluation::method_named(method_);
  evaluation::MethodSettings settings;
  settings.threads = run_.threads;
  require_memory({file(), "the picture",
                  method.bytes(patch.surface, bounds, settings) +
                      count * (2 * sizeof(DirectionPair) + sizeof(brdf::Xyz)) +
                      static_cast<std::size_t>(field.heights_um().size()) * sizeof(double),
                  "a narrower window, a larger tolerance or --reduce needs less"},
                 run_.memory_limit);
  patch.amplitude = method.plan(patch.surface, bounds, settings);
  patch.colours.emplace(*patch.amplitude, std::move(spectrum), quantity());
  patch.parameters = heights_.parameters(field);
  patch.parameters.update(illuminated_json(patch.surface));
  patch.parameters["method"] = method_;
  patch.parameters["tolerance"] = tolerance();
  patch.parameters["integral"] = integral_json(patch.surface);
  patch.parameters["observer"] = "CIE 1931 2 degrees";
  patch.parameters["illuminant"] = "D65";
}

Json SurfaceColourOptions::audited(const PatchColours& patch,
                                   std::span<const Eigen::Vector3d> scattering) const {
  const brdf::PlanReport report = patch.amplitude->report();
  std::vector<brdf::Query> queries;
  const int wanted = method_ == "direct" ? 0 : audit_.value_or(default_audit);
  const double lo = band().k_lo_per_um(), hi = band().k_hi_per_um();
  for (int i = 0; i < wanted && !scattering.empty(); ++i) {
    const auto number = static_cast<std::size_t>(i);
    const double share = (i + 0.5) / wanted;
    queries.push_back(brdf::query(scattering[evaluation::evenly_spread(number, scattering.size())],
                                  lo + share * (hi - lo)));
  }
  const evaluation::QueryAudit found =
      audit(queries, patch.surface, *patch.amplitude, run_.limits());
  const double worst = std::max(found.worst_error, report.error_bound);
  if (!(worst <= tolerance()))
    report_unattained(fmt::format("{}: the error of the amplitude is {:.3g}, above {:.3g}", file(),
                                  worst, tolerance()),
                      run_.attainability());
  return {{"amplitude_bound", report.error_bound},
          {"audit", {{"amplitudes", found.queries}, {"worst_error", found.worst_error}}},
          {"input_phase_error_rad", report.input_phase_error_rad},
          {"terms", report.terms},
          {"relative_to", "the peak of a flat patch"}};
}

SurfaceColours SurfaceColourOptions::diffraction(std::span<const DirectionPair> pairs,
                                                 const Evaluate& evaluate) const {
  const std::vector<Eigen::Vector3d> scattering = scattering_vectors(pairs);
  const auto ready = read_patch();
  prepare(*ready, scattering, pairs.size());
  const OpticsOptions optics = resolved_optics();
  const evaluation::DiffractionColours colours(*ready->colours, optics.optics(ready->surface));
  SurfaceColours result;
  result.input_sha256 = ready->input.sha256;
  result.parameters = ready->parameters;
  result.parameters.update(optics.parameters());
  evaluate(colours, result);
  result.error = audited(*ready, scattering);
  result.mirror_radius = mirror_radius(ready->surface);
  return result;
}

SurfaceColours SurfaceColourOptions::geometric(const Evaluate& evaluate) const {
  const evaluation::HeightFile input = heights_.read();
  const OpticsOptions optics = resolved_optics();
  const auto model = geometric_.model(method_, optics, input.field);
  const evaluation::GeometricOptics reflectance(model, quantity());
  const evaluation::SpectralColours colours(reflectance, brdf::StepIntegral(wavelengths()),
                                            evaluation::white_scale(quantity()));
  SurfaceColours result;
  result.input_sha256 = input.sha256;
  result.parameters = heights_.parameters(input.field);
  result.parameters["method"] = method_;
  result.parameters.update(model_json(model));
  result.parameters["quantity"] = name_in(quantity_choices, quantity());
  evaluate(colours, result);
  result.error = {{"of_the_model", "rounding alone"}, {"diffraction", "not modelled"}};
  return result;
}

SurfaceColours SurfaceColourOptions::baked(const Evaluate& evaluate) const {
  require_free_of_patch_options();
  const evaluation::ColourVolumeFile volume =
      evaluation::read_colour_volume(file(), memory_allowed(run_.memory_limit));
  const std::string name = evaluation::sidecar_path(file()).string();
  const auto number = [&](const std::string& key) {
    const auto value = sidecar_number(volume.sidecar, "/parameters/" + key);
    if (!value) throw Error(Errc::bad_input, name + ": has no number parameters." + key);
    return *value;
  };
  const std::string quantity_baked =
      sidecar_text(volume.sidecar, "/parameters/quantity", "an unknown quantity");
  if (optics_.quantity && name_in(quantity_choices, *optics_.quantity) != quantity_baked)
    refuse("--quantity " + name_in(quantity_choices, *optics_.quantity) + ": " + file() +
           " was baked of " + quantity_baked);
  OpticsOptions optics = optics_;
  for (const auto& [choice, value] : quantity_choices)
    if (choice == quantity_baked) optics.quantity = value;
  if (!optics.quantity)
    throw Error(Errc::bad_input, name + ": parameters.quantity is " + quantity_baked);

  const evaluation::BakedColours lookup(brdf::ColourVolume(volume.grid, volume.numbers));
  const evaluation::DiffractionColours colours(
      lookup, {*optics.quantity, number("coherence_area_um2"), optics.facet(),
               optics.shadowing.value_or(evaluation::Shadowing::none)});
  SurfaceColours result;
  result.input_sha256 = volume.sha256;
  result.parameters = {{"baked", volume.sidecar.at("parameters")}};
  result.parameters.update(optics.parameters());
  evaluate(colours, result);
  if (volume.sidecar.contains("error")) result.error = volume.sidecar.at("error");
  result.mirror_radius = number("mirror_radius_sine");
  return result;
}

void SurfaceColourOptions::require_bakeable() const {
  require_consistent();
  if (is_geometric()) refuse("--method " + method_ + " knows no diffraction: nothing to bake");
  if (evaluation::is_baked(file()))
    refuse(file() + " is a volume already: bake takes a height field");
  require_not_given(
      {{optics_.fresnel.has_value(), "--fresnel"}, {optics_.shadowing.has_value(), "--shadowing"}},
      "bake: it stays open for map and render");
}

brdf::VolumeGrid SurfaceColourOptions::volume_grid(const PatchColours& patch) const {
  return brdf::at_place(file(), [&] {
    return brdf::VolumeGrid(evaluation::volume_shape(
        interference_reach(patch.surface, colour_tolerance()), colour_tolerance()));
  });
}

SurfaceColours SurfaceColourOptions::colours(std::span<const DirectionPair> pairs,
                                             const CheckpointOptions& checkpoint,
                                             const Json& request) const {
  require_consistent();
  const Evaluate evaluate = [&](const evaluation::DirectionColours& colours,
                                SurfaceColours& result) {
    Json asked = sidecar_head("colours", file(), result.input_sha256);
    asked["parameters"] = result.parameters;
    asked["parameters"].update(request);
    result.checkpoint = checkpoint.open(std::move(asked));
    evaluation::RunLimits limits = run_.limits();
    limits.chunks = result.checkpoint.get();
    const auto began = std::chrono::steady_clock::now();
    result.xyz = brdf::at_place(
        file(), [&] { return colours_of(pairs, colours, limits, progress_line("colours")); });
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  if (evaluation::is_baked(file())) return baked(evaluate);
  return is_geometric() ? geometric(evaluate) : diffraction(pairs, evaluate);
}

}  // namespace apps
