// The options of `shedlight sweep` that leave out cells: Nmin/Nmax for a known period.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <utility>

#include "brdf/order_range.h"
#include "evaluation/cell_selection.h"
#include "evaluation/writers/output_file.h"

namespace apps {

struct SelectionOptions {
  bool orders_only = false;
  std::optional<std::pair<brdf::Length, brdf::Length>> period;  ///< along the vector, across it
  std::optional<brdf::Angle> azimuth;
  std::optional<double> radius;

  void add_to(CLI::App* sweep);
  /// Refuses the period without --orders-only, and --orders-only without the period.
  void require_consistent() const;
  /// All cells, or those near the orders; the number is said on standard error.
  evaluation::CellSelection cells(const evaluation::SweepRequest& request,
                                  const brdf::Surface& surface) const;
  /// For the sidecar; null where all cells are evaluated.
  evaluation::Json parameters(const evaluation::SweepRequest& request, const brdf::Surface& surface,
                              const evaluation::CellSelection& cells) const;

  /// The bands, with the azimuth of the grating vector where none is given.
  brdf::OrderBands bands(const brdf::Surface& surface, brdf::Angle default_azimuth) const;
  /// What the bands are, for the sidecar.
  evaluation::Json bands_json(const brdf::Surface& surface, brdf::Angle default_azimuth) const;

 private:
  brdf::OrderBands::Lattice lattice(brdf::Angle default_azimuth) const;
};

}  // namespace apps
