#include "brdf/pq_series.h"

#include <catch2/catch.hpp>

#include "brdf/direct_sum.h"
#include "tests/support/amplitudes.h"
#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::BinInterpolation;
using brdf::DirectSum;
using brdf::Errc;
using brdf::GaussianWindow;
using brdf::HeightField;
using brdf::Length;
using brdf::Origin;
using brdf::pi;
using brdf::PqSeries;
using brdf::Query;
using brdf::QueryBounds;
using brdf::Replicas;
using brdf::Surface;
using brdf::SurfaceAxis;
using brdf::SurfaceModel;
using Complex = std::complex<double>;
using Wide = std::complex<long double>;

namespace {

constexpr long double pi_wide = 3.14159265358979323846264338327950288L;
constexpr BinInterpolation all[] = {BinInterpolation::nearest, BinInterpolation::linear,
                                    BinInterpolation::sinc, BinInterpolation::exact};

Surface copies_of(const HeightField& field, Replicas replicas,
                  Origin origin = Origin::patch_centre) {
  return {&field, GaussianWindow(Length::um(1)), SurfaceModel::replicated, origin, replicas};
}

/// exp(2 pi i cycles x / L) at every pixel of every copy. The turns are reduced while they are
/// whole numbers of half pixels times the cycles, before they meet pi.
std::vector<Wide> phasors(const SurfaceAxis& axis, double cycles) {
  std::vector<Wide> all_pixels;
  const long pixels = axis.count * (axis.last_copy + 1);
  const long origin_half_pixels = std::lround(2 * axis.origin);
  for (long pixel = 0; pixel < pixels; ++pixel) {
    const auto half_pixels = static_cast<long double>(2 * pixel - origin_half_pixels);
    const auto turn = static_cast<long double>(2 * axis.count);
    const long double turns = std::remainder(cycles * half_pixels, turn) / turn;
    all_pixels.push_back(std::polar(1.0L, 2 * pi_wide * turns));
  }
  return all_pixels;
}

/// The mean over all pixels of all copies, in extended precision, at the frequency in cycles that
/// the double of the query stands for.
Complex by_definition(const Surface& surface, const Query& q) {
  const HeightField& field = *surface.heights;
  const SurfaceAxis x = x_axis(surface), y = y_axis(surface);
  const std::vector<Wide> along_x = phasors(x, x.cycles(q.qx_per_um));
  const std::vector<Wide> along_y = phasors(y, y.cycles(q.qy_per_um));
  std::vector<Wide> tile;
  for (const double h : field.heights_um().reshaped<Eigen::RowMajor>())
    tile.push_back(std::polar(1.0L, static_cast<long double>(q.c_per_um) * h));
  const auto rows = static_cast<std::size_t>(field.rows());
  const auto cols = static_cast<std::size_t>(field.cols());
  Wide sum = 0;
  for (std::size_t row = 0; row < along_y.size(); ++row) {
    Wide in_row = 0;
    for (std::size_t col = 0; col < along_x.size(); ++col)
      in_row += along_x[col] * tile[row % rows * cols + col % cols];
    sum += along_y[row] * in_row;
  }
  return Complex(sum / static_cast<long double>(along_x.size() * along_y.size()));
}

/// Frequencies of all kinds along an axis of length L: at orders of the tile, near them, between.
double frequency(Uniform& uniform, double length_um, int kind) {
  const double order = std::round(uniform(-12, 12));
  const double distance = kind == 0   ? 0.0
                          : kind == 1 ? std::pow(10, -uniform(2, 16))
                                      : uniform(-0.5, 0.5);
  return 2 * pi * (order + distance) / length_um;
}

std::vector<Query> queries_on(const HeightField& field, Uniform& uniform, int count) {
  std::vector<Query> queries;
  for (int i = 0; i < count; ++i)
    queries.push_back({frequency(uniform, field.width_um(), i % 3),
                       frequency(uniform, field.height_um(), i / 3 % 3), uniform(-33, -5)});
  return queries;
}

HeightField rough(Uniform& uniform, const Grid& grid) {
  return random_heights(uniform, grid, 0.05, 0.25);
}

/// One interpolation as its formula says: bins of the centred tile by their definition, for the
/// heights themselves, not their powers; weights for each axis and bin.
Complex by_formula(const Surface& surface, BinInterpolation interpolation, const Query& q) {
  const HeightField& field = *surface.heights;
  const SurfaceAxis x = x_axis(surface), y = y_axis(surface);
  const auto weight = [&](double distance, double below) {
    const double d = std::abs(distance);
    if (interpolation == BinInterpolation::nearest) return d <= 0.5 ? 1.0 : 0.0;
    if (interpolation == BinInterpolation::linear) return std::max(0.0, 1 - d);
    if (d == 0) return 1.0;
    return below <= 1.5 ? std::sin(pi * d) / (pi * d) : 0.0;
  };
  const auto bin = [&](long j, long l) {
    Complex sum = 0;
    for (Eigen::Index r = 0; r < field.rows(); ++r)
      for (Eigen::Index c = 0; c < field.cols(); ++c) {
        const double turns =
            static_cast<double>(j) *
                (static_cast<double>(r) - static_cast<double>(field.rows() - 1) / 2) /
                static_cast<double>(field.rows()) +
            static_cast<double>(l) *
                (static_cast<double>(c) - static_cast<double>(field.cols() - 1) / 2) /
                static_cast<double>(field.cols());
        sum += std::polar(1.0, 2 * pi * turns + q.c_per_um * field.heights_um()(r, c));
      }
    return sum / static_cast<double>(field.heights_um().size());
  };
  const double nu = x.cycles(q.qx_per_um), mu = y.cycles(q.qy_per_um);
  Complex tile = 0;
  for (long j = std::lround(mu) - 2; j <= std::lround(mu) + 2; ++j)
    for (long l = std::lround(nu) - 2; l <= std::lround(nu) + 2; ++l) {
      const double from_y = std::abs(mu - static_cast<double>(j));
      const double from_x = std::abs(nu - static_cast<double>(l));
      const double w =
          weight(mu - static_cast<double>(j), from_y) * weight(nu - static_cast<double>(l), from_x);
      if (w != 0) tile += w * bin(j, l);
    }
  const auto copies = [](long double cycles, int n) {
    if (cycles == 0) return 1.0;
    return static_cast<double>(std::sin(n * pi_wide * cycles) / (n * std::sin(pi_wide * cycles)));
  };
  return tile * copies(nu, surface.replicas.x) * copies(mu, surface.replicas.y);
}

double worst_error(const Amplitudes& found, const Surface& surface,
                   const std::vector<Query>& queries) {
  WorstError worst;
  for (std::size_t i = 0; i < queries.size(); ++i)
    worst.see(std::abs(found[i] - by_definition(surface, queries[i])));
  return worst.value();
}

}  // namespace

