#include "evaluation/stability/method_tallies.h"

#include <algorithm>
#include <complex>

#include "brdf/taylor_bounds.h"
#include "evaluation/stability/exact_amplitude.h"
#include "evaluation/worst_error.h"

namespace evaluation::stability {
namespace {

using brdf::SurfaceModel;
using Refusal = CheckTally::Refusal;

/// The pixels of a small patch add up their roundings.
constexpr double summed = 100;

Refusal refusal(const AmplitudeCase& one, MayRefuse may_refuse) {
  if (may_refuse == MayRefuse::never) return Refusal::fault;
  if (may_refuse == MayRefuse::always) return Refusal::as_it_should_be;
  const double x = brdf::bounds_of(one.queries, one.tolerance).max_abs_c_per_um() *
                   one.surface.heights->half_range_um();
  return summed * brdf::taylor_rounding_bound(x) > one.tolerance ? Refusal::as_it_should_be
                                                                 : Refusal::fault;
}

/// Largest error; NaN where one is.
double worst_error(const std::vector<std::complex<double>>& amplitudes,
                   const std::vector<std::complex<long double>>& exact) {
  WorstError worst;
  for (std::size_t i = 0; i < exact.size(); ++i)
    worst.see(static_cast<double>(std::abs(std::complex<long double>(amplitudes[i]) - exact[i])));
  return worst.value();
}

}  // namespace

void see_case(CheckTally& tally, const Method& method, const AmplitudeCase& one,
              const std::vector<std::complex<long double>>& exact, MayRefuse may_refuse) {
  try {
    const auto plan =
        method.plan(one.surface, brdf::bounds_of(one.queries, one.tolerance), MethodSettings{});
    std::vector<std::complex<double>> amplitudes(one.queries.size());
    plan->evaluate(one.queries, amplitudes);
    const double bound = plan->report().error_bound;
    if (!(bound <= one.tolerance))
      tally.refused(one.where, "states an error of up to " + brdf::text(bound),
                    refusal(one, may_refuse));
    tally.see(worst_error(amplitudes, exact), std::max(one.tolerance, bound), one.where);
  } catch (const brdf::Error& error) {
    tally.refused(one.where, error.what(), refusal(one, may_refuse));
  }
}

MethodTallies::MethodTallies(const std::string& range, const std::string& reason) {
  const auto add = [&](const char* name, SurfaceModel model, MayRefuse may_refuse) {
    entries_.push_back({&method_named(name), model, may_refuse,
                        CheckTally(std::string("method ") + name, range, "of the peak", reason)});
  };
  add("direct", SurfaceModel::isolated, MayRefuse::never);
  add("auto", SurfaceModel::isolated, MayRefuse::never);
  add("chebyshev", SurfaceModel::isolated, MayRefuse::never);
  add("taylor", SurfaceModel::periodic, MayRefuse::past_rounding);
  add("pq", SurfaceModel::replicated, MayRefuse::past_rounding);
}

void MethodTallies::see(const AmplitudeCase& one) {
  AmplitudeCase in_model = one;
  std::vector<std::complex<long double>> exact;
  for (Entry& entry : entries_) {
    if (exact.empty() || entry.model != in_model.surface.model) {
      in_model.surface.model = entry.model;
      exact = exact_amplitudes(in_model.surface, one.queries);
    }
    see_case(entry.tally, *entry.method, in_model, exact, entry.may_refuse);
  }
}

std::vector<CheckRow> MethodTallies::rows() const {
  std::vector<CheckRow> rows;
  for (const Entry& entry : entries_) rows.push_back(entry.tally.row());
  return rows;
}

brdf::HeightField relief(double peak_to_valley_um) {
  brdf::HeightArray unit(3, 4);
  unit << 0, 0.31, 0.77, 1, 0.62, 0.05, 0.93, 0.41, 0.18, 1, 0.54, 0;
  const brdf::Length pixel = brdf::Length::um(0.2);
  return {brdf::HeightArray(peak_to_valley_um * unit), pixel, pixel};
}

brdf::Surface under_window(const brdf::HeightField& field) {
  return {&field, brdf::GaussianWindow(brdf::Length::um(field.width_um() / 3)),
          SurfaceModel::isolated, brdf::Origin::patch_centre, brdf::Replicas{2, 3}};
}

}  // namespace evaluation::stability
