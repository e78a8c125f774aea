#include <memory>

#include "brdf/chebyshev_series.h"
#include "evaluation/kernels/series_kernels.h"
#include "evaluation/stability/exact_amplitude.h"
#include "evaluation/stability/groups.h"
#include "evaluation/stability/method_tallies.h"

namespace evaluation::stability {
namespace {

constexpr const char* depths = "phase depth 1e-6 to 200 rad";

/// Frequencies in one plane of incidence, or anywhere; |c| up to depth_rad for heights of 1 um.
enum class Frequencies { in_plane, general };

std::vector<brdf::Query> queries_to(double depth_rad, Frequencies frequencies) {
  std::vector<brdf::Query> queries;
  for (const double part : {1.0, 0.97, 0.9})
    queries.push_back({9 * part - 7, frequencies == Frequencies::general ? 4 - 5 * part : 0.0,
                       -part * depth_rad});
  return queries;
}

/// The Chebyshev series with its tables in single precision, where the tolerance allows it.
class SinglePrecision final : public Amplitude {
 public:
  SinglePrecision(const brdf::Surface& surface, const brdf::QueryBounds& bounds)
      : plan_(brdf::ChebyshevSeries(vectorised_kernels(), settings()).plan(surface, bounds)) {}

  void evaluate(std::span<const brdf::Query> queries,
                std::span<std::complex<double>> amplitudes) const override {
    plan_.evaluate(queries, amplitudes);
  }
  brdf::PlanReport report() const override { return plan_.report(); }

 private:
  static brdf::SeriesSettings settings() {
    brdf::SeriesSettings settings;
    settings.small_requests = brdf::SmallRequests::by_series;
    settings.double_table_bytes = 0;
    return settings;
  }
  brdf::ChebyshevSeriesPlan plan_;
};

Method in_single_precision() {
  Method method = method_named("chebyshev");
  method.plan = [](const brdf::Surface& surface, const brdf::QueryBounds& bounds,
                   const MethodSettings&) -> std::unique_ptr<Amplitude> {
    return std::make_unique<SinglePrecision>(surface, bounds);
  };
  return method;
}

CheckRow depth_row(const Method& method, const char* subject, brdf::SurfaceModel model,
                   double tolerance, MayRefuse may_refuse) {
  CheckTally tally(
      subject, depths, "of the peak",
      "the tolerance asked for, " + brdf::text(tolerance) +
          (may_refuse == MayRefuse::never ? "" : ", or where refused the bound stated"));
  const brdf::HeightField field = relief(1);
  brdf::Surface surface = under_window(field);
  surface.model = model;
  for (const double depth_rad :
       {1e-6, 1e-3, 0.1, 1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 80.0, 100.0, 150.0, 200.0})
    for (const Frequencies frequencies : {Frequencies::in_plane, Frequencies::general}) {
      const AmplitudeCase one{
          "depth " + brdf::text(depth_rad) + " rad" +
              (frequencies == Frequencies::in_plane ? ", in plane" : ", general"),
          surface, queries_to(depth_rad, frequencies), tolerance};
      see_case(tally, method, one, exact_amplitudes(surface, one.queries), may_refuse);
    }
  return tally.row();
}

}  // namespace

std::vector<CheckRow> series_rows() {
  using brdf::SurfaceModel;
  return {depth_row(method_named("chebyshev"), "method chebyshev", SurfaceModel::isolated, 1e-12,
                    MayRefuse::never),
          depth_row(in_single_precision(), "chebyshev, tables in single precision",
                    SurfaceModel::isolated, 1e-4, MayRefuse::never),
          depth_row(method_named("taylor"), "method taylor", SurfaceModel::periodic, 1e-6,
                    MayRefuse::past_rounding),
          depth_row(method_named("pq"), "method pq", SurfaceModel::replicated, 1e-6,
                    MayRefuse::past_rounding)};
}

}  // namespace evaluation::stability
