// The kernel that a tolerance needs.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "brdf/chebyshev_fit.h"
#include "brdf/interpolation_kernel.h"
#include "brdf/units.h"

namespace brdf {

/// A kernel between the points of a grid, what it may be wrong by, and its transform.
struct ChosenKernel {
  InterpolationKernel kernel;
  double error_bound;
  double edge;                          ///< largest |omega| of a sample [rad per grid point]
  std::vector<double> transform_terms;  ///< of T_n(2 (omega / edge)^2 - 1)

  /// The kernel's transform at |omega| <= edge.
  double transform(double omega) const {
    return chebyshev_sum(transform_terms, 2 * (omega / edge) * (omega / edge) - 1);
  }
};

namespace detail {

/// What the polynomials of a kernel of that error may add to it.
inline double shortening_share(double tolerance, double error) {
  return std::clamp(tolerance - error, 0.0, tolerance / 4);
}

}  // namespace detail

/// Errors of a kernel are taken at this many even steps of omega from 0 to the edge.
inline constexpr int kernel_mesh = 24;

/// The narrowest exponential of semicircle that is good enough, its polynomials as short as is.
///
/// over_samples: the mean over the samples, or the largest, of what has these values at the mesh.
/// At most 17 taps: from there on the rest is rounding.
template <class OverSamples>
ChosenKernel choose_semicircle(double edge, double oversampling, double tolerance,
                               OverSamples over_samples) {
  struct Candidate {
    InterpolationKernel kernel;
    std::vector<double> transforms;
    double error;
  };
  std::vector<double> omegas;
  for (int m = 0; m <= kernel_mesh; ++m) omegas.push_back(edge * m / kernel_mesh);
  const auto candidate = [&](int width) {
    InterpolationKernel kernel = InterpolationKernel::semicircle(width, oversampling);
    std::vector<double> transforms = kernel.transform(omegas);
    const double error = over_samples(kernel.relative_errors(omegas, transforms));
    return Candidate{std::move(kernel), std::move(transforms), error};
  };
  constexpr int widest = 17;
  const double rate = pi * std::sqrt(1 - 1 / oversampling);
  int width = std::clamp(static_cast<int>(-std::log(tolerance) / rate) + 1, 2, widest);
  Candidate best = candidate(width);
  if (best.error <= tolerance) {
    while (width > 2) {
      Candidate narrower = candidate(--width);
      if (!(narrower.error <= tolerance)) break;
      best = std::move(narrower);
    }
  } else {
    while (!(best.error <= tolerance) && width < widest) best = candidate(++width);
  }
  // Entire in omega^2: degree 24 is exact to rounding (fourier_axis.tests.cpp).
  const ChebyshevFit fit(24);
  std::vector<double> nodes;
  for (std::size_t k = 0; k < fit.count(); ++k)
    nodes.push_back(edge * std::sqrt((1 + fit.node(k)) / 2));
  const std::vector<double> transform_terms = fit.chebyshev(best.kernel.transform(nodes));
  for (double& transform : best.transforms) transform = 1 / transform;
  const double per_change = over_samples(best.transforms);
  const InterpolationKernel kernel =
      best.kernel.shortened(4, detail::shortening_share(tolerance, best.error) / per_change);
  return {kernel, best.error + kernel.shortening_error() * per_change, edge, transform_terms};
}

}  // namespace brdf