TEST_CASE("the exact reading is the sum over every pixel of every copy", "[pq_series][oracle]") {
  constexpr std::uint64_t seed = 241;
  CAPTURE(seed);
  Uniform uniform(seed);
  // What 40 terms leave out at 3.3 rad is 1e-27.
  const PqSeries exact({.terms = 40});
  for (const Grid& grid : {Grid{6, 9, 0.11, 0.17}, {8, 5, 0.1, 0.1}, {1, 16, 0.12, 1}})
    for (const Replicas& replicas : {Replicas{1, 1}, {2, 3}, {7, 1}, {10, 25}, {99, 2}, {100, 100}})
      for (const Origin origin : {Origin::patch_centre, Origin::patch_corner}) {
        const HeightField field = rough(uniform, grid);
        const Surface surface = copies_of(field, replicas, origin);
        const std::vector<Query> queries = queries_on(field, uniform, 18);
        CAPTURE(replicas.x, replicas.y);
        // e^{c r} <= e^3.3 terms, a few roundings each. From the corner the phase q x of the middle
        // of the copies, up to 3000 rad in both axes, adds eps / 2 of itself.
        const double most = origin == Origin::patch_centre ? 2e-14 : 1e-12;
        const double worst = worst_error(amplitudes(exact, surface, queries), surface, queries);
        CHECK(worst <= most);
        CHECK(worst <= exact.plan(surface, brdf::bounds_of(queries, 1e-14)).report().error_bound);
        // In a plane of incidence the tables hold the sum over the other axis.
        std::vector<Query> in_plane = queries;
        for (Query& q : in_plane) q.qy_per_um = queries.front().qy_per_um;
        CHECK(worst_error(amplitudes(exact, surface, in_plane), surface, in_plane) <= most);
      }
}

TEST_CASE("the exact reading is the direct sum of the replicated surface", "[pq_series][oracle]") {
  constexpr std::uint64_t seed = 242;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = rough(uniform, {12, 15, 0.1, 0.13});
  for (const Replicas& replicas : {Replicas{1, 1}, {4, 3}, {30, 20}})
    for (const Origin origin : {Origin::patch_centre, Origin::patch_corner}) {
      const Surface surface = copies_of(field, replicas, origin);
      const std::vector<Query> queries = queries_on(field, uniform, 27);
      const QueryBounds bounds = brdf::bounds_of(queries, 1e-14);
      const double difference = largest_difference(amplitudes(PqSeries{}, surface, queries),
                                                   amplitudes(DirectSum{}, surface, queries));
      CHECK(difference <= PqSeries{}.plan(surface, bounds).report().error_bound +
                              DirectSum{}.plan(surface, bounds).report().error_bound);
      CHECK(difference <= 1e-12);  // phases of up to 2000 rad in double by the direct sum
    }
}

