// The reference: the amplitude by its definition, pixel by pixel.
#pragma once

#include <algorithm>
#include <complex>
#include <span>
#include <vector>

#include "brdf/amplitude.h"
#include "brdf/phase_sum.h"

namespace brdf {

/// Plan of the direct sum. See DirectSum.
class DirectSumPlan {
 public:
  DirectSumPlan(const Surface& surface, const QueryBounds& bounds,
                const PhaseKernels& kernels = portable_phase_kernels)
      : kernels_(kernels),
        surface_(surface),
        x_(summable(x_axis(surface))),
        y_(summable(y_axis(surface))),
        norm_(window_sums(surface, x_).g * window_sums(surface, y_).g),
        input_phase_error_rad_(input_phase_error_rad(*surface.heights, bounds)),
        max_phase_rad_(max_phase(bounds)),
        x_points_(points(x_)),
        y_points_(points(y_)) {}

  void evaluate(std::span<const Query> queries, std::span<std::complex<double>> amplitudes) const {
    Weights along_x(x_.count), along_y(y_.count);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      fill(x_points_, queries[i].qx_per_um, along_x);
      fill(y_points_, queries[i].qy_per_um, along_y);
      amplitudes[i] = sum(queries[i].c_per_um, along_x, along_y);
    }
  }

  /// Rounding alone: about 2 eps times the largest phase.
  PlanReport report() const {
    return {2 * std::numeric_limits<double>::epsilon() * std::max(1.0, max_phase_rad_),
            input_phase_error_rad_, 0, 0, bytes(x_, y_)};
  }

  /// Bytes of the positions and the illumination along both axes.
  static std::size_t bytes(const SurfaceAxis& x, const SurfaceAxis& y) {
    return static_cast<std::size_t>(x.points() + y.points()) * 2 * sizeof(double);
  }

  /// Pixels along an axis, all repetitions counted: a gigabyte of positions.
  static constexpr double max_axis_points = 1 << 26;

 private:
  static SurfaceAxis summable(const SurfaceAxis& axis) {
    if (axis.points() > max_axis_points)
      throw Error(Errc::over_limit, "a direct sum over " + text(axis.points()) +
                                        " pixels along an axis: the limit is " +
                                        text(max_axis_points));
    return axis;
  }

  /// Per pixel of an axis: sum over its repetitions of g(x) exp(i q x).
  struct Weights {
    std::vector<double> re, im;
    explicit Weights(Eigen::Index count)
        : re(static_cast<std::size_t>(count)), im(static_cast<std::size_t>(count)) {}
  };

  /// All pixels of an axis, repetition by repetition.
  struct Points {
    std::vector<double> x_um, illumination;
  };

  Points points(const SurfaceAxis& axis) const {
    Points all;
    for (int copy = axis.first_copy; copy <= axis.last_copy; ++copy)
      for (Eigen::Index index = 0; index < axis.count; ++index) {
        all.x_um.push_back(axis.position_um(index, copy));
        all.illumination.push_back(illumination(surface_, all.x_um.back()));
      }
    return all;
  }

  double max_phase(const QueryBounds& bounds) const {
    const auto largest = [](double lo, double hi) { return std::max(std::abs(lo), std::abs(hi)); };
    const HeightField& field = *surface_.heights;
    return largest(bounds.lo.qx_per_um, bounds.hi.qx_per_um) *
               x_.position_um(x_.count, x_.last_copy) +
           largest(bounds.lo.qy_per_um, bounds.hi.qy_per_um) *
               y_.position_um(y_.count, y_.last_copy) +
           bounds.max_abs_c_per_um() * largest(field.min_um(), field.max_um());
  }

  void fill(const Points& points, double q_per_um, Weights& weights) const {
    std::fill(weights.re.begin(), weights.re.end(), 0.0);
    std::fill(weights.im.begin(), weights.im.end(), 0.0);
    const std::size_t count = weights.re.size();
    for (std::size_t first = 0; first < points.x_um.size(); first += count)
      kernels_.add_phasors({&points.x_um[first], &points.illumination[first], count}, q_per_um,
                           weights.re.data(), weights.im.data());
  }

  std::complex<double> sum(double c_per_um, const Weights& along_x, const Weights& along_y) const {
    const HeightField& field = *surface_.heights;
    std::complex<double> total = 0;
    for (std::size_t row = 0; row < along_y.re.size(); ++row)
      total += std::complex<double>(along_y.re[row], along_y.im[row]) *
               kernels_.row_sum({&field.heights_um()(static_cast<Eigen::Index>(row), 0),
                                 along_x.re.data(), along_x.im.data(), along_x.re.size(),
                                 field.mid_range_um(), field.half_range_um(), c_per_um});
    return total * std::polar(1.0, c_per_um * field.mid_range_um()) / norm_;
  }

  PhaseKernels kernels_;
  Surface surface_;
  SurfaceAxis x_, y_;
  double norm_, input_phase_error_rad_, max_phase_rad_;
  Points x_points_, y_points_;
};

/// a = sum g exp(i c h) exp(i (qx x + qy y)) / sum g over the pixels of the patch (isolated) or
/// over all its repetitions: within 9 sigma_s (periodic; Thesis 1.32 before any transform), or the
/// Nx x Ny evenly lit ones, g = 1 (replicated).
///
/// Not a transform and not a series: the oracle of every other method. For the periodic model the
/// sum over the repetitions is taken per axis first, which only reorders it.
/// Error: rounding, about 2 eps times the largest phase; measured against sums made elsewhere in
/// direct_sum.tests.cpp. Cost: one sine and cosine per pixel and query. Errc::over_limit: more than
/// max_axis_points pixels along an axis, all repetitions counted.
class DirectSum {
 public:
  /// kernels: portable_phase_kernels, or the vectorised ones of shedlight::kernels.
  explicit DirectSum(const PhaseKernels& kernels = portable_phase_kernels) : kernels_(kernels) {}

  static bool supports(SurfaceModel) { return true; }
  static std::size_t bytes(const Surface& surface, const QueryBounds&) {
    return DirectSumPlan::bytes(x_axis(surface), y_axis(surface));
  }
  DirectSumPlan plan(const Surface& surface, const QueryBounds& bounds) const {
    return {surface, bounds, kernels_};
  }

 private:
  PhaseKernels kernels_;
};

static_assert(AmplitudeMethod<DirectSum>);

}  // namespace brdf
