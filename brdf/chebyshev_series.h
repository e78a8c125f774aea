// The method that is exact to a tolerance: a Chebyshev series in the height and in k w.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brdf/chebyshev_design.h"
#include "brdf/chebyshev_table.h"
#include "brdf/pq_factors.h"
#include "brdf/query_order.h"

namespace brdf {

/// Plan of the Chebyshev series. See ChebyshevSeries.
class ChebyshevSeriesPlan {
 public:
  ChebyshevSeriesPlan(const ChebyshevDesign& design, const SeriesKernels& kernels)
      : kernels_(kernels),
        bounds_(design.bounds()),
        parts_(design.parts()),
        report_{design.error_bound(),
                input_phase_error_rad(*design.surface().heights, design.bounds()), parts_.terms, 0,
                parts_.table_bytes},
        line_(parts_.projected ? design.line() : std::nullopt) {
    if (parts_.path == SeriesPath::direct_sum)
      direct_.emplace(design.surface(), design.bounds(), kernels.phases);
    else if (parts_.storage == TableStorage::single_precision)
      single_.emplace(design, kernels);
    else
      double_.emplace(design, kernels);
    for (int index : {0, 1}) {
      const SurfaceAxis& axis = design.axis(index);
      const bool summed = parts_.axes[index].fft_length == 0 && !line_;
      copies_[index] = {summed ? 1 : axis.copies(), axis};
    }
    replicated_ = design.surface().model == SurfaceModel::replicated && !direct_;
  }

  /// Throws Errc::invalid_argument for a query outside the plan's bounds.
  void evaluate(std::span<const Query> queries, std::span<std::complex<double>> amplitudes) const {
    if (direct_) {
      require_within_bounds(queries);
      return direct_->evaluate(queries, amplitudes);
    }
    const auto gather = [&](std::span<const Query> some, std::span<std::complex<double>> out) {
      if (single_)
        kernels_.gather_float(single_->view(), some.data(), some.size(), out.data());
      else
        kernels_.gather_double(double_->view(), some.data(), some.size(), out.data());
    };
    if (parts_.path == SeriesPath::general) {
      require_within_bounds(queries);
      in_tile_order(queries, amplitudes, single_ ? single_->tiles() : double_->tiles(), gather);
    } else {
      // Piece by piece, so that queries are fetched once for the check and the gather.
      constexpr std::size_t piece = 1024;
      for (std::size_t first = 0; first < queries.size(); first += piece) {
        const std::size_t count = std::min(piece, queries.size() - first);
        require_within_bounds(queries.subspan(first, count));
        gather(queries.subspan(first, count), amplitudes.subspan(first, count));
      }
    }
    if (line_)
      for (std::size_t i = 0; i < queries.size(); ++i)
        amplitudes[i] *= line_->correction(queries[i]);
    if (replicated_)
      for (std::size_t i = 0; i < queries.size(); ++i)
        amplitudes[i] *=
            copies_[0].factor(queries[i].qx_per_um) * copies_[1].factor(queries[i].qy_per_um);
  }

  PlanReport report() const { return report_; }
  const SeriesPlanParts& explain() const { return parts_; }

 private:
  struct Copies {
    int count = 1;
    SurfaceAxis axis{};

    double factor(double q_per_um) const { return pq_factor(axis.cycles(q_per_um), count); }
  };

  void require_within_bounds(std::span<const Query> queries) const {
    if (queries.empty()) return;
    const QueryBounds box = bounds_of(queries, bounds_.tolerance);  // faster than one by one
    if (!line_ && bounds_.hold(box.lo) && bounds_.hold(box.hi)) return;
    for (const Query& q : queries) require_within_bounds(q);
  }

  void require_within_bounds(const Query& q) const {
    bounds_.require_holds(q);
    if (line_ && !line_->contains(q))
      throw Error(Errc::invalid_argument, "query (" + text(q.qx_per_um) + ", " + text(q.qy_per_um) +
                                              ") rad/um lies off the line of its plan");
  }

  SeriesKernels kernels_;
  QueryBounds bounds_;
  SeriesPlanParts parts_;
  PlanReport report_;
  std::optional<LineProjection> line_;
  std::optional<DirectSumPlan> direct_;
  std::optional<ChebyshevTable<float>> single_;
  std::optional<ChebyshevTable<double>> double_;
  Copies copies_[2];
  bool replicated_ = false;
};

/// a = e^{i c h_mid} sum_{n < R} T_n(tau) sum_x,y g e^{i c_mid r s} a_n(s) e^{i (qx x + qy y)},
/// with h = h_mid + r s, c = c_mid + c_half tau and a_n(s) = sum_m M_nm T_m(s) (ChebyshevTerms):
/// the transform of R real functions of the surface instead of one per wavelength and angle.
///
/// The tolerance of the bounds, 1e-1 to 1e-14, fixes everything: R, the kernels between the points
/// of the frequency grids (FourierAxis), and whether the table is kept in single precision. Queries
/// in one plane of incidence need 1-D transforms: along x or y the pixels are summed across it
/// exactly, along the `line` of the bounds they are projected on it (not periodic surfaces); only
/// frequencies inside the bounds are kept; few queries go to the direct sum. Surface models: all.
/// Error: at most `report().error_bound`, which is at most the tolerance unless rounding forbids it
/// (about 2e-16 times the largest phase); measured in chebyshev_series.tests.cpp. Cost in the
/// plane: two products per pixel and degree (CarriedTerms), then width x R products per query; else
/// R 2-D transforms, then width^2 x R products per query. Results depend on the query and the plan
/// only, to the last bit, whatever the batch or threads. Errc::invalid_argument: a tolerance that
/// is not > 0. Errc::over_limit: beyond ChebyshevDesign::max_depth_rad, where the direct sum may
/// not be used. Sources: Jacobi-Anger; Barnett, Magland, af Klinteberg (SIAM J. Sci. Comput. 41,
/// 2019).
class ChebyshevSeries {
 public:
  /// kernels: portable_kernels, or the vectorised ones of shedlight::kernels.
  explicit ChebyshevSeries(const SeriesKernels& kernels = portable_kernels,
                           const SeriesSettings& settings = {})
      : kernels_(kernels), settings_(settings) {}

  static bool supports(SurfaceModel) { return true; }

  /// The parts of the plan, without making it.
  SeriesPlanParts explain(const Surface& surface, const QueryBounds& bounds) const {
    return design(surface, bounds).parts();
  }

  /// Bytes that a plan takes at its largest, its transforms included.
  std::size_t bytes(const Surface& surface, const QueryBounds& bounds) const {
    return explain(surface, bounds).peak_bytes;
  }

  ChebyshevSeriesPlan plan(const Surface& surface, const QueryBounds& bounds) const {
    return {design(surface, bounds), kernels_};
  }

 private:
  ChebyshevDesign design(const Surface& surface, const QueryBounds& bounds) const {
    if (!(bounds.tolerance > 0))
      throw Error(Errc::invalid_argument, "tolerance " + text(bounds.tolerance) + " must be > 0");
    return {surface, bounds, settings_, kernels_.direct_pixel_s};
  }

  SeriesKernels kernels_;
  SeriesSettings settings_;
};

static_assert(AmplitudeMethod<ChebyshevSeries>);

}  // namespace brdf
