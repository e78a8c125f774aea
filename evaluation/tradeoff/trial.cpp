#include "evaluation/tradeoff/trial.h"

#include <cmath>

namespace evaluation {
namespace {

using brdf::BinInterpolation;
using brdf::SurfaceModel;

/// What is varied beside the knob in question: the tolerance that `sweep` has by default, and what
/// the sources settled on.
constexpr double usual_tolerance = 1e-6;
constexpr int sources_terms = 25;
constexpr double sources_radius_sigma_f = 4;

/// Rounding leaves little below; every decade above it is tried.
constexpr int most_digits = 12;
/// The plain series' own rounding ends it before.
constexpr int most_digits_of_series = 10;

/// Whether a wavelength lies on the steps from the first one, to the rounding of decimals.
bool on_step(double lambda_nm, double first_nm, double step_nm) {
  const double steps = (lambda_nm - first_nm) / step_nm;
  return std::abs(steps - std::round(steps)) <= 1e-6;
}

class TrialList {
 public:
  explicit TrialList(const TrialScope& scope)
      : scope_(scope), plain_{.method = {}, .model = scope.model, .replicas = scope.replicas} {}

  void add_all() {
    add("direct");
    for (int digits = 1; digits <= most_digits; ++digits) add_tolerance("chebyshev", digits);
    for (const int digits : {3, 6, 9, 12}) add_tolerance("auto", digits);
    for (const Trial& coarser : coarser_steps()) add("chebyshev", coarser);
    if (scope_.period) {
      Trial trial = plain_;
      trial.tolerance = usual_tolerance;
      trial.cells = Cells::orders;
      add("chebyshev", trial);
    }
    if (has("taylor")) add_taylor();
    if (has("pq")) add_pq();
  }

  std::vector<Trial> take() && { return std::move(trials_); }

 private:
  bool has(std::string_view method) const {
    const std::vector<SurfaceModel>& models = method_named(method).models;
    return std::find(models.begin(), models.end(), scope_.model) != models.end();
  }

  void add(std::string_view method, Trial trial) {
    trial.method = method;
    trials_.push_back(std::move(trial));
  }
  void add(std::string_view method) { add(method, plain_); }

  void add_tolerance(std::string_view method, int digits) {
    Trial trial = plain_;
    trial.tolerance = std::pow(10.0, -digits);
    add(method, trial);
  }

  std::vector<Trial> coarser_steps() const {
    std::vector<Trial> coarser;
    for (const double step_nm : {5.0, 10.0, 25.0, 100.0}) {
      SweepRequest request;
      request.lambda_nm = scope_.lambda_nm;
      const std::size_t kept = thinned(request, step_nm).lambda_nm.size();
      const bool reaches = scope_.lambda_nm.back() - scope_.lambda_nm.front() >= step_nm;
      if (!reaches || kept < 2 || kept == scope_.lambda_nm.size()) continue;
      Trial trial = plain_;
      trial.tolerance = usual_tolerance;
      trial.lambda_step_nm = step_nm;
      coarser.push_back(trial);
    }
    return coarser;
  }

  void add_taylor() {
    for (int digits = 1; digits <= most_digits_of_series; ++digits) add_tolerance("taylor", digits);
    Trial trial = plain_;
    trial.radius_sigma_f = sources_radius_sigma_f;
    for (const int terms : {10, 15, 20, 25, 30, 40}) {
      trial.terms = terms;
      const bool printed = terms == 20 || terms == 25 || terms == 30;
      trial.sources = printed ? std::to_string(terms) + " terms" : "";
      add("taylor", trial);
    }
    trial.terms = sources_terms;
    trial.sources = {};
    for (const double radius : {2.0, 3.0, 5.0, 6.0, 8.0}) {
      trial.radius_sigma_f = radius;
      add("taylor", trial);
    }
    trial.radius_sigma_f = scope_.one_neighbourhood_sigma_f;
    trial.sources = "3 x 3";
    add("taylor", trial);
    trial.radius_sigma_f = sources_radius_sigma_f;
    for (const Trial& coarser : coarser_steps())
      if (*coarser.lambda_step_nm == 5) {
        Trial sampled = trial;
        sampled.lambda_step_nm = coarser.lambda_step_nm;
        sampled.sources = "5 nm";
        add("taylor", sampled);
      }
    if (!scope_.period) return;
    trial.cells = Cells::orders;
    trial.sources = "Nmin/Nmax";
    add("taylor", trial);
  }

  void add_pq() {
    for (int digits = 1; digits <= most_digits_of_series; ++digits) add_tolerance("pq", digits);
    Trial trial = plain_;
    for (const int terms : {20, 25, 30}) {
      trial.terms = terms;
      add("pq", trial);
    }
    trial.terms = sources_terms;
    for (const BinInterpolation interpolation :
         {BinInterpolation::nearest, BinInterpolation::linear, BinInterpolation::sinc}) {
      trial.interpolation = interpolation;
      trial.sources = interpolation == BinInterpolation::nearest
                          ? ""
                          : "PQ " + std::string(name_of(interpolation));
      add("pq", trial);
    }
  }

  const TrialScope& scope_;
  Trial plain_;
  std::vector<Trial> trials_;
};

}  // namespace

MethodSettings Trial::settings(int threads) const {
  MethodSettings settings;
  settings.terms = terms;
  settings.radius_sigma_f = radius_sigma_f;
  settings.interpolation = interpolation;
  settings.threads = threads;
  return settings;
}

std::vector<Trial> trials(const TrialScope& scope) {
  TrialList list(scope);
  list.add_all();
  return std::move(list).take();
}

SweepRequest thinned(SweepRequest request, const std::optional<double>& lambda_step_nm) {
  if (!lambda_step_nm) return request;
  std::vector<double>& values = request.lambda_nm.values;
  const double first = values.front();
  std::erase_if(values,
                [&](double lambda_nm) { return !on_step(lambda_nm, first, *lambda_step_nm); });
  return request;
}

std::string_view name_of(Cells cells) {
  switch (cells) {
    case Cells::all:
      return "all";
    case Cells::orders:
      return "orders";
  }
  return "?";
}

}  // namespace evaluation
