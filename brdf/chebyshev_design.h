// What a Chebyshev plan will consist of: decided from the request before anything is computed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "brdf/chebyshev_carrier.h"
#include "brdf/chebyshev_line.h"
#include "brdf/chebyshev_terms.h"
#include "brdf/direct_sum.h"
#include "brdf/fourier_axis.h"
#include "brdf/series_plan_parts.h"
#include "brdf/term_table.h"

namespace brdf {

/// Makes the decisions. Everything follows from surface and bounds; nothing from threads.
/// Errc::over_limit: beyond max_depth_rad, unless the direct sum may be used.
class ChebyshevDesign {
 public:
  ChebyshevDesign(const Surface& surface, const QueryBounds& bounds,
                  const SeriesSettings& settings = {},
                  double direct_pixel_s = portable_kernels.direct_pixel_s)
      : surface_(surface),
        bounds_(bounds),
        settings_(settings),
        axes_{x_axis(surface), y_axis(surface)},
        tolerance_(std::clamp(bounds.tolerance, 1e-15, 1.0)),
        c_mid_per_um_(std::midpoint(bounds.lo.c_per_um, bounds.hi.c_per_um)),
        c_half_per_um_((bounds.hi.c_per_um - bounds.lo.c_per_um) / 2),
        terms_(depth_rad() <= max_depth_rad ? depth_rad() : 0, terms_share * tolerance_) {
    const double phasors = static_cast<double>(surface.heights->heights_um().size()) +
                           axes_[0].points() + axes_[1].points();
    const double direct_s = direct_pixel_s * phasors, count = static_cast<double>(bounds.count);
    if (depth_rad() > max_depth_rad) {
      if (settings.small_requests != SmallRequests::by_direct_sum)
        throw Error(Errc::over_limit, "the phase of the relief varies by " + text(2 * depth_rad()) +
                                          " rad over the request: a Chebyshev series is made for "
                                          "up to " +
                                          text(2 * max_depth_rad) +
                                          "; ask for a narrower range, or for the direct sum");
      use_direct_sum(direct_s);
      return;
    }
    const bool one_qx = bounds.lo.qx_per_um == bounds.hi.qx_per_um;
    const bool one_qy = bounds.lo.qy_per_um == bounds.hi.qy_per_um;
    // Folded weights along an oblique line do not exist for a periodic lattice.
    const bool carriable = std::abs(carrier_rad()) <= max_carrier_rad;
    parts_.projected =
        bounds.line && !one_qx && !one_qy && carriable && surface.model != SurfaceModel::periodic;
    const bool in_plane = (one_qx || one_qy || parts_.projected) && carriable;
    parts_.path = in_plane ? SeriesPath::in_plane : SeriesPath::general;
    // Modes save terms at every tap and cost degrees x terms / 16 products a query: worth while
    // where a query reads a square of taps.
    if (parts_.path == SeriesPath::general && terms_.degrees() <= TermTable<double>::max_degrees) {
      ChebyshevTerms modes(depth_rad(), terms_share * tolerance_, SeriesBasis::modes);
      if (modes.degrees() <= TermTable<double>::max_degrees && modes.count() < terms_.count())
        terms_ = std::move(modes);
    }
    parts_.terms = terms_.count();
    terms_norm_ = terms_.norm();
    if (parts_.path == SeriesPath::in_plane)
      carried_.emplace(terms_, carrier_rad(), carrier_share * tolerance_);
    inner_axis_ = in_plane && (one_qy || parts_.projected) ? 0 : 1;
    choose_grid(parts_.path == SeriesPath::general ? general_oversampling : in_plane_oversampling);
    if (parts_.path == SeriesPath::general) {
      // A finer grid saves a tap in each direction; it pays where many queries come.
      const ChebyshevDesign coarse(*this);
      choose_grid(general_oversampling_for_many);
      if (!(expected_s() < coarse.expected_s())) *this = coarse;
    }
    if (settings.small_requests == SmallRequests::by_direct_sum && count * direct_s < expected_s())
      use_direct_sum(direct_s);
  }

  const Surface& surface() const { return surface_; }
  const QueryBounds& bounds() const { return bounds_; }
  const SurfaceAxis& axis(int index) const { return axes_[index]; }
  const ChebyshevTerms& terms() const { return terms_; }
  const SeriesPlanParts& parts() const { return parts_; }
  const Executor& executor() const { return settings_.executor; }
  double c_mid_per_um() const { return c_mid_per_um_; }
  double c_half_per_um() const { return c_half_per_um_; }
  /// Phase of the middle of the range of k w at s = 1.
  double carrier_rad() const { return c_mid_per_um_ * surface_.heights->half_range_um(); }
  /// The terms as they are summed in a plane of incidence.
  const std::optional<CarriedTerms>& carried() const { return carried_; }
  const std::optional<FourierAxis>& outer() const { return outer_; }  ///< x of the general path
  const FourierAxis& inner() const { return *inner_; }
  const std::optional<LineProjection>& line() const { return line_; }  ///< of a projected plane
  /// The axis that the inner transform runs along: 0 x or an oblique line, 1 y.
  int inner_axis() const { return inner_axis_; }

