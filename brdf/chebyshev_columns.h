// The pixels of a surface, summed across one plane of incidence.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <vector>

#include "brdf/chebyshev_design.h"
#include "brdf/term_table.h"

namespace brdf {

/// What a table of one plane of incidence is transformed from: samples[m * count + i], degree m of
/// the series at sample i along the plane.
struct ChebyshevColumns {
  std::size_t count;
  std::vector<std::complex<double>> samples;
};

/// How the heights of a design's surface become s and phases; no pixels yet.
inline PixelStrip pixel_scale(const ChebyshevDesign& design) {
  const HeightField& field = *design.surface().heights;
  const double half_um = field.half_range_um();
  return {nullptr,
          0,
          0,
          nullptr,
          field.mid_range_um(),
          half_um > 0 ? 1 / half_um : 0,
          design.c_mid_per_um() * half_um};
}

namespace detail {

/// Illumination times exp(i q x) of the axis that is summed away, over its copies; sum of g 1.
inline std::vector<std::complex<double>> summed_weights(const ChebyshevDesign& design, int index) {
  const SurfaceAxis& axis = design.axis(index);
  const double q_per_um = index == 0 ? design.bounds().lo.qx_per_um : design.bounds().lo.qy_per_um;
  const double norm = window_sums(design.surface(), axis).g;
  std::vector<std::complex<double>> weights(static_cast<std::size_t>(axis.count));
  for (Eigen::Index pixel = 0; pixel < axis.count; ++pixel) {
    std::complex<double> weight = 0;
    for (int copy = axis.first_copy; copy <= axis.last_copy; ++copy) {
      const double x_um = axis.position_um(pixel, copy);
      weight += std::polar(illumination(design.surface(), x_um), q_per_um * x_um);
    }
    weights[static_cast<std::size_t>(pixel)] = weight / norm;
  }
  return weights;
}

}  // namespace detail

/// For the plane of incidence along x or y: sum across it of w_j e^{i c_mid r s} T_m(s), exactly.
inline ChebyshevColumns contracted_columns(const ChebyshevDesign& design,
                                           const SeriesKernels& kernels) {
  const HeightField& field = *design.surface().heights;
  const int kept = design.inner_axis(), terms = design.terms().degrees();
  constexpr std::size_t lanes = PixelStrip::lanes;
  const std::vector<std::complex<double>> weights = detail::summed_weights(design, 1 - kept);
  const auto count = static_cast<std::size_t>(design.axis(kept).count);
  ChebyshevColumns columns{count, {}};
  columns.samples.resize(static_cast<std::size_t>(terms) * count);
  const auto contract_lanes = [&](std::size_t first, std::vector<double>& gathered,
                                  std::vector<double>& sums) {
    const std::size_t used = std::min(lanes, count - first);
    PixelStrip strip = pixel_scale(design);
    strip.steps = weights.size();
    strip.weights = weights.data();
    if (kept == 0 && used == lanes) {
      strip.first_um = field.heights_um().data() + first;
      strip.stride = field.cols();
    } else {
      gathered.resize(weights.size() * lanes);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const auto pixel = static_cast<Eigen::Index>(first + std::min(lane, used - 1));
        for (std::size_t step = 0; step < weights.size(); ++step) {
          const auto across = static_cast<Eigen::Index>(step);
          gathered[step * lanes + lane] =
              kept == 0 ? field.heights_um()(across, pixel) : field.heights_um()(pixel, across);
        }
      }
      strip.first_um = gathered.data();
      strip.stride = lanes;
    }
    kernels.contract(strip, terms, sums.data());
    for (std::size_t m = 0; m < static_cast<std::size_t>(terms); ++m)
      for (std::size_t lane = 0; lane < used; ++lane)
        columns.samples[m * count + first + lane] = {sums[2 * m * lanes + lane],
                                                     sums[(2 * m + 1) * lanes + lane]};
  };
  constexpr std::size_t batch = 4 * lanes;  // pixels of one task: two cache lines of a row
  design.executor()((count + batch - 1) / batch, [&](std::size_t task) {
    std::vector<double> gathered, sums(static_cast<std::size_t>(2 * terms) * lanes);
    for (std::size_t first = task * batch; first < std::min(count, (task + 1) * batch);
         first += lanes)
      contract_lanes(first, gathered, sums);
  });
  return columns;
}

}  // namespace brdf
