// The sources' method: a Taylor series in the height with precomputed transforms of its powers.
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brdf/amplitude.h"
#include "brdf/fourier.h"
#include "brdf/periodic_bins.h"
#include "brdf/taylor_bounds.h"

namespace brdf {

/// What the Taylor series is to do; the terms, or the tolerance of the query bounds.
struct TaylorSettings {
  std::optional<int> terms;              ///< powers 0 to terms - 1; by the tolerance where empty
  std::optional<double> radius_sigma_f;  ///< neighbours kept; 6, or by the tolerance where empty
};

/// Plan of the Taylor series: the bins of DFT((i s)^n) / N^2 that the request can reach.
class TaylorSeriesPlan {
 public:
  TaylorSeriesPlan(const Surface& surface, const QueryBounds& bounds, int terms,
                   double radius_sigma_f)
      : half_range_um_(surface.heights->half_range_um()),
        mid_range_um_(surface.heights->mid_range_um()),
        terms_(terms),
        x_{PeriodicBins(surface.window, x_axis(surface), radius_sigma_f), bounds.lo.qx_per_um,
           bounds.hi.qx_per_um},
        y_{PeriodicBins(surface.window, y_axis(surface), radius_sigma_f), bounds.lo.qy_per_um,
           bounds.hi.qy_per_um},
        tables_(x_.stored() * y_.stored() * static_cast<std::size_t>(terms)) {
    const double x = bounds.max_abs_c_per_um() * half_range_um_;
    report_ = {taylor_remainder_bound(x, terms) + taylor_rounding_bound(x) +
                   omitted_neighbours_bound(x_.bins, y_.bins) +
                   gather_rounding_bound(bounds, surface.window.sigma_um()),
               input_phase_error_rad(*surface.heights, bounds), terms, radius_sigma_f,
               tables_.size() * sizeof(tables_[0])};
    fill(*surface.heights);
  }

  void evaluate(std::span<const Query> queries, std::span<std::complex<double>> amplitudes) const {
    const auto terms = static_cast<std::size_t>(terms_);
    std::vector<std::complex<double>> sums(terms);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      gather(queries[i], sums);
      std::complex<double> series = 0;
      double coefficient = 1;
      for (std::size_t n = 0; n < terms; ++n) {
        series += coefficient * sums[n];
        coefficient *= queries[i].c_per_um * half_range_um_ / static_cast<double>(n + 1);
      }
      amplitudes[i] = std::polar(1.0, queries[i].c_per_um * mid_range_um_) * series;
    }
  }

  PlanReport report() const { return report_; }

  /// Bytes that a plan takes at its largest, its transforms included.
  static std::size_t bytes(const Surface& surface, const QueryBounds& bounds, int terms,
                           double radius_sigma_f) {
    const Axis x{PeriodicBins(surface.window, x_axis(surface), radius_sigma_f), bounds.lo.qx_per_um,
                 bounds.hi.qx_per_um};
    const Axis y{PeriodicBins(surface.window, y_axis(surface), radius_sigma_f), bounds.lo.qy_per_um,
                 bounds.hi.qy_per_um};
    return x.stored() * y.stored() * static_cast<std::size_t>(terms) *
               sizeof(std::complex<double>) +
           RealFourier2d::bytes(static_cast<std::size_t>(surface.heights->rows()),
                                static_cast<std::size_t>(surface.heights->cols()));
  }

 private:
  /// The stored range of one axis. Where all queries share one frequency the neighbours are summed
  /// once, when the tables are filled, and a single entry is left.
  struct Axis {
    PeriodicBins bins;
    double lo_per_um, hi_per_um;

    bool fixed() const { return lo_per_um == hi_per_um; }
    long first() const { return bins.first(lo_per_um); }
    long last() const { return bins.last(hi_per_um); }
    std::size_t stored() const {
      return fixed() ? 1 : static_cast<std::size_t>(last() - first() + 1);
    }
    std::size_t slot(long bin) const {
      return fixed() ? 0 : static_cast<std::size_t>(bin - first());
    }
    /// Weight of a bin at the time the tables are filled.
    double fill_weight(long bin) const { return fixed() ? bins.weight(lo_per_um, bin) : 1.0; }
    /// Calls visit(slot, weight) for each entry that a query needs.
    template <class Visit>
    void neighbours(double q_per_um, Visit visit) const {
      if (fixed()) return visit(std::size_t{0}, 1.0);
      for (long bin = bins.first(q_per_um); bin <= bins.last(q_per_um); ++bin)
        visit(slot(bin), bins.weight(q_per_um, bin));
    }
  };

  std::complex<double>* entry(std::size_t y_slot, std::size_t x_slot) {
    return &tables_[(y_slot * x_.stored() + x_slot) * static_cast<std::size_t>(terms_)];
  }
  const std::complex<double>* entry(std::size_t y_slot, std::size_t x_slot) const {
    return &tables_[(y_slot * x_.stored() + x_slot) * static_cast<std::size_t>(terms_)];
  }