  double error_bound() const {
    return parts_.series_error + parts_.kernel_error + parts_.storage_error + parts_.rounding_error;
  }

  /// [um] centre of an axis' copies: 0 unless the origin is the corner.
  double centre_um(int index) const {
    const SurfaceAxis& axis = axes_[index];
    return surface_.model == SurfaceModel::periodic
               ? 0.0
               : axis.pixel_um *
                     ((static_cast<double>(axis.count) * (1 + axis.first_copy + axis.last_copy) -
                       1) /
                          2 -
                      axis.origin);
  }

  /// Half of the change of c over the request, times half of the range of heights [rad]: the x of
  /// the series in T_n.
  double depth_rad() const { return c_half_per_um_ * surface_.heights->half_range_um(); }

  /// The coefficients of deeper series take minutes: their cost grows with the cube, 0.3 s at 1000.
  static constexpr double max_depth_rad = 1000;
  /// A larger carrier is multiplied out at every pixel (the general path): as a polynomial its
  /// coefficients take its square, half a minute and half a gigabyte at 1e4.
  static constexpr double max_carrier_rad = 1000;
  /// Partial sums of a projection: never more than this many strips of rows.
  static constexpr std::size_t line_strips = 32;

 private:
  // Shares of the tolerance. A term gains a factor 5 or more, so the series gets little; a tap
  // costs a whole row of products, so the kernels get what single-precision storage leaves.
  static constexpr double terms_share = 0.09, carrier_share = 0.01, double_kernel_share = 0.75,
                          single_kernel_share = 0.45;
  // In one dimension a finer grid costs next to nothing and saves a tap or two; in two it would
  // cost its square in memory.
  static constexpr double in_plane_oversampling = 4, general_oversampling = 2,
                          general_oversampling_for_many = 2.5;

  double expected_s() const {
    return parts_.plan_s + static_cast<double>(bounds_.count) * parts_.query_s;
  }

  void choose_grid(double oversampling) {
    // Wider kernels once more where that makes room for storage in single precision.
    if (!choose(double_kernel_share, oversampling) && !choose(single_kernel_share, oversampling))
      choose(double_kernel_share, oversampling);
    set_costs();
  }

  FourierAxis make_axis(int index, double tolerance, double oversampling) {
    const Query &lo = bounds_.lo, &hi = bounds_.hi;
    const FourierAxisRequest request{index == 0 ? lo.qx_per_um : lo.qy_per_um,
                                     index == 0 ? hi.qx_per_um : hi.qy_per_um, tolerance,
                                     oversampling};
    FourierAxis axis(surface_, axes_[index], request);
    axis.prepare();
    return axis;
  }

  static SeriesPlanParts::Axis part(const FourierAxis& axis) {
    return {axis.kernel().width(), axis.oversampling(), axis.length(), axis.stored()};
  }

  /// Axes for a share of the tolerance; whether the wanted precision fits into the rest.
  bool choose(double kernel_share, double oversampling) {
    const double share = kernel_share * tolerance_;
    if (parts_.path == SeriesPath::general) {
      outer_.emplace(make_axis(0, share / 2, oversampling));
      inner_.emplace(make_axis(1, share / 2, oversampling));
      parts_.axes[0] = part(*outer_);
    } else if (parts_.projected) {
      line_.emplace(surface_, bounds_, share / 3);
      inner_.emplace(EvenSamples{line_->count(), line_->pitch_um()},
                     FourierAxisRequest{line_->lo_per_um(), line_->hi_per_um(),
                                        share * (2.0 / 3) / line_->amplification(), oversampling});
    } else {
      inner_.emplace(make_axis(inner_axis_, share, oversampling));
    }
    parts_.axes[inner_axis_] = part(*inner_);
    set_errors();
    return parts_.storage == TableStorage::single_precision || !wants_single_precision();
  }

  std::size_t table_bytes(std::size_t real_bytes) const {
    const auto padded = static_cast<std::size_t>((terms_.count() + 3) / 4 * 4);
    return parts_.axes[0].stored * parts_.axes[1].stored * padded * 2 * real_bytes;
  }
  bool wants_single_precision() const {
    return table_bytes(sizeof(double)) > settings_.double_table_bytes;
  }

