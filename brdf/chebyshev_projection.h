// The pixels of a surface, projected on an oblique plane of incidence.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
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

/// The rows of one strip, spread over the samples of a line.
class StripProjection {
 public:
  /// samples: stride(design) for each sample of the line.
  StripProjection(const ChebyshevDesign& design, const SeriesKernels& kernels,
                  std::vector<double>& samples)
      : design_(design), kernels_(kernels), moments_(stride(design) * lanes) {
    const InterpolationKernel& kernel = design.line()->kernel();
    const auto count = static_cast<long>(design.line()->count());
    const TableAxis axis{1,
                         0,
                         0,
                         count,
                         kernel.width(),
                         kernel.degree(),
                         kernel.pieces(),
                         kernel.tap_stride(),
                         kernel.coefficients().data(),
                         count,
                         1};
    line_ = {axis, design.carried()->degrees(), stride(design), samples.data()};
  }

  static std::size_t stride(const ChebyshevDesign& design) {
    constexpr int step = SpreadLine::step;
    return static_cast<std::size_t>((design.carried()->degrees() + step - 1) / step * step);
  }

  /// weights: of the columns; weight: of the row; t_um: of its first pixel, then each step_um more.
  void add_row(Eigen::Index row, const std::vector<double>& weights, double weight, double t_um,
               double step_um) {
    const HeightField& field = *design_.surface().heights;
    const double* heights_um = field.heights_um().data() + row * field.cols();
    PixelStrip strip = pixel_scale(design_);
    strip.steps = 1;  // the sums are the values of single pixels
    strip.weights = &weight;
    for (std::size_t first = 0; first < weights.size(); first += lanes) {
      const std::size_t used = std::min(lanes, weights.size() - first);
      std::array<double, lanes> some_um, some_weights, positions;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const std::size_t pixel = first + std::min(lane, used - 1);
        some_um[lane] = heights_um[pixel];
        some_weights[lane] = weights[pixel];
        positions[lane] = design_.line()->position(t_um + step_um * static_cast<double>(pixel));
      }
      strip.first_um = some_um.data();
      kernels_.moments(strip, line_.degrees, moments_.data());
      kernels_.spread(line_, positions.data(), some_weights.data(), static_cast<int>(used),
                      moments_.data());
    }
  }

 private:
  static constexpr std::size_t lanes = PixelStrip::lanes;

  const ChebyshevDesign& design_;
  const SeriesKernels& kernels_;
  std::vector<double> moments_;
  SpreadLine line_;
};

}  // namespace detail

/// For an oblique plane of incidence: sum over the pixels of psi g T_m(s) at each sample of the
/// line. `beside` is run once, by any thread.
///
/// Strips of rows, as many whoever runs them, have samples of their own, which are added up strip
/// by strip. Cost: width x degrees products per pixel.
inline ChebyshevColumns projected_columns(const ChebyshevDesign& design,
                                          const SeriesKernels& kernels,
                                          const std::function<void()>& beside) {
  const LineProjection& line = *design.line();
  const SurfaceAxis &x = design.axis(0), &y = design.axis(1);
  const std::vector<double> along_x = detail::tile_illumination(design, 0),
                            along_y = detail::tile_illumination(design, 1);
  const double step_x_um = x.pixel_um * line.direction().cos_azimuth,
               step_y_um = y.pixel_um * line.direction().sin_azimuth;
  const auto degrees = static_cast<std::size_t>(design.carried()->degrees());
  const std::size_t rows = along_y.size(), stride = detail::StripProjection::stride(design),
                    size = line.count() * stride;
  const std::size_t strips = std::min(rows, ChebyshevDesign::line_strips);
  std::vector<std::vector<double>> partial(strips);
  design.executor()(1 + strips, [&](std::size_t task) {
    if (task == 0) return beside();
    const std::size_t strip = task - 1;
    partial[strip].assign(size, 0.0);
    detail::StripProjection projection(design, kernels, partial[strip]);
    for (std::size_t row = rows * strip / strips; row < rows * (strip + 1) / strips; ++row) {
      const double t_um =
          step_y_um * (static_cast<double>(row) - static_cast<double>(rows - 1) / 2) -
          step_x_um * static_cast<double>(x.count - 1) / 2;
      projection.add_row(static_cast<Eigen::Index>(row), along_x, along_y[row], t_um, step_x_um);
    }
  });
  ChebyshevColumns columns{line.count(), std::vector<double>(line.count() * degrees), {}};
  for (const std::vector<double>& samples : partial)
    for (std::size_t n = 0; n < line.count(); ++n)
      for (std::size_t m = 0; m < degrees; ++m)
        columns.re[m * line.count() + n] += samples[n * stride + m];
  return columns;
}

}  // namespace brdf
