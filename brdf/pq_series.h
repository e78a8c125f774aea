// The sources' method for copies of a tile: its Taylor series between the bins, times PQ factors.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "brdf/amplitude.h"
#include "brdf/bin_interpolation.h"
#include "brdf/power_spectra.h"
#include "brdf/pq_factors.h"
#include "brdf/taylor_bounds.h"
#include "brdf/taylor_table.h"

namespace brdf {

/// What the PQ method is to do; the terms, or the tolerance of the query bounds.
struct PqSettings {
  std::optional<int> terms = {};  ///< powers 0 to terms - 1; by the tolerance where empty
  BinInterpolation interpolation = BinInterpolation::exact;
  std::shared_ptr<const PowerSpectra> spectra = {};  ///< kept from before; computed where empty
};

/// Plan of the PQ method: the bins of one tile's DFT((i s)^n) / N^2 that the request can reach.
class PqSeriesPlan {
 public:
  PqSeriesPlan(const Surface& surface, const QueryBounds& bounds, int terms,
               BinInterpolation interpolation, const PowerSpectra& spectra)
      : copies_x_(x_axis(surface), surface.replicas.x),
        copies_y_(y_axis(surface), surface.replicas.y),
        table_(*surface.heights, bounds, x(surface, bounds, interpolation),
               y(surface, bounds, interpolation), spectra, terms) {
    const double depth = bounds.max_abs_c_per_um() * surface.heights->half_range_um();
    report_ = {error_bound(bounds, depth, terms, spectra.value_error()),
               input_phase_error_rad(*surface.heights, bounds), terms, 0,
               table_.bytes() + table_.x().bins.bytes() + table_.y().bins.bytes()};
  }

  void evaluate(std::span<const Query> queries, std::span<std::complex<double>> amplitudes) const {
    table_.evaluate(queries, amplitudes);
    for (std::size_t i = 0; i < queries.size(); ++i)
      amplitudes[i] *=
          copies_x_.factor(queries[i].qx_per_um) * copies_y_.factor(queries[i].qy_per_um);
  }

  PlanReport report() const { return report_; }

  /// Bytes that a plan takes at its largest, its transforms included.
  static std::size_t bytes(const Surface& surface, const QueryBounds& bounds, int terms,
                           BinInterpolation interpolation, const PowerSpectra& spectra) {
    const Axis along_x = x(surface, bounds, interpolation);
    const Axis along_y = y(surface, bounds, interpolation);
    return TaylorTable<InterpolatedBins>::bytes(along_x, along_y, spectra, terms) +
           along_x.bins.bytes() + along_y.bins.bytes();
  }

 private:
  using Axis = BinAxis<InterpolatedBins>;
  static Axis x(const Surface& surface, const QueryBounds& bounds, BinInterpolation interpolation) {
    return {{interpolation, x_axis(surface)}, bounds.lo.qx_per_um, bounds.hi.qx_per_um};
  }
  static Axis y(const Surface& surface, const QueryBounds& bounds, BinInterpolation interpolation) {
    return {{interpolation, y_axis(surface)}, bounds.lo.qy_per_um, bounds.hi.qy_per_um};
  }

  /// The copies along one axis.
  struct Copies {
    SurfaceAxis axis;
    int count;
    double middle_um;  ///< of all copies, from the origin

    Copies(const SurfaceAxis& along, int replicas)
        : axis(along),
          count(replicas),
          middle_um(along.pixel_um *
                    ((static_cast<double>(along.count) * replicas - 1) / 2 - along.origin)) {}
    std::complex<double> factor(double q_per_um) const {
      return std::polar(1.0, q_per_um * middle_um) * pq_factor(axis.cycles(q_per_um), count);
    }
    /// Bound on abs(da/dq): the mean distance from the origin.
    double reach_um() const { return axis.length_um() * count / 4 + std::abs(middle_um); }
    InterpolatedBins::Deviation deviation(const Axis& bins) const {
      return bins.bins.largest_deviation(bins.lo_per_um, bins.hi_per_um, count);
    }
  };

