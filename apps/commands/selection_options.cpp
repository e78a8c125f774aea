#include "apps/commands/selection_options.h"

#include <fmt/format.h>

#include "apps/console.h"
#include "apps/options.h"
#include "apps/quantities.h"

namespace apps {
namespace {

/// A Gaussian lobe is down to exp(-8) = 3e-4 of its amplitude there; the sources' reach as well.
constexpr double default_radius = 4;

double share(const evaluation::SweepRequest& request, const evaluation::CellSelection& cells) {
  return static_cast<double>(cells.size()) / static_cast<double>(request.cells());
}

}  // namespace

void SelectionOptions::add_to(CLI::App* sweep) {
  sweep->add_flag("--orders-only", orders_only,
                  "evaluate only the bands around the orders of --period; the rest is 0");
  add_parsed(
      sweep, "--period", period,
      [](const std::string& option, const std::string& text) {
        if (text.find(',') != std::string::npos) return parse_length_pair(option, text);
        return std::pair(parse_length(option, text), brdf::Length());
      },
      "orders only: period of the lines, or of a lattice along its vector and across it",
      "LENGTH[,LENGTH]");
  add_parsed(
      sweep, "--period-azimuth", azimuth, parse_angle,
      "orders only: azimuth of the grating vector (default: phi_i, or 0deg where there is none)",
      "ANGLE");
  add_parsed(
      sweep, "--band-radius", radius, parse_number,
      "orders only: halfwidth of a band in sigma_f, or where replicated in zeros of the lobe "
      "(default 4)",
      "NUMBER");
}

void SelectionOptions::require_consistent() const {
  const auto refuse = [](const char* what) {
    throw brdf::Error(brdf::Errc::invalid_argument, what);
  };
  if (orders_only && !period) refuse("--orders-only needs --period, the period of the grating");
  if (orders_only) return;
  if (period) refuse("--period has no meaning without --orders-only");
  if (azimuth) refuse("--period-azimuth has no meaning without --orders-only");
  if (radius) refuse("--band-radius has no meaning without --orders-only");
}

brdf::OrderBands::Lattice SelectionOptions::lattice(brdf::Angle default_azimuth) const {
  return {period->first, period->second, azimuth.value_or(default_azimuth)};
}

brdf::OrderBands SelectionOptions::bands(const brdf::Surface& surface,
                                         brdf::Angle default_azimuth) const {
  return {surface, lattice(default_azimuth), radius.value_or(default_radius)};
}

evaluation::Json SelectionOptions::bands_json(const brdf::Surface& surface,
                                              brdf::Angle default_azimuth) const {
  const brdf::OrderBands::Lattice grating = lattice(default_azimuth);
  evaluation::Json json{{"period_um", grating.along.um()}};
  if (grating.across.um() > 0) json["period_across_um"] = grating.across.um();
  json["azimuth_deg"] = grating.azimuth.deg();
  json["band_radius"] = radius.value_or(default_radius);
  json["halfwidth_per_um"] = bands(surface, default_azimuth).along_per_um();
  return json;
}

evaluation::CellSelection SelectionOptions::cells(const evaluation::SweepRequest& request,
                                                  const brdf::Surface& surface) const {
  if (!orders_only) return evaluation::CellSelection::all(request);
  auto cells = evaluation::CellSelection::within(bands(surface, request.phi_i), request);
  message(fmt::format("orders only: {} of {} cells evaluated ({:.3g} %)", cells.size(),
                      request.cells(), 100 * share(request, cells)));
  return cells;
}

evaluation::Json SelectionOptions::parameters(const evaluation::SweepRequest& request,
                                              const brdf::Surface& surface,
                                              const evaluation::CellSelection& cells) const {
  if (!orders_only) return nullptr;
  evaluation::Json json = bands_json(surface, request.phi_i);
  json["cells_evaluated"] = cells.size();
  json["share_evaluated"] = share(request, cells);
  return json;
}

}  // namespace apps
