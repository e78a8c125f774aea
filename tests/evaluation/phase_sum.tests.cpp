#include "evaluation/kernels/phase_sum.h"

#include <hwy/highway.h>
#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <vector>

#include "brdf/direct_sum.h"
#include "tests/support/amplitudes.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::DirectSum;
using brdf::GaussianWindow;
using brdf::HeightField;
using brdf::Length;
using brdf::pi;
using brdf::Query;
using brdf::Surface;
using brdf::SurfaceModel;
using evaluation::vectorised_phase_kernels;

namespace {

/// Runs a check on each instruction set that this machine has, one after the other.
template <class Check>
void on_every_instruction_set(Check check) {
  for (std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0; rest &= rest - 1) {
    const std::int64_t target = std::int64_t{1}
                                << std::countr_zero(static_cast<std::uint64_t>(rest));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    CAPTURE(hwy::TargetName(target));
    check();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

/// Largest error of the sines and cosines of ascending phases, against extended precision.
double phasor_error(const std::vector<double>& phases_rad) {
  const std::size_t count = phases_rad.size();
  const std::vector<double> ones(count, 1.0);
  std::vector<double> re(count), im(count);
  vectorised_phase_kernels().add_phasors({phases_rad.data(), ones.data(), count}, 1.0, re.data(),
                                         im.data());
  WorstError worst;
  for (std::size_t j = 0; j < count; ++j) {
    const long double phase = phases_rad[j];
    worst.see(static_cast<double>(std::abs(re[j] - std::cos(phase))));
    worst.see(static_cast<double>(std::abs(im[j] - std::sin(phase))));
  }
  return worst.value();
}

Query random_query(Uniform& uniform) {
  return query(random_direction(uniform), random_direction(uniform), Length::nm(uniform(380, 780)));
}

}  // namespace

TEST_CASE("vectorised phasors are right to 2.5e-16 up to 1e5 rad and beyond",
          "[phase_sum][oracle][crossover]") {
  constexpr std::uint64_t seed = 301;
  CAPTURE(seed);
  // Both sides of every place where the reduction changes: odd multiples of pi/4, where the
  // quadrant turns, and multiples of pi/2, where one of the two vanishes.
  std::vector<double> turning;
  for (int eighth = -3000; eighth <= 3000; ++eighth)
    for (const double direction : {-1e9, 0.0, 1e9})
      turning.push_back(direction == 0 ? eighth * pi / 4
                                       : std::nextafter(eighth * pi / 4, direction));
  std::vector<double> random;
  Uniform uniform(seed);
  for (int i = 0; i < 100000; ++i) random.push_back(uniform(-1e5, 1e5));
  random.front() = -1e5;  // the ends decide which way is taken
  random.back() = 1e5;
  on_every_instruction_set([&] {
    CHECK(phasor_error(turning) <= 2.5e-16);
    CHECK(phasor_error(random) <= 2.5e-16);
    CHECK(phasor_error({-std::nextafter(1e5, 1e9), 0, 1, 1e5}) <= 2.5e-16);
    CHECK(phasor_error({-1e300, 1e22}) <= 2.5e-16);
  });
}

TEST_CASE("a vectorised row of any length is the portable row", "[phase_sum][oracle]") {
  constexpr std::uint64_t seed = 302;
  CAPTURE(seed);
  Uniform uniform(seed);
  on_every_instruction_set([&] {
    WorstError worst;
    for (std::size_t count = 0; count <= 70; ++count) {
      // Exactly as long as the row, so that a sanitizer sees a step beyond it.
      std::vector<double> heights_um(count), re(count), im(count);
      for (std::size_t j = 0; j < count; ++j) {
        heights_um[j] = uniform(3, 4);
        re[j] = uniform(-1, 1);
        im[j] = uniform(-1, 1);
      }
      for (const double c_per_um : {-16.0, 0.0, 3e3, 1e6}) {
        const brdf::PhaseRow row{heights_um.data(), re.data(), im.data(), count, 3.5, 0.5,
                                 c_per_um};
        worst.see(std::abs(vectorised_phase_kernels().row_sum(row) - brdf::portable_row_sum(row)));
      }
    }
    CHECK(worst.value() <= 3e-14);  // 70 terms of up to 1.4, each and their sum rounded
  });
}

TEST_CASE("the vectorised direct sum is the portable one", "[phase_sum][oracle]") {
  constexpr std::uint64_t seed = 303;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField low = random_heights(uniform, {21, 37, 0.11, 0.17}, -0.3, 0.3);
  const HeightField high = random_heights(uniform, {64, 64, 0.25, 0.25}, 40, 43);
  std::vector<Query> queries;
  for (int i = 0; i < 20; ++i) queries.push_back(random_query(uniform));
  on_every_instruction_set([&] {
    for (const HeightField* field : {&low, &high})
      for (const SurfaceModel model :
           {SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated}) {
        const Surface surface{
            field, GaussianWindow(Length::um(1.5)), model, brdf::Origin::patch_centre, {3, 2}};
        const Amplitudes portable = amplitudes(DirectSum{}, surface, queries);
        const Amplitudes vectors =
            amplitudes(DirectSum(vectorised_phase_kernels()), surface, queries);
        WorstError worst;
        for (std::size_t i = 0; i < queries.size(); ++i)
          worst.see(std::abs(vectors[i] - portable[i]));
        CHECK(worst.value() <= 1e-13);
      }
  });
}

TEST_CASE("vectorised direct sums do not depend on the queries beside them",
          "[phase_sum][invariant]") {
  constexpr std::uint64_t seed = 304;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, {13, 29, 0.2, 0.1}, 0, 1);
  const Surface surface{&field, GaussianWindow(Length::um(1)), SurfaceModel::periodic};
  std::vector<Query> queries;
  for (int i = 0; i < 30; ++i) queries.push_back(random_query(uniform));
  const DirectSum method(vectorised_phase_kernels());
  const Amplitudes together = amplitudes(method, surface, queries);
  for (std::size_t i = 0; i < queries.size(); ++i)
    REQUIRE(amplitude(method, surface, queries[i]) == together[i]);
}
