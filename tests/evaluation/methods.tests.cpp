#include "evaluation/methods.h"

#include <catch2/catch.hpp>

#include "brdf/error.h"

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
