// The vectorised loops of the Chebyshev series against the portable ones.
#include "evaluation/kernels/series_kernels.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "brdf/chebyshev_series.h"
#include "brdf/direct_sum.h"
#include "tests/support/amplitudes.h"

using namespace brdf;

namespace {

constexpr unsigned seed = 7;

HeightField rough(Eigen::Index rows, Eigen::Index cols, double height_um) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, height_um);
  return HeightField(HeightArray::NullaryExpr(rows, cols, [&] { return uniform(random); }),
                     Length::um(0.1), Length::um(0.12));
}

std::vector<Query> queries(bool in_plane, std::size_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Query> result;
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(
        {30 * uniform(random), in_plane ? 0.3 : 25 * uniform(random), -18 + 14 * uniform(random)});
  result.push_back({0, in_plane ? 0.3 : 0, -10});  // on a grid point
  return result;
}

}  // namespace

TEST_CASE("vectorised amplitudes equal the portable ones to 1e-13", "[series_kernels][oracle]") {
  const bool in_plane = GENERATE(true, false);
  const auto model =
      GENERATE(SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated);
  const double height_um = GENERATE(0.0, 0.15, 3.0);
  const double tolerance = GENERATE(1e-1, 1e-6, 1e-12);
  const std::size_t double_table_bytes = GENERATE(0u, 1u << 30);
  CAPTURE(in_plane, static_cast<int>(model), height_um, tolerance, double_table_bytes, seed);
  const HeightField field = rough(33, 45, height_um);
  const Surface surface{
      &field, GaussianWindow(Length::um(1.2)), model, Origin::patch_corner, {2, 3}};
  const std::vector<Query> some = queries(in_plane, 203);
  const SeriesSettings settings{.double_table_bytes = double_table_bytes};
  const ChebyshevSeriesPlan portable =
      ChebyshevSeries(portable_kernels, settings).plan(surface, many(some, tolerance));
  const ChebyshevSeriesPlan vectorised = ChebyshevSeries(evaluation::vectorised_kernels(), settings)
                                             .plan(surface, many(some, tolerance));
  const double difference =
      largest_difference(amplitudes_of(portable, some), amplitudes_of(vectorised, some));
  CAPTURE(evaluation::instruction_set(), difference);
  // Tables in single precision are filled by other loops and may round the last bit differently:
  // 2^-24 of an entry, up to three entries' worth.
  const bool single = portable.explain().storage == TableStorage::single_precision;
  CHECK(difference <= (single ? 2e-7 : 1e-13));
}

TEST_CASE("vectorised gather of one and the same single-precision table equals the portable one",
          "[series_kernels][oracle]") {
  const HeightField field = rough(33, 45, 0.4);
  const Surface surface{&field, GaussianWindow(Length::um(1.2)), SurfaceModel::isolated};
  const std::vector<Query> some = queries(false, 203);
  const ChebyshevDesign design(surface, many(some, 1e-6), {.double_table_bytes = 0});
  REQUIRE(design.parts().storage == TableStorage::single_precision);
  const ChebyshevTable<float> table(design, portable_kernels);
  Amplitudes portable(some.size()), vectorised(some.size());
  portable_kernels.gather_float(table.view(), some.data(), some.size(), portable.data());
  evaluation::vectorised_kernels().gather_float(table.view(), some.data(), some.size(),
                                                vectorised.data());
  CHECK(largest_difference(portable, vectorised) <= 1e-13);
}

TEST_CASE("vectorised amplitudes do not depend on the batch", "[series_kernels][invariant]") {
  const bool in_plane = GENERATE(true, false);
  const HeightField field = rough(33, 45, 0.4);
  const Surface surface{&field, GaussianWindow(Length::um(1.2)), SurfaceModel::isolated};
  const std::vector<Query> some = queries(in_plane, 9001);  // above the size that is sorted
  const ChebyshevSeriesPlan plan =
      ChebyshevSeries(evaluation::vectorised_kernels()).plan(surface, many(some, 1e-6));
  const Amplitudes whole = amplitudes_of(plan, some);
  for (std::size_t first = 0; first < 300; first += 7) {
    const std::size_t count = 1 + first % 19;
    CHECK(amplitudes_of(plan, std::span(some).subspan(first, count)) ==
          Amplitudes(whole.begin() + static_cast<long>(first),
                     whole.begin() + static_cast<long>(first + count)));
  }
}

