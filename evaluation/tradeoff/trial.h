// What a trade-off tries: methods and the settings of their knobs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brdf/surface.h"
#include "evaluation/methods.h"
#include "evaluation/sweep_request.h"

namespace evaluation {

/// Which cells of a request are evaluated.
enum class Cells {
  all,
  orders,  ///< the bands around the orders of a known period (Nmin/Nmax)
};

/// A method with its knobs, as `sweep` takes them.
struct Trial {
  std::string method;
  brdf::SurfaceModel model = brdf::SurfaceModel::isolated;
  brdf::Replicas replicas = {};
  std::optional<int> terms = {};
  std::optional<double> radius_sigma_f = {};
  std::optional<brdf::BinInterpolation> interpolation = {};
  std::optional<double> tolerance = {};
  std::optional<double> lambda_step_nm = {};  ///< of a request that is sampled more coarsely
  Cells cells = Cells::all;
  std::string sources = {};  ///< which setting of the sources it is, in a word or two; or empty

  MethodSettings settings(int threads) const;
  bool operator==(const Trial&) const = default;
};

/// What the trials of a surface depend on.
struct TrialScope {
  brdf::SurfaceModel model;
  brdf::Replicas replicas;
  /// Radius [sigma_f] that keeps the three bins around a frequency, the sources' one-neighbourhood:
  /// one and a half bins of the longer side.
  double one_neighbourhood_sigma_f;
  Axis lambda_nm;
  std::optional<brdf::Length> period;  ///< with it the orders alone are tried, too
};

/// Every method that has the model, over its knobs:
/// - chebyshev at tolerances of 1e-1 to 1e-12, auto at four of them, and the direct sum;
/// - taylor by tolerance, by terms at the sources' radius of 4 sigma_f, and by radius at 25 terms;
/// - pq by tolerance, by terms, by interpolation;
/// - wavelengths every 5, 10, 25 and 100 nm, where the request has finer steps;
/// - with a period the bands around its orders;
/// - the sources' own settings among these, named: 20, 25 and 30 terms, radius 4, 3 x 3 bins,
///   linear and sinc interpolation, 5 nm, Nmin/Nmax.
std::vector<Trial> trials(const TrialScope& scope);

/// Each row of the request that lies on the coarser steps; all of them without a step.
SweepRequest thinned(SweepRequest request, const std::optional<double>& lambda_step_nm);

std::string_view name_of(Cells cells);

}  // namespace evaluation
