#include <algorithm>
#include <array>
#include <string_view>

#include "apps/commands/method_options.h"
#include "apps/quantities.h"
#include "apps/surface_colours.h"

namespace apps {
namespace {

/// A power of 1e-4 of the mirror's, shown a thousand times brighter, is then wrong by 0.2 %.
constexpr double default_tolerance = 1e-5;
/// A tenth of a just noticeable difference.
constexpr double default_colour_tolerance = 1e-3;

/// The amplitude methods for colours: those that have every surface model.
constexpr std::array<std::string_view, 3> colour_methods{"auto", "chebyshev", "direct"};

std::string listed(const char* separator) {
  std::string names;
  for (const std::string_view name : colour_methods)
    names.append(names.empty() ? "" : separator).append(name);
  return names;
}

[[noreturn]] void refuse(const std::string& what) {
  throw brdf::Error(brdf::Errc::invalid_argument, what);
}

}  // namespace

void SurfaceColourOptions::add_to(CLI::App* app) {
  heights_.add_to(app);
  add_parsed(app, "--lambda", lambda_nm_, parse_length_axis,
             "wavelengths, by the trapezoid (default: 380 to 780 nm, as many as the tolerance "
             "needs in each direction)",
             "START:STOP:STEP");
  illuminated_.add_to(app);
  app->add_option("--method", method_,
                  "how the amplitude is computed (default auto), or a model without diffraction")
      ->type_name(listed("|") + "|" + GeometricOptions::names());
  add_parsed(app, "--tolerance", tolerance_, parse_number,
             "largest error of the amplitude, flat patch's peak = 1 (default 1e-5)", "NUMBER");
  add_parsed(
      app, "--colour-tolerance", colour_tolerance_, parse_number,
      "error that the integral over wavelengths may make, as a part of the local brightness; "
      "bake measures and states that of its volume beside it (default 1e-3)",
      "NUMBER");
  optics_.add_to(app);
  selection_.add_to(app);
  geometric_.add_to(app);
  add_parsed(app, "--audit", audit_, count_between(0, 1000000),
             "amplitudes held against the direct sum after the run (default 32)", "N");
  run_.add_to(app);
}

double SurfaceColourOptions::tolerance() const {
  return tolerance_.value_or(default_tolerance);
}

double SurfaceColourOptions::colour_tolerance() const {
  return colour_tolerance_.value_or(default_colour_tolerance);
}

brdf::Quantity SurfaceColourOptions::quantity() const {
  return optics_.quantity.value_or(is_geometric() ? brdf::Quantity::radiance
                                                  : brdf::Quantity::relative);
}

OpticsOptions SurfaceColourOptions::resolved_optics() const {
  OpticsOptions optics = optics_;
  optics.quantity = quantity();
  return optics;
}

void SurfaceColourOptions::require_consistent() const {
  require_tolerance("--tolerance", tolerance());
  require_tolerance("--colour-tolerance", colour_tolerance());
  if (colour_tolerance_ && (lambda_nm_ || selection_.orders_only))
    refuse(
        "--colour-tolerance chooses the wavelengths: it goes without --lambda and "
        "--orders-only");
  if (!is_geometric() && std::ranges::find(colour_methods, method_) == colour_methods.end())
    refuse("--method " + method_ + ": must be one of " + listed(", ") + ", " +
           GeometricOptions::names());
  brdf::at_place("--quantity " + name_in(quantity_choices, quantity()),
                 [&] { return evaluation::white_scale(quantity()); });
  selection_.require_consistent();
  if (selection_.orders_only && lambda_nm_)
    refuse("--orders-only and --lambda exclude each other: the orders choose the wavelengths");
  geometric_.require_consistent(method_, optics_);
  resolved_optics().require_consistent();
  if (!is_geometric()) return;
  require_not_given({{tolerance_.has_value(), "--tolerance"},
                     {colour_tolerance_.has_value(), "--colour-tolerance"},
                     {illuminated_.sigma.has_value(), "--sigma"},
                     {illuminated_.model.has_value(), "--surface"},
                     {illuminated_.replicas.has_value(), "--replicas"},
                     {audit_.has_value(), "--audit"},
                     {selection_.orders_only, "--orders-only"},
                     {optics_.shadowing.has_value(), "--shadowing"}},
                    "--method " + method_ + ", which knows no diffraction");
}

void SurfaceColourOptions::require_free_of_patch_options() const {
  require_not_given({{heights_.choice.scale.width.has_value(), "--width"},
                     {heights_.choice.scale.pixel.has_value(), "--pixel"},
                     {heights_.choice.scale.height_range.has_value(), "--height-range"},
                     {heights_.choice.scale.height_unit.has_value(), "--height-unit"},
                     {heights_.choice.channel.has_value(), "--channel"},
                     {heights_.choice.missing != evaluation::MissingHeights::refuse, "--missing"},
                     {heights_.choice.channel.has_value(), "--channel"},
                     {heights_.choice.missing != evaluation::MissingHeights::refuse, "--missing"},
                     {heights_.reduction != 1, "--reduce"},
                     {heights_.level.has_value(), "--level"},
                     {lambda_nm_.has_value(), "--lambda"},
                     {method_ != "auto", "--method"},
                     {tolerance_.has_value(), "--tolerance"},
                     {colour_tolerance_.has_value(), "--colour-tolerance"},
                     {illuminated_.sigma.has_value(), "--sigma"},
                     {illuminated_.model.has_value(), "--surface"},
                     {illuminated_.replicas.has_value(), "--replicas"},
                     {selection_.orders_only, "--orders-only"},
                     {audit_.has_value(), "--audit"}},
                    file() + ": it is a volume, in which this was decided when it was baked");
}

}  // namespace apps
