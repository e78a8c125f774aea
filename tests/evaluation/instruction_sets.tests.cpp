// One response on every instruction set of the machine.
#include <hwy/highway.h>

#include <bit>
#include <catch2/catch.hpp>

#include "brdf/synthetic_surface.h"
#include "evaluation/diffraction.h"
#include "evaluation/sweep.h"
#include "tests/support/worst_error.h"

namespace {

using brdf::Angle;
using brdf::Length;

const evaluation::SweepRequest request{Angle::deg(75),
                                       Angle::deg(20),
                                       Angle::deg(20),
                                       {{400, 500, 610.5}, 1},
                                       {{-60, -50, -40, -1, 30}, 0}};

brdf::HeightArray response_of(const evaluation::Method& method) {
  const brdf::HeightField field =
      brdf::synthetic_grating({brdf::Profile::blazed, Length::nm(2500), Length::nm(300)}, 7, 50,
                              Length::nm(100), Length::nm(400));
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(2)), method.models.front()};
  const auto plan = method.plan(surface, bounds_of(request, 1e-9), {});
  return sweep(request, evaluation::Diffraction(*plan, {}), {}).values;
}

}  // namespace

TEST_CASE("every method gives the same response on every instruction set within 1e-12",
          "[invariant]") {
  for (const evaluation::Method& method : evaluation::methods()) {
    CAPTURE(method.name);
    const brdf::HeightArray chosen = response_of(method);
    WorstError worst;
    int sets = 0;
    for (std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0; rest &= rest - 1) {
      hwy::SetSupportedTargetsForTest(std::int64_t{1}
                                      << std::countr_zero(static_cast<std::uint64_t>(rest)));
      hwy::GetChosenTarget().Update(hwy::SupportedTargets());
      worst.see((response_of(method) - chosen).abs().maxCoeff());
      ++sets;
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    CAPTURE(sets);
    // Relative reflectance, 1 for a mirror: 1e-12 is what a user is promised.
    CHECK(worst.value() <= 1e-12);
  }
}