  void fill(const HeightField& field) {
    RealFourier2d fourier(static_cast<int>(field.rows()), static_cast<int>(field.cols()));
    const std::span<double> power = fourier.samples();
    Eigen::Map<HeightArray> s_to_n(power.data(), field.rows(), field.cols());
    s_to_n = 1.0;
    const double scale = half_range_um_ > 0 ? 1 / half_range_um_ : 0.0;
    for (int n = 0; n < terms_; ++n) {
      if (n > 0) s_to_n *= (field.heights_um() - mid_range_um_) * scale;
      fourier.transform();
      store(fourier, n, static_cast<double>(field.heights_um().size()));
    }
  }

  void store(const RealFourier2d& fourier, int n, double pixels) {
    static constexpr std::complex<double> i_to_n[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (long j = y_.first(); j <= y_.last(); ++j)
      for (long l = x_.first(); l <= x_.last(); ++l)
        entry(y_.slot(j), x_.slot(l))[n] += i_to_n[n % 4] * fourier.bin(j, l) *
                                            y_.bins.origin_phase(j) * x_.bins.origin_phase(l) *
                                            (y_.fill_weight(j) * x_.fill_weight(l) / pixels);
  }

  void gather(const Query& query, std::vector<std::complex<double>>& sums) const {
    std::fill(sums.begin(), sums.end(), 0.0);
    y_.neighbours(query.qy_per_um, [&](std::size_t y_slot, double y_weight) {
      x_.neighbours(query.qx_per_um, [&](std::size_t x_slot, double x_weight) {
        const std::complex<double>* table = entry(y_slot, x_slot);
        const double weight = y_weight * x_weight;
        for (std::size_t n = 0; n < sums.size(); ++n) sums[n] += weight * table[n];
      });
    });
  }

  double half_range_um_, mid_range_um_;
  int terms_;
  Axis x_, y_;
  std::vector<std::complex<double>> tables_;
  PlanReport report_{};
};

/// a = e^{i c h_mid} sum_{n < N} (i c)^n / n! sum_bins DFT((h - h_mid)^n) / pixels * W
/// (Thesis 1.24, 1.32, 1.37, with the modulus outside both sums; Errata E5, E6, E22).
///
/// Heights are taken from the middle of their range and scaled to [-1, 1], which makes the
/// remainder smallest and keeps every power in range. Surface model: periodic.
/// Error: taylor_remainder_bound + taylor_rounding_bound + omitted_neighbours_bound +
/// gather_rounding_bound, reported by the plan; the rounding e^x / 2^53 makes the series useless
/// beyond phases x = c h / 2 of about 30 however many terms are taken. Cost: N transforms, then N x
/// neighbours products a query. Errc::invalid_argument: terms < 1, radius not > 0.
/// Errc::not_attainable: the tolerance needs more than max_terms.
class TaylorSeries {
 public:
  /// With x = 700 the terms overflow; 2000 of them reach past that.
  static constexpr int max_terms = 2000;
  /// Beyond 38 sigma_f the weight underflows.
  static constexpr double max_radius_sigma_f = 40;
  /// Weight 1.5e-8 at the edge: a worst error below 1e-7.
  static constexpr double default_radius_sigma_f = 6;

  explicit TaylorSeries(TaylorSettings settings = {}) : settings_(settings) {
    if (settings_.terms && !(*settings_.terms >= 1 && *settings_.terms <= max_terms))
      throw Error(Errc::invalid_argument, "terms " + std::to_string(*settings_.terms) +
                                              " must lie between 1 and " +
                                              std::to_string(max_terms));
    if (settings_.radius_sigma_f &&
        !(*settings_.radius_sigma_f > 0 && *settings_.radius_sigma_f <= max_radius_sigma_f))
      throw Error(Errc::invalid_argument, "window radius " + text(*settings_.radius_sigma_f) +
                                              " sigma_f must lie above 0 and up to " +
                                              text(max_radius_sigma_f));
  }

  static bool supports(SurfaceModel model) { return model == SurfaceModel::periodic; }

  std::size_t bytes(const Surface& surface, const QueryBounds& bounds) const {
    return TaylorSeriesPlan::bytes(surface, bounds, terms(surface, bounds),
                                   radius(surface, bounds));
  }

  TaylorSeriesPlan plan(const Surface& surface, const QueryBounds& bounds) const {
    return {surface, bounds, terms(surface, bounds), radius(surface, bounds)};
  }

  /// Half of the tolerance each for the remainder and for the neighbours left out.
  int terms(const Surface& surface, const QueryBounds& bounds) const {
    if (settings_.terms) return *settings_.terms;
    if (!(bounds.tolerance > 0))
      throw Error(Errc::invalid_argument, "tolerance " + text(bounds.tolerance) + " must be > 0");
    const double x = bounds.max_abs_c_per_um() * surface.heights->half_range_um();
    if (const auto terms = taylor_terms(x, bounds.tolerance / 2, max_terms)) return *terms;
    throw Error(Errc::not_attainable, "a Taylor series reaches tolerance " +
                                          text(bounds.tolerance) + " at phase depth " +
                                          text(2 * x) + " rad with no number of terms up to " +
                                          std::to_string(max_terms));
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
  TaylorSettings settings_;
};

static_assert(AmplitudeMethod<TaylorSeries>);

}  // namespace brdf
