#include "evaluation/methods.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "brdf/chebyshev_series.h"
#include "brdf/direct_sum.h"
#include "brdf/pq_series.h"
#include "brdf/taylor_series.h"
#include "evaluation/kernels/phase_sum.h"
#include "evaluation/kernels/series_kernels.h"
#include "evaluation/parallel.h"

namespace evaluation {
namespace {

using brdf::SmallRequests;
using brdf::SurfaceModel;

constexpr std::array models{SurfaceModel::isolated, SurfaceModel::periodic,
                            SurfaceModel::replicated};

template <brdf::AmplitudePlan Plan>
class PlanHolder final : public Amplitude {
 public:
  explicit PlanHolder(Plan plan) : plan_(std::move(plan)) {}
  void evaluate(std::span<const brdf::Query> queries,
                std::span<std::complex<double>> amplitudes) const override {
    plan_.evaluate(queries, amplitudes);
  }
  brdf::PlanReport report() const override { return plan_.report(); }

 private:
  Plan plan_;
};

using Json = nlohmann::ordered_json;

std::string_view name_of(brdf::SeriesPath path) {
  switch (path) {
    case brdf::SeriesPath::direct_sum:
      return "direct sum";
    case brdf::SeriesPath::in_plane:
      return "in plane, 1-D transforms";
    case brdf::SeriesPath::general:
      return "general, 2-D transforms";
  }
  return "?";
}

Json explained(const brdf::ChebyshevSeries& method, const brdf::Surface& surface,
               const brdf::QueryBounds& bounds) {
  const brdf::SeriesPlanParts parts = method.explain(surface, bounds);
  Json json{{"path", name_of(parts.path)}};
  if (parts.path != brdf::SeriesPath::direct_sum) {
    json["terms"] = parts.terms;
    json["storage"] =
        parts.storage == brdf::TableStorage::single_precision ? "single precision" : "double";
    json["grid"] = Json::array();
    for (const auto& axis : parts.axes)
      if (axis.fft_length > 0)
        json["grid"].push_back({{"kernel_width", axis.width},
                                {"oversampling", axis.oversampling},
                                {"transform_length", axis.fft_length},
                                {"points_kept", axis.stored}});
  }
  json["error"] = {{"series", parts.series_error},
                   {"kernel", parts.kernel_error},
                   {"storage", parts.storage_error},
                   {"rounding", parts.rounding_error}};
  json["expected_seconds_one_thread"] =
      parts.plan_s + static_cast<double>(bounds.count) * parts.query_s;
  return json;
}

Json explained(const brdf::DirectSum&, const brdf::Surface& surface,
               const brdf::QueryBounds& bounds) {
  // Nanoseconds for a sine and cosine, vectorised.
  constexpr double phasor_s = 1e-9;
  return {{"path", "direct sum"},
          {"expected_seconds_one_thread",
           phasor_s * static_cast<double>(bounds.count) *
               static_cast<double>(surface.heights->heights_um().size())}};
}

Json explained(const brdf::TaylorSeries& method, const brdf::Surface& surface,
               const brdf::QueryBounds& bounds) {
  return {{"path", "2-D transforms of the powers of the height"},
          {"terms", method.terms(surface, bounds)},
          {"window_radius_sigma_f", method.radius(surface, bounds)}};
}

Json explained(const brdf::PqSeries& method, const brdf::Surface& surface,
               const brdf::QueryBounds& bounds) {
  return {{"path", "2-D transforms of the powers of one tile's height, times PQ factors"},
          {"terms", method.terms(surface, bounds)},
          {"interpolation", evaluation::name_of(method.interpolation())}};
}

brdf::ChebyshevSeries chebyshev(const MethodSettings& settings, SmallRequests small_requests) {
  brdf::SeriesSettings series;
  series.small_requests = small_requests;
  series.executor = [threads = settings.threads](std::size_t count,
                                                 const std::function<void(std::size_t)>& task) {
    parallel_for(count, threads, task);
  };
  return brdf::ChebyshevSeries(vectorised_kernels(), series);
}

/// make: MethodSettings -> an AmplitudeMethod.
template <class Make>
Method row(std::string_view name, std::vector<Knob> knobs, QueryCost query_cost, Make make) {
  using MethodType = decltype(make(MethodSettings{}));
  std::vector<SurfaceModel> supported;
  std::copy_if(models.begin(), models.end(), std::back_inserter(supported),
               [](SurfaceModel model) { return MethodType::supports(model); });
  return {name,
          supported,
          std::move(knobs),
          query_cost,
          [make](const brdf::Surface& surface, const brdf::QueryBounds& bounds,
                 const MethodSettings& settings) { return make(settings).bytes(surface, bounds); },
          [make](const brdf::Surface& surface, const brdf::QueryBounds& bounds,
                 const MethodSettings& settings) {
            const auto method = make(settings);
            nlohmann::ordered_json parts = explained(method, surface, bounds);
            parts["bytes"] = method.bytes(surface, bounds);
            parts["queries"] = bounds.count;
            return parts;
          },
          [make](const brdf::Surface& surface, const brdf::QueryBounds& bounds,
                 const MethodSettings& settings) -> std::unique_ptr<Amplitude> {
            auto plan = make(settings).plan(surface, bounds);
            return std::make_unique<PlanHolder<decltype(plan)>>(std::move(plan));
          }};
}

template <class Chosen>
std::string names_of(Chosen chosen) {
  std::string names;
  for (const Method& method : methods())
    if (chosen(method)) names.append(names.empty() ? "" : ", ").append(method.name);
  return names;
}

}  // namespace

bool Method::takes(Knob knob) const {
  return std::find(knobs.begin(), knobs.end(), knob) != knobs.end();
}

std::span<const Method> methods() {
  static const std::array table{
      row("direct", {}, QueryCost::every_pixel,
          [](const MethodSettings&) { return brdf::DirectSum(vectorised_phase_kernels()); }),
      row("auto", {}, QueryCost::some_terms,
          [](const MethodSettings& s) { return chebyshev(s, SmallRequests::by_direct_sum); }),
      row("chebyshev", {}, QueryCost::some_terms,
          [](const MethodSettings& s) { return chebyshev(s, SmallRequests::by_series); }),
      row("taylor", {Knob::terms, Knob::window_radius, Knob::power_spectra}, QueryCost::some_terms,
          [](const MethodSettings& s) {
            return brdf::TaylorSeries({s.terms, s.radius_sigma_f, s.power_spectra});
          }),
      row("pq", {Knob::terms, Knob::interpolation, Knob::power_spectra}, QueryCost::some_terms,
          [](const MethodSettings& s) {
            return brdf::PqSeries({s.terms, s.interpolation.value_or(brdf::BinInterpolation::exact),
                                   s.power_spectra});
          }),
  };
  return table;
}

const Method& method_named(std::string_view name) {
  for (const Method& method : methods())
    if (method.name == name) return method;
  throw brdf::Error(brdf::Errc::invalid_argument,
                    "method \"" + std::string(name) +
                        "\" is none of: " + names_of([](const Method&) { return true; }));
}

std::string methods_with(Knob knob) {
  return names_of([knob](const Method& method) { return method.takes(knob); });
}

std::string_view name_of(SurfaceModel model) {
  switch (model) {
    case SurfaceModel::isolated:
      return "isolated";
    case SurfaceModel::periodic:
      return "periodic";
    case SurfaceModel::replicated:
      return "replicated";
  }
  return "?";
}

std::string_view name_of(brdf::BinInterpolation interpolation) {
  switch (interpolation) {
    case brdf::BinInterpolation::nearest:
      return "nearest";
    case brdf::BinInterpolation::linear:
      return "linear";
    case brdf::BinInterpolation::sinc:
      return "sinc";
    case brdf::BinInterpolation::exact:
      return "exact";
  }
  return "?";
}

SurfaceModel surface_model(const Method& method, std::optional<SurfaceModel> wanted) {
  const auto has = [](const Method& candidate, SurfaceModel model) {
    return std::find(candidate.models.begin(), candidate.models.end(), model) !=
           candidate.models.end();
  };
  if (!wanted) return method.models.front();
  if (has(method, *wanted)) return *wanted;
  const std::string others =
      names_of([&](const Method& candidate) { return has(candidate, *wanted); });
  throw brdf::Error(brdf::Errc::invalid_argument, "method " + std::string(method.name) +
                                                      " has no " + std::string(name_of(*wanted)) +
                                                      " surface; use --method " + others);
}

}  // namespace evaluation