TEST_CASE("vectorised amplitudes keep the tolerance", "[series_kernels][oracle]") {
  const bool in_plane = GENERATE(true, false);
  const HeightField field = rough(40, 48, 0.8);
  const Surface surface{&field, GaussianWindow(Length::um(1.2)), SurfaceModel::isolated};
  const std::vector<Query> some = queries(in_plane, 40);
  Amplitudes reference(some.size());
  DirectSum{}.plan(surface, many(some, 1)).evaluate(some, reference);
  for (const double tolerance : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12})
    CHECK(largest_difference(amplitudes_of(ChebyshevSeries(evaluation::vectorised_kernels())
                                               .plan(surface, many(some, tolerance)),
                                           some),
                             reference) <= tolerance);
}

TEST_CASE("moments are sums of weighted Chebyshev polynomials", "[series_kernels][oracle]") {
  constexpr std::size_t lanes = PixelStrip::lanes;
  constexpr double mid_um = 0.3, half_um = 0.2;
  const auto steps = GENERATE(std::size_t{1}, std::size_t{7}, std::size_t{8}, std::size_t{37});
  const int degrees = GENERATE(1, 2, 10, 40);
  CAPTURE(steps, degrees, seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> heights_um(steps * (lanes + 3)), weights(steps);
  for (double& h : heights_um) h = mid_um + half_um * uniform(random);
  for (double& weight : weights) weight = uniform(random);
  const PixelStrip strip{
      heights_um.data(), static_cast<std::ptrdiff_t>(lanes + 3), steps, weights.data(), mid_um,
      1 / half_um};
  const auto size = static_cast<std::size_t>(degrees) * lanes;
  std::vector<double> portable(size, -1.0), vectorised(size, -1.0);
  portable_kernels.moments(strip, degrees, portable.data());
  evaluation::vectorised_kernels().moments(strip, degrees, vectorised.data());
  for (std::size_t m = 0; m < static_cast<std::size_t>(degrees); ++m)
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      double exact = 0;
      for (std::size_t j = 0; j < steps; ++j) {
        const double s = (heights_um[j * (lanes + 3) + lane] - mid_um) / half_um;
        exact +=
            weights[j] * std::cos(static_cast<double>(m) * std::acos(std::clamp(s, -1.0, 1.0)));
      }
      // T_m has a slope of up to m^2 and s is rounded: 1e-16 m^2 a step.
      const double tolerance =
          1e-15 * static_cast<double>(steps) * (1 + static_cast<double>(m * m));
      CHECK(std::abs(portable[m * lanes + lane] - exact) <= tolerance);
      CHECK(std::abs(vectorised[m * lanes + lane] - exact) <= tolerance);
    }
}

TEST_CASE("pixels are spread as by the portable loop", "[series_kernels][oracle]") {
  constexpr std::size_t lanes = PixelStrip::lanes;
  constexpr std::size_t points = 40;
  const int degrees = GENERATE(1, 8, 11, 30);
  const int width = GENERATE(3, 7, 12);
  const int count = GENERATE(1, 5, 8);
  CAPTURE(degrees, width, count, seed);
  const InterpolationKernel kernel = InterpolationKernel::semicircle(width, 4).shortened(4, 1e-9);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto stride = static_cast<std::size_t>((degrees + 7) / 8 * 8);
  std::vector<double> moments(stride * lanes, 0.0), positions(lanes), weights(lanes);
  for (std::size_t n = 0; n < static_cast<std::size_t>(degrees) * lanes; ++n)
    moments[n] = uniform(random);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    positions[lane] = 8 + 20 * uniform(random);
    weights[lane] = uniform(random);
  }
  const auto spread = [&](const SeriesKernels& kernels) {
    std::vector<double> samples(points * stride, 0.25);
    const SpreadLine line{{1, 0, 0, points, width, kernel.degree(), kernel.pieces(),
                           kernel.tap_stride(), kernel.coefficients().data(), points, 1},
                          degrees,
                          stride,
                          samples.data()};
    kernels.spread(line, positions.data(), weights.data(), count, moments.data());
    return samples;
  };
  const std::vector<double> portable = spread(portable_kernels),
                            vectorised = spread(evaluation::vectorised_kernels());
  for (std::size_t m = 0; m < static_cast<std::size_t>(degrees); ++m)
    for (std::size_t n = 0; n < points; ++n) {
      double exact = 0.25;
      for (std::size_t lane = 0; lane < static_cast<std::size_t>(count); ++lane) {
        const double start = positions[lane] - width / 2.0, k0 = std::ceil(start);
        const double tap = static_cast<double>(n) - k0;
        if (tap >= 0 && tap < width)
          exact += weights[lane] * moments[m * lanes + lane] *
                   kernel.taps(k0 - start)[static_cast<std::size_t>(tap)];
      }
      // A few roundings of at most eight terms below 1.
      CHECK(std::abs(portable[n * stride + m] - exact) <= 4e-15);
      CHECK(std::abs(vectorised[n * stride + m] - exact) <= 4e-15);
    }
}
