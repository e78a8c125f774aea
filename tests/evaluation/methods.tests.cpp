#include "evaluation/methods.h"

#include <catch2/catch.hpp>

#include "brdf/error.h"
#include "brdf/pq_series.h"
#include "tests/support/amplitudes.h"
#include "tests/support/surfaces.h"

using brdf::SurfaceModel;
using Catch::Matchers::Contains;

TEST_CASE("each method defaults to the first surface model it supports", "[invariant]") {
  CHECK(surface_model(evaluation::method_named("direct"), {}) == SurfaceModel::isolated);
  CHECK(surface_model(evaluation::method_named("taylor"), {}) == SurfaceModel::periodic);
  CHECK(surface_model(evaluation::method_named("direct"), SurfaceModel::periodic) ==
        SurfaceModel::periodic);
}

TEST_CASE("a model that a method has not is refused with one that has it", "[invariant]") {
  CHECK_THROWS_WITH(surface_model(evaluation::method_named("taylor"), SurfaceModel::isolated),
                    Contains("direct"));
  CHECK_THROWS_WITH(evaluation::method_named("fast"), Contains("direct") && Contains("taylor"));
}

TEST_CASE("each method takes its own knobs", "[invariant]") {
  using evaluation::Knob;
  CHECK(evaluation::methods_with(Knob::terms) == "taylor, pq");
  CHECK(evaluation::methods_with(Knob::window_radius) == "taylor");
  CHECK(evaluation::methods_with(Knob::interpolation) == "pq");
  CHECK(evaluation::methods_with(Knob::power_spectra) == "taylor, pq");
  CHECK(evaluation::method_named("pq").takes(Knob::terms));
  CHECK(!evaluation::method_named("direct").takes(Knob::terms));
  CHECK(surface_model(evaluation::method_named("pq"), {}) == SurfaceModel::replicated);
}

TEST_CASE("the settings of the table reach the PQ method", "[invariant]") {
  const brdf::HeightField field =
      sampled(4, 9, 0.1, 0.1, [](double x, double y) { return 0.1 * std::cos(5 * x + y); });
  const brdf::Surface surface{&field,
                              brdf::GaussianWindow(brdf::Length::um(1)),
                              SurfaceModel::replicated,
                              brdf::Origin::patch_centre,
                              {3, 2}};
  const std::vector<brdf::Query> queries{{2, 1, -20}, {-5.5, 0.3, -25}};
  const brdf::QueryBounds bounds = brdf::bounds_of(queries, 1e-9);
  const auto found = [&](const evaluation::MethodSettings& settings) {
    const auto plan = evaluation::method_named("pq").plan(surface, bounds, settings);
    Amplitudes a(queries.size());
    plan->evaluate(queries, a);
    return a;
  };
  CHECK(found({}) == amplitudes(brdf::PqSeries{}, surface, queries, 1e-9));
  evaluation::MethodSettings settings;
  settings.terms = 12;
  settings.interpolation = brdf::BinInterpolation::linear;
  const brdf::PqSeries linear({.terms = 12, .interpolation = brdf::BinInterpolation::linear});
  CHECK(found(settings) == amplitudes(linear, surface, queries, 1e-9));
  settings.power_spectra =
      std::make_shared<brdf::StoredPowerSpectra>(brdf::stored_power_spectra(field, 5));
  CHECK_THROWS_WITH(found(settings), Contains("5 terms") && Contains("12"));
}
