// The pixels of a surface, projected on an oblique plane of incidence.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "brdf/chebyshev_columns.h"
#include "brdf/chebyshev_design.h"
#include "brdf/term_table.h"

namespace brdf {

namespace detail {

/// Illumination of the pixels of one axis of a tile, of sum 1.
inline std::vector<double> tile_illumination(const ChebyshevDesign& design, int index) {
  const SurfaceAxis& axis = design.axis(index);
  const bool evenly_lit = design.surface().model == SurfaceModel::replicated;
  std::vector<double> weights;
  double sum = 0;
  for (Eigen::Index pixel = 0; pixel < axis.count; ++pixel) {
    weights.push_back(evenly_lit ? 1 : illumination(design.surface(), axis.position_um(pixel)));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// The rows of one strip, spread over samples[n][m][re, im].
class StripProjection {
 public:
  StripProjection(const ChebyshevDesign& design, const SeriesKernels& kernels,
                  std::vector<double>& samples)
      : design_(design),
        kernels_(kernels),
        line_(*design.line()),
        terms_(static_cast<std::size_t>(design.terms().degrees())),
        taps_(InterpolationKernel::max_width),
        values_(2 * terms_ * lanes),
        pixel_(2 * terms_),
        samples_(samples) {
    const InterpolationKernel& kernel = line_.kernel();
    axis_ = {1,
             0,
             0,
             static_cast<long>(line_.count()),
             kernel.width(),
             kernel.degree(),
             kernel.pieces(),
             kernel.tap_stride(),
             kernel.coefficients().data(),
             static_cast<long>(line_.count()),
             1};
  }

  /// weights: of the columns; weight: of the row; t_um: of its first pixel, then each step_um more.
  void add_row(Eigen::Index row, const std::vector<double>& weights, double weight, double t_um,
               double step_um) {
    const HeightField& field = *design_.surface().heights;
    const double* heights = field.heights_um().data() + row * field.cols();
    const std::complex<double> one = weight;
    PixelStrip strip = pixel_scale(design_);
    strip.steps = 1;
    strip.weights = &one;
    for (std::size_t first = 0; first < weights.size(); first += lanes) {
      const std::size_t used = std::min(lanes, weights.size() - first);
      std::array<double, lanes> some;
      for (std::size_t lane = 0; lane < lanes; ++lane)
        some[lane] = heights[first + std::min(lane, used - 1)];
      strip.first_um = some.data();
      // One step: the sums are the values of single pixels.
      kernels_.contract(strip, static_cast<int>(terms_), values_.data());
      for (std::size_t lane = 0; lane < used; ++lane)
        add_pixel(lane, weights[first + lane],
                  line_.position(t_um + step_um * static_cast<double>(first + lane)));
    }
  }

 private:
  static constexpr std::size_t lanes = PixelStrip::lanes;

  void add_pixel(std::size_t lane, double weight, double position) {
    const std::size_t first = axis_taps(axis_, {position, 0, 0}, taps_), size = pixel_.size();
    for (std::size_t n = 0; n < size; ++n) pixel_[n] = weight * values_[n * lanes + lane];
    double* to = samples_.data() + first * size;
    const double* const from = pixel_.data();
    for (int tap = 0; tap < axis_.width; ++tap, to += size) {
      const double share = taps_[static_cast<std::size_t>(tap)];
      for (std::size_t n = 0; n < size; ++n) to[n] += share * from[n];
    }
  }

  const ChebyshevDesign& design_;
  const SeriesKernels& kernels_;
  const LineProjection& line_;
  std::size_t terms_;
  TableAxis axis_;
  std::vector<double> taps_, values_, pixel_;
  std::vector<double>& samples_;
};

}  // namespace detail

/// For an oblique plane of incidence: sum over the pixels of psi g e^{i c_mid r s} T_m(s) at each
/// sample of the line.
///
/// Strips of rows, as many whoever runs them, have samples of their own, which are added up strip
/// by strip. Cost: 2 width x degrees products per pixel.
inline ChebyshevColumns projected_columns(const ChebyshevDesign& design,
                                          const SeriesKernels& kernels) {
  const LineProjection& line = *design.line();
  const SurfaceAxis &x = design.axis(0), &y = design.axis(1);
  const std::vector<double> along_x = detail::tile_illumination(design, 0),
                            along_y = detail::tile_illumination(design, 1);
  const double step_x_um = x.pixel_um * line.direction().cos_azimuth,
               step_y_um = y.pixel_um * line.direction().sin_azimuth;
  const auto terms = static_cast<std::size_t>(design.terms().degrees());
  const std::size_t rows = along_y.size(), size = line.count() * terms * 2;
  const std::size_t strips = std::min(rows, ChebyshevDesign::line_strips);
  std::vector<std::vector<double>> partial(strips);
  design.executor()(strips, [&](std::size_t strip) {
    partial[strip].assign(size, 0.0);
    detail::StripProjection projection(design, kernels, partial[strip]);
    for (std::size_t row = rows * strip / strips; row < rows * (strip + 1) / strips; ++row) {
      const double t_um =
          step_y_um * (static_cast<double>(row) - static_cast<double>(rows - 1) / 2) -
          step_x_um * static_cast<double>(x.count - 1) / 2;
      projection.add_row(static_cast<Eigen::Index>(row), along_x, along_y[row], t_um, step_x_um);
    }
  });
  ChebyshevColumns columns{line.count(), {}};
  columns.samples.resize(terms * line.count());
  for (const std::vector<double>& samples : partial)
    for (std::size_t n = 0; n < line.count(); ++n)
      for (std::size_t m = 0; m < terms; ++m) {
        const double* value = &samples[2 * (n * terms + m)];
        columns.samples[m * line.count() + n] += std::complex<double>(value[0], value[1]);
      }
  return columns;
}

}  // namespace brdf