  /// Of the series, through weights that may enlarge it; of the sums over the neighbours; of what
  /// an interpolation is off along one axis, then along the other; of the frequency.
  double error_bound(const QueryBounds& bounds, double depth, int terms, double value_error) const {
    const auto along_x = copies_x_.deviation(table_.x());
    const auto along_y = copies_y_.deviation(table_.y());
    return along_x.norm * along_y.norm *
               (taylor_remainder_bound(depth, terms) +
                kept_values_bound(value_error, depth, stencil()) +
                (1 + products()) * taylor_rounding_bound(depth)) +
           along_x.error * along_y.norm + along_y.error +
           gather_rounding_bound(bounds, copies_x_.reach_um(), copies_y_.reach_um());
  }

  double stencil() const {
    return static_cast<double>(table_.x().bins.stencil()) *
           static_cast<double>(table_.y().bins.stencil());
  }

  /// Added up one after another, for the tables and for a query.
  double products() const {
    double filled = 1, gathered = 1;
    for (const Axis* axis : {&table_.x(), &table_.y()})
      (axis->fixed() ? filled : gathered) *= static_cast<double>(axis->bins.stencil());
    return filled + gathered;
  }

  Copies copies_x_, copies_y_;
  TaylorTable<InterpolatedBins> table_;
  PlanReport report_{};
};

/// a = pq_x pq_y a_tile for Nx x Ny evenly lit copies of a tile; a_tile by the Taylor series of
/// one tile (see TaylorTable), read between the tile's bins (Thesis 1.38-1.54, with what the
/// copies share taken out: Errata E1 to E4, E14, E15, E18, E19).
///
/// Surface model: replicated. Error, reported by the plan: taylor_remainder_bound and
/// taylor_rounding_bound, the latter once more for each product of a sum, gather_rounding_bound,
/// for spectra that were kept rounded kept_values_bound, and for an interpolation that is not exact
/// its deviation, for any tile at most: 0.86 of the peak (nearest), 0.48 (linear), 0.39 (sinc) in a
/// plane of incidence, twice that with both axes, falling with the copies: at the orders every
/// choice is exact. Measured against the direct sum in pq_series.tests.cpp. Cost: as TaylorTable
/// with 1, 2, 3 or all bins an axis; one bin on an axis whose frequency does not change.
/// Errc::invalid_argument: terms < 1, replicas < 1. Errc::not_attainable: the tolerance needs more
/// than max_taylor_terms, or more than the spectra have. Errc::bad_input: the spectra are of
/// another surface.
class PqSeries {
 public:
  explicit PqSeries(const PqSettings& settings = {}) : settings_(settings) {
    require_taylor_terms(settings_.terms);
  }

  static bool supports(SurfaceModel model) { return model == SurfaceModel::replicated; }

  std::size_t bytes(const Surface& surface, const QueryBounds& bounds) const {
    return PqSeriesPlan::bytes(surface, bounds, terms(surface, bounds), settings_.interpolation,
                               *spectra(surface));
  }

  PqSeriesPlan plan(const Surface& surface, const QueryBounds& bounds) const {
    return {surface, bounds, terms(surface, bounds), settings_.interpolation, *spectra(surface)};
  }

  /// Half of the tolerance for the remainder.
  int terms(const Surface& surface, const QueryBounds& bounds) const {
    return taylor_terms(surface, bounds, settings_.terms);
  }

  BinInterpolation interpolation() const { return settings_.interpolation; }

 private:
  std::shared_ptr<const PowerSpectra> spectra(const Surface& surface) const {
    return spectra_or_computed(settings_.spectra, *surface.heights);
  }

  PqSettings settings_;
};

static_assert(AmplitudeMethod<PqSeries>);

}  // namespace brdf