TEST_CASE("the exact reading keeps the tolerance it was asked for", "[pq_series][oracle]") {
  constexpr std::uint64_t seed = 243;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = rough(uniform, {12, 15, 0.1, 0.13});
  const Surface surface = copies_of(field, {2, 1});
  const std::vector<Query> queries = queries_on(field, uniform, 27);
  for (const double tolerance : {1e-2, 1e-4, 1e-8, 1e-11}) {
    CAPTURE(tolerance);
    const double worst =
        worst_error(amplitudes(PqSeries{}, surface, queries, tolerance), surface, queries);
    const double bound =
        PqSeries{}.plan(surface, brdf::bounds_of(queries, tolerance)).report().error_bound;
    CHECK(worst <= bound);
    CHECK(bound <= tolerance);
    CHECK(worst >= tolerance * 1e-4);  // no more terms than that asks for
  }
}

TEST_CASE("few bins are weighted as their formula says, over a range and in a plane",
          "[pq_series][oracle]") {
  constexpr std::uint64_t seed = 244;
  CAPTURE(seed);
  Uniform uniform(seed);
  for (const Grid& grid : {Grid{6, 9, 0.11, 0.17}, {9, 8, 0.1, 0.1}, {2, 7, 0.1, 0.1}})
    for (const BinInterpolation interpolation :
         {BinInterpolation::nearest, BinInterpolation::linear, BinInterpolation::sinc}) {
      const HeightField field = rough(uniform, grid);
      const Surface surface = copies_of(field, {3, 2});
      std::vector<Query> queries = queries_on(field, uniform, 18);
      for (const double qy_per_um : {std::nan(""), 0.0, 7.3}) {
        if (!std::isnan(qy_per_um))
          for (Query& q : queries) q.qy_per_um = qy_per_um;
        // The formula's factors are 0/0 at the orders but order 0.
        std::vector<Query> off_order = queries;
        for (Query& q : off_order) q.qx_per_um += 0.0137;
        for (Query& q : off_order)
          if (q.qy_per_um != 0) q.qy_per_um += 0.0119;
        const Amplitudes found =
            amplitudes(PqSeries({.terms = 40, .interpolation = interpolation}), surface, off_order);
        WorstError error;
        for (std::size_t i = 0; i < found.size(); ++i)
          error.see(std::abs(found[i] - by_formula(surface, interpolation, off_order[i])));
        CAPTURE(static_cast<int>(interpolation), qy_per_um);
        CHECK(error.value() <= 1e-12);  // phases of up to 80 rad, in double in the formula
      }
    }
}

TEST_CASE("what an interpolation is off never exceeds its bound, and comes near it",
          "[pq_series][invariant]") {
  constexpr std::uint64_t seed = 245;
  CAPTURE(seed);
  Uniform uniform(seed);
  // A blaze of half a wave over the tile sends everything half way between two bins.
  const HeightField tilted = sampled(1, 16, 0.1, 1, [](double x, double) { return 0.1 * x; });
  const HeightField wedge =
      sampled(8, 8, 0.1, 0.1, [](double x, double y) { return 0.1 * (x + y); });
  const HeightField random = rough(uniform, {7, 10, 0.1, 0.1});
  for (const HeightField* field : {&tilted, &wedge, &random})
    for (const int replicas : {1, 2, 20})
      for (const BinInterpolation interpolation : all) {
        const Surface surface = copies_of(*field, {replicas, field->rows() == 1 ? 1 : replicas});
        std::vector<Query> queries;
        for (int i = 0; i < 200; ++i)
          queries.push_back({uniform(-9, 9), field->rows() == 1 ? 0 : uniform(-9, 9), -25});
        const double half = pi / field->width_um();
        queries.push_back({half, field->rows() == 1 ? 0 : half, -half / 0.1});
        const PqSeries method({.interpolation = interpolation});
        const QueryBounds bounds = brdf::bounds_of(queries, 1e-12);
        const double worst =
            worst_error(amplitudes(method, surface, queries, 1e-12), surface, queries);
        const double bound = method.plan(surface, bounds).report().error_bound;
        CAPTURE(static_cast<int>(interpolation), replicas, bound);
        CHECK(worst <= bound);
        CHECK(bound <= 2);  // of two numbers in the unit disc, at the most
        // The tile half way: all of it is missed but what the bins beside hold.
        if (field == &tilted && replicas == 1 && interpolation != BinInterpolation::exact)
          CHECK(worst >= 0.3 * bound);
      }
}

