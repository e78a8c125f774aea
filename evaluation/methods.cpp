#include "evaluation/methods.h"

#include <algorithm>
#include <array>

#include "brdf/direct_sum.h"
#include "brdf/taylor_series.h"

namespace evaluation {
namespace {

using brdf::SurfaceModel;

constexpr std::array models{SurfaceModel::isolated, SurfaceModel::periodic};

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

/// make: MethodSettings -> an AmplitudeMethod.
template <class Make>
Method row(std::string_view name, bool is_series, Make make) {
  using MethodType = decltype(make(MethodSettings{}));
  std::vector<SurfaceModel> supported;
  std::copy_if(models.begin(), models.end(), std::back_inserter(supported),
               [](SurfaceModel model) { return MethodType::supports(model); });
  return {name, supported, is_series,
          [make](const brdf::Surface& surface, const brdf::QueryBounds& bounds,
                 const MethodSettings& settings) { return make(settings).bytes(surface, bounds); },
          [make](const brdf::Surface& surface, const brdf::QueryBounds& bounds,
                 const MethodSettings& settings) -> std::unique_ptr<Amplitude> {
            auto plan = make(settings).plan(surface, bounds);
            return std::make_unique<PlanHolder<decltype(plan)>>(std::move(plan));
          }};
}

}  // namespace

std::span<const Method> methods() {
  static const std::array table{
      row("direct", false, [](const MethodSettings&) { return brdf::DirectSum{}; }),
      row("taylor", true,
          [](const MethodSettings& s) {
            return brdf::TaylorSeries({s.terms, s.radius_sigma_f});
          }),
  };
  return table;
}

const Method& method_named(std::string_view name) {
  std::string names;
  for (const Method& method : methods()) {
    if (method.name == name) return method;
    names.append(names.empty() ? "" : ", ").append(method.name);
  }
  throw brdf::Error(brdf::Errc::invalid_argument,
                    "method \"" + std::string(name) + "\" is none of: " + names);
}

std::string_view name_of(SurfaceModel model) {
  switch (model) {
    case SurfaceModel::isolated:
      return "isolated";
    case SurfaceModel::periodic:
      return "periodic";
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
  std::string others;
  for (const Method& candidate : methods())
    if (has(candidate, *wanted)) others.append(others.empty() ? "" : ", ").append(candidate.name);
  throw brdf::Error(brdf::Errc::invalid_argument, "method " + std::string(method.name) +
                                                      " has no " + std::string(name_of(*wanted)) +
                                                      " surface; use --method " + others);
}

}  // namespace evaluation
