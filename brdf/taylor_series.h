// The sources' method: a Taylor series in the height with precomputed transforms of its powers.
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brdf/amplitude.h"
#include "brdf/periodic_bins.h"
#include "brdf/power_spectra.h"
#include "brdf/taylor_bounds.h"
#include "brdf/taylor_table.h"

namespace brdf {

/// What the Taylor series is to do; the terms, or the tolerance of the query bounds.
struct TaylorSettings {
  std::optional<int> terms = {};  ///< powers 0 to terms - 1; by the tolerance where empty
  std::optional<double> radius_sigma_f = {};         ///< neighbours kept; 6, or by the tolerance
  std::shared_ptr<const PowerSpectra> spectra = {};  ///< kept from before; computed where empty
};

/// Plan of the Taylor series: the bins of DFT((i s)^n) / N^2 that the request can reach.
class TaylorSeriesPlan {
 public:
  TaylorSeriesPlan(const Surface& surface, const QueryBounds& bounds, int terms,
                   double radius_sigma_f, const PowerSpectra& spectra)
      : table_(*surface.heights, bounds, x(surface, bounds, radius_sigma_f),
               y(surface, bounds, radius_sigma_f), spectra, terms) {
    const double depth = bounds.max_abs_c_per_um() * surface.heights->half_range_um();
    const double sigma_um = surface.window.sigma_um();
    report_ = {taylor_remainder_bound(depth, terms) + taylor_rounding_bound(depth) +
                   omitted_neighbours_bound(table_.x().bins, table_.y().bins) +
                   kept_values_bound(spectra.value_error(), depth, neighbours()) * weight_norm() +
                   gather_rounding_bound(bounds, sigma_um, sigma_um),
               input_phase_error_rad(*surface.heights, bounds), terms, radius_sigma_f,
               table_.bytes()};
  }

  void evaluate(std::span<const Query> queries, std::span<std::complex<double>> amplitudes) const {
    table_.evaluate(queries, amplitudes);
  }

  PlanReport report() const { return report_; }

  /// Bytes that a plan takes at its largest, its transforms included.
  static std::size_t bytes(const Surface& surface, const QueryBounds& bounds, int terms,
                           double radius_sigma_f, const PowerSpectra& spectra) {
    return TaylorTable<PeriodicBins>::bytes(x(surface, bounds, radius_sigma_f),
                                            y(surface, bounds, radius_sigma_f), spectra, terms);
  }

 private:
  double neighbours() const {
    return static_cast<double>(table_.x().bins.max_count() * table_.y().bins.max_count());
  }
  double weight_norm() const {
    return std::sqrt(table_.x().bins.weight_energy() * table_.y().bins.weight_energy());
  }

  using Axis = BinAxis<PeriodicBins>;
  static Axis x(const Surface& surface, const QueryBounds& bounds, double radius_sigma_f) {
    return {{surface.window, x_axis(surface), radius_sigma_f},
            bounds.lo.qx_per_um,
            bounds.hi.qx_per_um};
  }
  static Axis y(const Surface& surface, const QueryBounds& bounds, double radius_sigma_f) {
    return {{surface.window, y_axis(surface), radius_sigma_f},
            bounds.lo.qy_per_um,
            bounds.hi.qy_per_um};
  }

  TaylorTable<PeriodicBins> table_;
  PlanReport report_{};
};

/// a = e^{i c h_mid} sum_{n < N} (i c)^n / n! sum_bins DFT((h - h_mid)^n) / pixels * W
/// (Thesis 1.24, 1.32, 1.37, with the modulus outside both sums; Errata E5, E6, E22).
///
/// Heights are taken from the middle of their range and scaled to [-1, 1], which makes the
/// remainder smallest and keeps every power in range. Surface model: periodic.
/// Error: taylor_remainder_bound + taylor_rounding_bound + omitted_neighbours_bound +
/// gather_rounding_bound, and kept_values_bound for spectra that were kept rounded, reported by the
/// plan; the rounding e^x / 2^53 makes the series useless
/// beyond phases x = c h / 2 of about 30 however many terms are taken. Cost: N transforms, then N x
/// neighbours products a query. Errc::invalid_argument: terms < 1, radius not > 0.
/// Errc::not_attainable: the tolerance needs more than max_terms, or more than the spectra have.
/// Errc::bad_input: the spectra are of another surface. From spectra that were kept as they are the
/// plan is the same to the last bit as from the heights.
class TaylorSeries {
 public:
  static constexpr int max_terms = max_taylor_terms;
  /// Beyond 38 sigma_f the weight underflows.
  static constexpr double max_radius_sigma_f = 40;
  /// Weight 1.5e-8 at the edge: a worst error below 1e-7.
  static constexpr double default_radius_sigma_f = 6;

  explicit TaylorSeries(const TaylorSettings& settings = {}) : settings_(settings) {
    require_taylor_terms(settings_.terms);
    if (settings_.radius_sigma_f &&
        !(*settings_.radius_sigma_f > 0 && *settings_.radius_sigma_f <= max_radius_sigma_f))
      throw Error(Errc::invalid_argument, "window radius " + text(*settings_.radius_sigma_f) +
                                              " sigma_f must lie above 0 and up to " +
                                              text(max_radius_sigma_f));
  }

  static bool supports(SurfaceModel model) { return model == SurfaceModel::periodic; }

  std::size_t bytes(const Surface& surface, const QueryBounds& bounds) const {
    return TaylorSeriesPlan::bytes(surface, bounds, terms(surface, bounds), radius(surface, bounds),
                                   *spectra(surface));
  }

  TaylorSeriesPlan plan(const Surface& surface, const QueryBounds& bounds) const {
    return {surface, bounds, terms(surface, bounds), radius(surface, bounds), *spectra(surface)};
  }

  /// Half of the tolerance each for the remainder and for the neighbours left out.
  int terms(const Surface& surface, const QueryBounds& bounds) const {
    return taylor_terms(surface, bounds, settings_.terms);
  }

  /// The smallest radius, in quarters of sigma_f, that leaves out at most half of the tolerance.
  double radius(const Surface& surface, const QueryBounds& bounds) const {
    if (settings_.radius_sigma_f) return *settings_.radius_sigma_f;
    if (settings_.terms) return default_radius_sigma_f;
    double radius = 1;
    for (; radius < max_radius_sigma_f; radius += 0.25)
      if (omitted_neighbours_bound(PeriodicBins(surface.window, x_axis(surface), radius),
                                   PeriodicBins(surface.window, y_axis(surface), radius)) <=
          bounds.tolerance / 2)
        break;
    return radius;
  }

 private:
  std::shared_ptr<const PowerSpectra> spectra(const Surface& surface) const {
    return spectra_or_computed(settings_.spectra, *surface.heights);
  }

  TaylorSettings settings_;
};

static_assert(AmplitudeMethod<TaylorSeries>);

}  // namespace brdf