  void set_errors() {
    const double inner = inner_->error_bound(), outer = outer_ ? outer_->error_bound() : 0;
    parts_.series_error = terms_.error_bound() + (carried_ ? carried_->error_bound() : 0);
    const double line = line_ ? line_->error_bound() + inner * line_->amplification() : 0;
    parts_.kernel_error =
        (line_ ? line : (1 + inner) * (1 + outer) - 1) * (1 + parts_.series_error);
    const double grids = inner_->amplification() * (outer_ ? outer_->amplification() : 1) *
                         (line_ ? line_->amplification() : 1);
    const double amplification = grids * terms_norm_;
    const double summed = grids * (carried_ ? carried_->norm() : terms_norm_);
    const int degrees = carried_ ? carried_->degrees() : terms_.count();
    // Positions and phases are rounded to eps / 2 of themselves, in about three steps and weighted
    // by the mean distance from the centre, a fourth of the width or so; the recurrences add up.
    constexpr double eps = std::numeric_limits<double>::epsilon();
    parts_.rounding_error =
        eps * (max_phase_rad() + 4 * degrees + 4 * summed) + (line_ ? line_->offset_error() : 0);
    // Each entry is rounded once, by 2^-24 of itself; the sums are in double.
    const double single = std::ldexp(amplification, -24);
    const bool fits =
        wants_single_precision() &&
        parts_.series_error + parts_.kernel_error + single + parts_.rounding_error <= tolerance_;
    parts_.storage = fits ? TableStorage::single_precision : TableStorage::double_precision;
    parts_.storage_error = fits ? single : 0;
  }

  double max_phase_rad() const {
    const auto largest = [](double a, double b) { return std::max(std::abs(a), std::abs(b)); };
    const auto reach_um = [&](const SurfaceAxis& axis) {
      return largest(axis.position_um(0, axis.first_copy),
                     axis.position_um(axis.count, axis.last_copy));
    };
    const Query &lo = bounds_.lo, &hi = bounds_.hi;
    return largest(lo.qx_per_um, hi.qx_per_um) * reach_um(axes_[0]) / 2 +
           largest(lo.qy_per_um, hi.qy_per_um) * reach_um(axes_[1]) / 2 +
           bounds_.max_abs_c_per_um() *
               largest(surface_.heights->min_um(), surface_.heights->max_um());
  }

  void set_costs() {
    const auto& axes = parts_.axes;
    const double pixels = static_cast<double>(surface_.heights->heights_um().size());
    const double terms = terms_.count();
    const auto real_bytes =
        parts_.storage == TableStorage::single_precision ? sizeof(float) : sizeof(double);
    const auto padded = static_cast<std::size_t>((terms_.count() + 3) / 4 * 4);
    parts_.table_bytes = table_bytes(real_bytes);
    parts_.peak_bytes = parts_.table_bytes;
    double transforms = static_cast<double>(inner_->length());
    const auto degrees = static_cast<std::size_t>(carried_ ? carried_->degrees() : 0);
    if (outer_) {
      constexpr std::size_t complex_bytes = 2 * sizeof(double);
      parts_.peak_bytes +=
          static_cast<std::size_t>(pixels) * (complex_bytes + sizeof(double)) +
          axes[0].stored * static_cast<std::size_t>(axes_[1].count) * complex_bytes;
      transforms = static_cast<double>(axes_[1].count) * static_cast<double>(outer_->length()) +
                   static_cast<double>(outer_->stored() * inner_->length());
    } else if (line_) {
      parts_.peak_bytes +=
          (line_strips + 1) * line_->count() * (degrees + SpreadLine::step) * sizeof(double);
    } else {
      parts_.peak_bytes += 2 *
                           static_cast<std::size_t>(axes_[inner_axis_].count + PixelStrip::lanes) *
                           degrees * sizeof(double);
    }
    // Measured on AVX-512: half a millisecond for kernels and coefficients, 2 ns per pixel and 2 ns
    // per pixel and term, in the plane 0.1 ns per pixel and degree, 12 ns per point transformed; 15
    // ns per query and 0.2 ns per product of the gather.
    parts_.plan_s = 5e-4 + 12e-9 * terms * transforms +
                    1e-9 * pixels * (outer_ ? 2 + 2 * terms : 0.1 * carried_->degrees());
    if (line_)
      parts_.plan_s += 1e-9 * pixels * (8 + 0.1 * line_->kernel().width() * carried_->degrees());
    parts_.query_s =
        1e-9 * (15 + 0.2 * static_cast<double>(padded) * axes[0].width * axes[1].width);
  }

  void use_direct_sum(double direct_s) {
    const PlanReport report = DirectSum{}.plan(surface_, bounds_).report();
    parts_ = SeriesPlanParts{};
    parts_.path = SeriesPath::direct_sum;
    parts_.storage = TableStorage::double_precision;
    parts_.rounding_error = report.error_bound;
    parts_.query_s = direct_s;
  }

  Surface surface_;
  QueryBounds bounds_;
  SeriesSettings settings_;
  SurfaceAxis axes_[2];
  double tolerance_, c_mid_per_um_, c_half_per_um_;
  ChebyshevTerms terms_;
  double terms_norm_ = 1;
  std::optional<CarriedTerms> carried_;
  SeriesPlanParts parts_{};
  int inner_axis_ = 0;
  std::optional<FourierAxis> outer_, inner_;
  std::optional<LineProjection> line_;
};

}  // namespace brdf
