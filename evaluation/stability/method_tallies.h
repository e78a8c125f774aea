// Amplitude methods held against the exact amplitudes, a tally each.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "evaluation/checks.h"
#include "evaluation/methods.h"

namespace evaluation::stability {

/// A request for amplitudes. The methods set the surface's model.
struct AmplitudeCase {
  std::string where;
  brdf::Surface surface;
  std::vector<brdf::Query> queries;
  double tolerance;
};

/// When a method may refuse a case.
enum class MayRefuse {
  never,
  past_rounding,  ///< where e^x times the unit roundoff exceeds the tolerance (Taylor series)
  always,
};

/// Sees one case by a method: its plan, the worst error over the queries against the tolerance, or
/// its refusal. exact: of the surface in its model.
void see_case(CheckTally& tally, const Method& method, const AmplitudeCase& one,
              const std::vector<std::complex<long double>>& exact, MayRefuse may_refuse);

/// One row per method: direct, auto and chebyshev on the isolated patch, taylor on the periodic, pq
/// on 2 x 3 replicas.
class MethodTallies {
 public:
  /// range, reason: of every row.
  MethodTallies(const std::string& range, const std::string& reason);

  void see(const AmplitudeCase& one);
  std::vector<CheckRow> rows() const;

 private:
  struct Entry {
    const Method* method;
    brdf::SurfaceModel model;
    MayRefuse may_refuse;
    CheckTally tally;
  };
  std::vector<Entry> entries_;
};

/// Heights of a 3 x 4 patch over a range, both ends taken, pixels 0.2 um.
brdf::HeightField relief(double peak_to_valley_um);
/// A patch of heights under a window of a third of its width; 2 x 3 copies where replicated.
brdf::Surface under_window(const brdf::HeightField& field);

}  // namespace evaluation::stability
