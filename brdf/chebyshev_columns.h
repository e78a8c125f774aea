// The pixels of a surface, summed across one plane of incidence.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

#include "brdf/chebyshev_design.h"
#include "brdf/pq_factors.h"
#include "brdf/term_table.h"

namespace brdf {

/// What a table of one plane of incidence is transformed from: the moments of the heights across
/// it, re[m * count + i] of degree m at sample i along the plane; im is empty where all weights are
/// real.
struct ChebyshevColumns {
  std::size_t count;
  std::vector<double> re, im;
};

/// How the heights of a design's surface become s; no pixels yet.
inline PixelStrip pixel_scale(const ChebyshevDesign& design) {
  const HeightField& field = *design.surface().heights;
  const double half_um = field.half_range_um();
  return {nullptr, 0, 0, nullptr, field.mid_range_um(), half_um > 0 ? 1 / half_um : 0};
}

namespace detail {

struct SummedWeights {
  std::vector<double> re, im;  ///< im is empty where all are real
};

/// Illumination times exp(i q x) of the axis that is summed away, over its copies; sum of g 1.
/// Evenly lit copies are those of the middle tile times their PQ factor, any number of them.
inline SummedWeights summed_weights(const ChebyshevDesign& design, int index) {
  const SurfaceAxis& axis = design.axis(index);
  const double q_per_um = index == 0 ? design.bounds().lo.qx_per_um : design.bounds().lo.qy_per_um;
  const bool replicated = design.surface().model == SurfaceModel::replicated;
  const double factor =
      (replicated ? pq_factor(axis.cycles(q_per_um), axis.copies()) * axis.copies() : 1.0) /
      window_sums(design.surface(), axis).g;
  const SurfaceAxis summed = replicated ? axis.middle_tile(design.centre_um(index)) : axis;
  SummedWeights weights;
  for (Eigen::Index pixel = 0; pixel < axis.count; ++pixel) {
    std::complex<double> weight = 0;
    for (int copy = summed.first_copy; copy <= summed.last_copy; ++copy) {
      const double x_um = summed.position_um(pixel, copy);
      weight += std::polar(illumination(design.surface(), x_um), q_per_um * x_um);
    }
    weights.re.push_back(weight.real() * factor);
    if (q_per_um != 0) weights.im.push_back(weight.imag() * factor);
  }
  return weights;
}

}  // namespace detail

/// For the plane of incidence along x or y: sum across it of w_j T_m(s), exactly. `beside` is run
/// once, by any thread.
inline ChebyshevColumns contracted_columns(const ChebyshevDesign& design,
                                           const SeriesKernels& kernels,
                                           const std::function<void()>& beside) {
  const HeightField& field = *design.surface().heights;
  const int kept = design.inner_axis(), degrees = design.carried()->degrees();
  constexpr std::size_t lanes = PixelStrip::lanes;
  const detail::SummedWeights weights = detail::summed_weights(design, 1 - kept);
  const std::size_t steps = weights.re.size();
  const auto count = static_cast<std::size_t>(design.axis(kept).count);
  ChebyshevColumns columns{count, {}, {}};
  columns.re.resize(static_cast<std::size_t>(degrees) * count);
  if (!weights.im.empty()) columns.im.resize(columns.re.size());
  const auto contract_lanes = [&](std::size_t first, std::vector<double>& gathered,
                                  std::vector<double>& sums) {
    const std::size_t used = std::min(lanes, count - first);
    PixelStrip strip = pixel_scale(design);
    strip.steps = steps;
    if (kept == 0 && used == lanes) {
      strip.first_um = field.heights_um().data() + first;
      strip.stride = field.cols();
    } else {
      gathered.resize(steps * lanes);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const auto pixel = static_cast<Eigen::Index>(first + std::min(lane, used - 1));
        for (std::size_t step = 0; step < steps; ++step) {
          const auto across = static_cast<Eigen::Index>(step);
          gathered[step * lanes + lane] =
              kept == 0 ? field.heights_um()(across, pixel) : field.heights_um()(pixel, across);
        }
      }
      strip.first_um = gathered.data();
      strip.stride = lanes;
    }
    const auto sum_into = [&](std::vector<double>& moments, const std::vector<double>& some) {
      strip.weights = some.data();
      kernels.moments(strip, degrees, sums.data());
      for (std::size_t m = 0; m < static_cast<std::size_t>(degrees); ++m)
        std::copy_n(&sums[m * lanes], used, &moments[m * count + first]);
    };
    sum_into(columns.re, weights.re);
    if (!weights.im.empty()) sum_into(columns.im, weights.im);
  };
  constexpr std::size_t batch = 4 * lanes;  // pixels of one task: two cache lines of a row
  design.executor()(1 + (count + batch - 1) / batch, [&](std::size_t task) {
    if (task == 0) return beside();
    std::vector<double> gathered, sums(static_cast<std::size_t>(degrees) * lanes);
    for (std::size_t first = (task - 1) * batch; first < std::min(count, task * batch);
         first += lanes)
      contract_lanes(first, gathered, sums);
  });
  return columns;
}

}  // namespace brdf
