// A response does not depend on the threads that made it.
#include <catch2/catch.hpp>
#include <cstring>

#include "evaluation/diffraction.h"
#include "evaluation/sweep.h"
#include "tests/support/generated_scene.h"
#include "tests/support/property.h"

TEST_CASE("property: a sweep has the same bits from any number of threads",
          "[property][invariant]") {
  check_property("threads", [] {
    const GeneratedScene scene = any_scene();
    const brdf::HeightField field = scene.field();
    const brdf::Surface surface{&field, brdf::GaussianWindow(brdf::Length::um(scene.sigma_um)),
                                brdf::SurfaceModel::isolated};
    const evaluation::SweepRequest request{brdf::Angle::deg(*number_between(0, 80)),
                                           brdf::Angle::deg(*number_between(0, 360)),
                                           brdf::Angle::deg(*number_between(0, 360)),
                                           {{400, 450, 500.5, 610, 700}, 0},
                                           {{-60, -20, 1, 33}, 0}};
    const auto plan =
        evaluation::method_named("direct").plan(surface, bounds_of(request, 1e-9), {});
    const evaluation::Diffraction reflectance(*plan, {});
    const auto one = sweep(request, reflectance, evaluation::RunLimits{1, {}});
    const int threads = *rc::gen::inRange(2, 9);
    const auto many = sweep(request, reflectance, evaluation::RunLimits{threads, {}});
    RC_ASSERT(one.values.size() == many.values.size());
    RC_ASSERT(std::memcmp(one.values.data(), many.values.data(),
                          sizeof(double) * static_cast<std::size_t>(one.values.size())) == 0);
  });
}