TEST_CASE("at the orders of the tile every interpolation is exact", "[pq_series][invariant]") {
  constexpr std::uint64_t seed = 246;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = rough(uniform, {8, 9, 0.1, 0.13});
  for (const Replicas& replicas : {Replicas{1, 1}, {5, 4}, {1000, 300}}) {
    const Surface surface = copies_of(field, replicas);
    std::vector<Query> queries;
    for (int i = 0; i < 20; ++i)
      queries.push_back({frequency(uniform, field.width_um(), 0),
                         frequency(uniform, field.height_um(), 0), uniform(-33, -5)});
    const Amplitudes exact = amplitudes(PqSeries{}, surface, queries);
    for (const BinInterpolation interpolation : all) {
      CAPTURE(static_cast<int>(interpolation));
      // The query's frequency is the order to 2e-15 cycles.
      CHECK(largest_difference(
                amplitudes(PqSeries({.interpolation = interpolation}), surface, queries), exact) <=
            1e-13);
    }
  }
}

TEST_CASE("a plane of incidence takes one entry for the other axis", "[pq_series][invariant]") {
  const HeightField field = sampled(40, 50, 0.1, 0.1, [](double x, double) { return 0.1 * x; });
  const Surface surface = copies_of(field, {2, 2});
  const QueryBounds plane{{-20, 0, -30}, {20, 0, -10}, 9, 1e-6};
  const QueryBounds box{{-20, -5, -30}, {20, 5, -10}, 9, 1e-6};
  for (const BinInterpolation interpolation : all) {
    const PqSeries method({.terms = 30, .interpolation = interpolation});
    const brdf::PlanReport report = method.plan(surface, plane).report();
    CHECK(report.terms == 30);
    // 5 um at 20 per um: 16 bins to either side; or all 50 of them, and their sines.
    const std::size_t entry = 30 * sizeof(Complex);
    CHECK(report.bytes <= (interpolation == BinInterpolation::exact
                               ? 50 * entry + 2 * (100 + 80) * sizeof(double)
                               : 37 * entry));
    for (const QueryBounds& bounds : {plane, box})
      CHECK(method.bytes(surface, bounds) ==
            method.plan(surface, bounds).report().bytes + brdf::RealFourier2d::bytes(40, 50));
  }
}

TEST_CASE("the PQ method supports copies alone and refuses what has no meaning",
          "[pq_series][invariant]") {
  CHECK(PqSeries::supports(SurfaceModel::replicated));
  CHECK(!PqSeries::supports(SurfaceModel::periodic));
  CHECK(!PqSeries::supports(SurfaceModel::isolated));
  for (const int terms : {0, -4, brdf::max_taylor_terms + 1})
    CHECK_ERROR(PqSeries({.terms = terms}), Errc::invalid_argument,
                "terms " + std::to_string(terms));
  const HeightField field =
      sampled(2, 2, 0.1, 0.1, [](double x, double) { return x > 0 ? 0.2 : 0.0; });
  const QueryBounds bounds{{0, 0, -30}, {1, 1, -20}, 1, 1e-6};
  for (const Replicas& none : {Replicas{0, 1}, {1, -2}})
    CHECK_ERROR(PqSeries{}.plan(copies_of(field, none), bounds), Errc::invalid_argument,
                "replicas");
  CHECK_ERROR(PqSeries{}.plan(copies_of(field, {}), QueryBounds{{0, 0, -30}, {1, 1, -20}, 1, 0}),
              Errc::invalid_argument, "tolerance");
  const auto plan = PqSeries{}.plan(copies_of(field, {}), bounds);
  for (const Query& q : {Query{-0.1, 0, -25}, {0, 1.1, -25}, {0, 0, -31}, {std::nan(""), 0, -25}}) {
    Complex a;
    CHECK_ERROR(plan.evaluate({&q, 1}, {&a, 1}), Errc::invalid_argument, "outside the bounds");
  }
}

TEST_CASE("amplitudes of copies do not depend on the queries beside them",
          "[pq_series][invariant]") {
  constexpr std::uint64_t seed = 247;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = rough(uniform, {6, 9, 0.11, 0.17});
  const std::vector<Query> queries = queries_on(field, uniform, 20);
  for (const BinInterpolation interpolation : all) {
    const auto plan = PqSeries({.interpolation = interpolation})
                          .plan(copies_of(field, {3, 2}), brdf::bounds_of(queries, 1e-9));
    const Amplitudes together = amplitudes_of(plan, queries);
    for (std::size_t i = 0; i < queries.size(); ++i)
      REQUIRE(amplitudes_of(plan, {&queries[i], 1}).front() == together[i]);
  }
}
