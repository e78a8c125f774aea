// The table of amplitude methods, each behind one virtual call per batch.
#pragma once

#include <complex>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/amplitude.h"
#include "brdf/bin_interpolation.h"
#include "brdf/power_spectra.h"

namespace evaluation {

/// A plan of any method.
class Amplitude {
 public:
  virtual ~Amplitude() = default;
  virtual void evaluate(std::span<const brdf::Query> queries,
                        std::span<std::complex<double>> amplitudes) const = 0;
  virtual brdf::PlanReport report() const = 0;
};

/// What a method may be told beside the tolerance.
enum class Knob {
  terms,          ///< of its series
  window_radius,  ///< neighbouring bins kept
  interpolation,  ///< between the bins
  power_spectra,  ///< transforms of the powers of the height, kept from before
};

/// What a query costs once there is a plan.
enum class QueryCost {
  some_terms,   ///< of a series: all queries of a request are timed
  every_pixel,  ///< a phasor for each: a sample is timed and stands for all
};

/// The knobs of all methods; a method takes those it knows.
struct MethodSettings {
  std::optional<int> terms;
  std::optional<double> radius_sigma_f;
  std::optional<brdf::BinInterpolation> interpolation;
  std::shared_ptr<const brdf::PowerSpectra> power_spectra;
  int threads = 1;  ///< that make a plan; the plan is the same, to the last bit, for any number
};

/// One row of the table.
struct Method {
  std::string_view name;
  std::vector<brdf::SurfaceModel> models;  ///< supported, the default first
  std::vector<Knob> knobs;                 ///< that it takes
  QueryCost query_cost;
  std::function<std::size_t(const brdf::Surface&, const brdf::QueryBounds&, const MethodSettings&)>
      bytes;
  /// What a plan will consist of, for people and sidecars; nothing is computed.
  std::function<nlohmann::ordered_json(const brdf::Surface&, const brdf::QueryBounds&,
                                       const MethodSettings&)>
      explain;
  std::function<std::unique_ptr<Amplitude>(const brdf::Surface&, const brdf::QueryBounds&,
                                           const MethodSettings&)>
      plan;

  bool takes(Knob knob) const;
};

std::span<const Method> methods();

/// Throws Errc::invalid_argument with the names there are.
const Method& method_named(std::string_view name);

/// The names of the methods that take it, separated by commas.
std::string methods_with(Knob knob);

std::string_view name_of(brdf::SurfaceModel model);
std::string_view name_of(brdf::BinInterpolation interpolation);

/// The model asked for, or the method's default. Throws Errc::invalid_argument naming a method that
/// has the model where this one has not.
brdf::SurfaceModel surface_model(const Method& method, std::optional<brdf::SurfaceModel> wanted);

}  // namespace evaluation
