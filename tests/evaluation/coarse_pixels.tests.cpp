// Frequencies beyond those that the pixels resolve: the table holds one period and is read round
// and round.
#include <catch2/catch.hpp>
#include <complex>
#include <random>
#include <vector>

#include "brdf/chebyshev_series.h"
#include "brdf/direct_sum.h"
#include "evaluation/kernels/phase_sum.h"
#include "evaluation/kernels/series_kernels.h"
#include "tests/support/amplitudes.h"

using namespace brdf;

namespace {

constexpr unsigned seed = 31;

HeightField rough(Eigen::Index rows, Eigen::Index cols, double pixel_um) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 0.3);
  return HeightField(HeightArray::NullaryExpr(rows, cols, [&] { return uniform(random); }),
                     Length::um(pixel_um), Length::um(0.9 * pixel_um));
}

std::vector<Query> queries(bool in_plane, std::size_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Query> result;
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(
        {31 * uniform(random), in_plane ? 0.3 : 31 * uniform(random), -18 + 14 * uniform(random)});
  return result;
}

}  // namespace

TEST_CASE("frequencies over many periods of coarse pixels keep the tolerance",
          "[chebyshev_series][oracle]") {
  const bool in_plane = GENERATE(true, false);
  const auto model =
      GENERATE(SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated);
  const auto origin = GENERATE(Origin::patch_centre, Origin::patch_corner);
  // Centres on a pixel and between two, along both axes.
  const auto [rows, cols] = GENERATE(std::pair<Eigen::Index, Eigen::Index>{24, 31},
                                     std::pair<Eigen::Index, Eigen::Index>{31, 24});
  const double pixel_um = GENERATE(0.25, 0.9);  // 2.5 and 9 periods
  CAPTURE(in_plane, static_cast<int>(model), static_cast<int>(origin), rows, pixel_um, seed);
  const HeightField field = rough(rows, cols, pixel_um);
  const Surface surface{&field, GaussianWindow(Length::um(6 * pixel_um)), model, origin, {3, 2}};
  const std::vector<Query> some = queries(in_plane, 60);
  const Amplitudes reference = amplitudes_of(DirectSum{}.plan(surface, many(some, 1)), some);
  for (const double tolerance : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
    CAPTURE(tolerance);
    const auto portable = ChebyshevSeries{}.plan(surface, many(some, tolerance));
    const auto vectorised =
        ChebyshevSeries(evaluation::vectorised_kernels()).plan(surface, many(some, tolerance));
    for (const SeriesPlanParts::Axis& axis : portable.explain().axes)
      if (axis.fft_length > 0)
        CHECK(axis.stored < axis.fft_length + static_cast<std::size_t>(axis.width));
    CHECK(largest_difference(amplitudes_of(portable, some), reference) <= tolerance);
    CHECK(largest_difference(amplitudes_of(vectorised, some), reference) <= tolerance);
    CHECK(largest_difference(amplitudes_of(vectorised, some), amplitudes_of(portable, some)) <=
          1e-13);
  }
}

TEST_CASE("sorted queries of coarse pixels are those of any batch",
          "[chebyshev_series][invariant]") {
  const HeightField field = rough(24, 31, 0.4);
  const Surface surface{&field, GaussianWindow(Length::um(2.4)), SurfaceModel::isolated};
  const std::vector<Query> some = queries(false, 9001);  // above the size that is sorted
  const auto plan =
      ChebyshevSeries(evaluation::vectorised_kernels()).plan(surface, many(some, 1e-6));
  const Amplitudes whole = amplitudes_of(plan, some);
  for (std::size_t first = 0; first < 9000; first += 1000)
    CHECK(amplitudes_of(plan, std::span(some).subspan(first, 1000)) ==
          Amplitudes(whole.begin() + static_cast<long>(first),
                     whole.begin() + static_cast<long>(first + 1000)));
}

TEST_CASE("small requests go to the vectorised direct sum with the vectorised series",
          "[chebyshev_series][crossover]") {
  const HeightField field = rough(48, 56, 0.1);
  const Surface surface{&field, GaussianWindow(Length::um(1.2)), SurfaceModel::isolated};
  const std::vector<Query> some = queries(false, 2);
  const QueryBounds bounds = bounds_of(some, 1e-6);
  const auto plan = ChebyshevSeries(evaluation::vectorised_kernels()).plan(surface, bounds);
  REQUIRE(plan.explain().path == SeriesPath::direct_sum);
  CHECK(
      amplitudes_of(plan, some) ==
      amplitudes_of(DirectSum(evaluation::vectorised_phase_kernels()).plan(surface, bounds), some));
}
