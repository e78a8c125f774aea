// The reference: the amplitude by its definition, pixel by pixel.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "brdf/amplitude.h"

namespace brdf {

/// Plan of the direct sum. See DirectSum.
class DirectSumPlan {
 public:
  DirectSumPlan(const Surface& surface, const QueryBounds& bounds)
      : surface_(surface),
        x_(x_axis(surface)),
        y_(y_axis(surface)),
        norm_(window_sums(surface.window, x_).g * window_sums(surface.window, y_).g),
        input_phase_error_rad_(input_phase_error_rad(*surface.heights, bounds)),
        max_phase_rad_(max_phase(bounds)) {}

  void evaluate(std::span<const Query> queries, std::span<std::complex<double>> amplitudes) const {
    std::vector<std::complex<double>> along_x(static_cast<std::size_t>(x_.count));
    std::vector<std::complex<double>> along_y(static_cast<std::size_t>(y_.count));
    for (std::size_t i = 0; i < queries.size(); ++i) {
      fill(x_, queries[i].qx_per_um, along_x);
      fill(y_, queries[i].qy_per_um, along_y);
      amplitudes[i] = sum(queries[i].c_per_um, along_x, along_y);
    }
  }

  /// Rounding alone: about 2 eps times the largest phase.
  PlanReport report() const {
    return {2 * std::numeric_limits<double>::epsilon() * std::max(1.0, max_phase_rad_),
            input_phase_error_rad_, 0, 0, 0};
  }

 private:
  using Weights = std::vector<std::complex<double>>;

  double max_phase(const QueryBounds& bounds) const {
    const auto largest = [](double lo, double hi) { return std::max(std::abs(lo), std::abs(hi)); };
    const HeightField& field = *surface_.heights;
    return largest(bounds.lo.qx_per_um, bounds.hi.qx_per_um) * x_.position_um(x_.count, x_.copies) +
           largest(bounds.lo.qy_per_um, bounds.hi.qy_per_um) * y_.position_um(y_.count, y_.copies) +
           bounds.max_abs_c_per_um() * largest(field.min_um(), field.max_um());
  }

  /// Per pixel of an axis: sum over its repetitions of g(x) exp(i q x).
  void fill(const SurfaceAxis& axis, double q_per_um, Weights& weights) const {
    for (Eigen::Index index = 0; index < axis.count; ++index) {
      std::complex<double> weight = 0;
      for (int copy = -axis.copies; copy <= axis.copies; ++copy) {
        const double x_um = axis.position_um(index, copy);
        weight += std::polar(surface_.window.spatial(x_um), q_per_um * x_um);
      }
      weights[static_cast<std::size_t>(index)] = weight;
    }
  }

  std::complex<double> sum(double c_per_um, const Weights& along_x, const Weights& along_y) const {
    const HeightArray& heights_um = surface_.heights->heights_um();
    const double mid_um = surface_.heights->mid_range_um();
    std::complex<double> total = 0;
    for (Eigen::Index row = 0; row < y_.count; ++row) {
      double re = 0, im = 0;
      for (Eigen::Index col = 0; col < x_.count; ++col) {
        const double phase = c_per_um * (heights_um(row, col) - mid_um);
        const double cosine = std::cos(phase), sine = std::sin(phase);
        const std::complex<double>& weight = along_x[static_cast<std::size_t>(col)];
        re += weight.real() * cosine - weight.imag() * sine;
        im += weight.real() * sine + weight.imag() * cosine;
      }
      total += along_y[static_cast<std::size_t>(row)] * std::complex<double>(re, im);
    }
    return total * std::polar(1.0, c_per_um * mid_um) / norm_;
  }

  Surface surface_;
  SurfaceAxis x_, y_;
  double norm_, input_phase_error_rad_, max_phase_rad_;
};

/// a = sum g exp(i c h) exp(i (qx x + qy y)) / sum g over the pixels of the patch (isolated) or
/// over all its repetitions within 9 sigma_s (periodic; Thesis 1.32 before any transform).
///
/// Not a transform and not a series: the oracle of every other method. For the periodic model the
/// sum over the repetitions is taken per axis first, which only reorders it.
/// Error: rounding, about 2 eps times the largest phase; measured against sums made elsewhere in
/// direct_sum.tests.cpp. Cost: one sine and cosine per pixel and query.
struct DirectSum {
  static bool supports(SurfaceModel) { return true; }
  static std::size_t bytes(const Surface&, const QueryBounds&) { return 0; }
  DirectSumPlan plan(const Surface& surface, const QueryBounds& bounds) const {
    return {surface, bounds};
  }
};

static_assert(AmplitudeMethod<DirectSum>);

}  // namespace brdf
