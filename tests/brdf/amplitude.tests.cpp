#include "brdf/amplitude.h"

#include <catch2/catch.hpp>
#include <vector>

#include "brdf/direct_sum.h"
#include "brdf/taylor_series.h"
#include "tests/support/amplitudes.h"
#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::DirectSum;
using brdf::GaussianWindow;
using brdf::HeightArray;
using brdf::HeightField;
using brdf::Length;
using brdf::pi;
using brdf::Query;
using brdf::QueryBounds;
using brdf::Surface;
using brdf::SurfaceModel;
using brdf::TaylorSeries;
using Complex = std::complex<double>;

namespace {

constexpr Grid oblong{12, 15, 0.11, 0.17};

// Phases of up to 33 rad/um over 2 um carry 1e-14; terms up to e^5 of the series 2e-14.
constexpr double rounding = 1e-13;

Surface periodic(const HeightField& field, double sigma_um = 0.45) {
  return {&field, GaussianWindow(Length::um(sigma_um)), SurfaceModel::periodic};
}

HeightField with_heights(HeightArray heights_um) {
  return HeightField(std::move(heights_um), Length::um(oblong.dx_um), Length::um(oblong.dy_um));
}

std::vector<Query> random_queries(Uniform& uniform, int count) {
  std::vector<Query> queries;
  for (int i = 0; i < count; ++i)
    queries.push_back(
        query(random_direction(uniform), random_direction(uniform), Length::nm(uniform(380, 780))));
  return queries;
}

/// Largest difference between a(q) of one surface and change(b(map(q)), q) of another.
template <class Method, class Map, class Change>
double difference(const Surface& one, const Surface& other, const std::vector<Query>& queries,
                  Map map, Change change) {
  std::vector<Query> mapped;
  for (const Query& q : queries) mapped.push_back(map(q));
  const Amplitudes a = amplitudes(Method{}, one, queries);
  const Amplitudes b = amplitudes(Method{}, other, mapped);
  WorstError worst;
  for (std::size_t i = 0; i < queries.size(); ++i)
    worst.see(std::abs(a[i] - change(b[i], queries[i])));
  return worst.value();
}

const auto same_query = [](const Query& q) { return q; };
const auto same_value = [](const Complex& a, const Query&) { return a; };

}  // namespace

TEST_CASE("the bounds hold every query and touch the outermost", "[amplitude][invariant]") {
  const std::vector<Query> queries = {{1, -5, -7}, {-2, 4, -9}, {0.5, 0, -8}};
  const QueryBounds bounds = brdf::bounds_of(queries, 1e-6);
  CHECK(bounds.lo.qx_per_um == -2);
  CHECK(bounds.lo.qy_per_um == -5);
  CHECK(bounds.lo.c_per_um == -9);
  CHECK(bounds.hi.qx_per_um == 1);
  CHECK(bounds.hi.qy_per_um == 4);
  CHECK(bounds.hi.c_per_um == -7);
  CHECK(bounds.count == 3);
  CHECK(bounds.tolerance == 1e-6);
}

TEST_CASE("the largest modulus of c is found at either end", "[amplitude][invariant]") {
  CHECK(QueryBounds{{0, 0, -9}, {0, 0, -7}, 1, 1}.max_abs_c_per_um() == 9);
  CHECK(QueryBounds{{0, 0, -2}, {0, 0, 5}, 1, 1}.max_abs_c_per_um() == 5);
  CHECK(QueryBounds{{0, 0, 3}, {0, 0, 4}, 1, 1}.max_abs_c_per_um() == 4);
}

TEST_CASE("stored heights are known to half a step", "[amplitude][oracle]") {
  // 8 bits over 500 nm at 380 nm, normal incidence: 33 rad/um times 1 nm, the 3e-2 rad of a scan.
  const brdf::HeightField field(brdf::HeightArray::Zero(2, 2), brdf::Length::um(1),
                                brdf::Length::um(1), brdf::Length::nm(500.0 / 255));
  const double c = -2 * brdf::wavenumber_per_um(brdf::Length::nm(380));
  const QueryBounds bounds{{0, 0, c}, {0, 0, c / 2}, 1, 1e-6};
  CHECK(std::abs(brdf::input_phase_error_rad(field, bounds) - 0.0324) <= 5e-5);  // three digits
}

TEMPLATE_TEST_CASE("a constant height adds only a phase", "[amplitude][invariant]", DirectSum,
                   TaylorSeries) {
  constexpr std::uint64_t seed = 101;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, oblong, 0, 0.3);
  const HeightField raised = with_heights(field.heights_um() + 0.75);
  CHECK(difference<TestType>(periodic(raised), periodic(field), random_queries(uniform, 20),
                             same_query, [](const Complex& a, const Query& q) {
                               return a * std::polar(1.0, 0.75 * q.c_per_um);
                             }) <= rounding);
}

TEMPLATE_TEST_CASE("a mirrored surface has the mirrored transform", "[amplitude][invariant]",
                   DirectSum, TaylorSeries) {
  constexpr std::uint64_t seed = 102;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, oblong, 0, 0.3);
  const HeightField in_x = with_heights(field.heights_um().rowwise().reverse());
  const HeightField in_y = with_heights(field.heights_um().colwise().reverse());
  const std::vector<Query> queries = random_queries(uniform, 20);
  CHECK(difference<TestType>(
            periodic(in_x), periodic(field), queries,
            [](const Query& q) {
              return Query{-q.qx_per_um, q.qy_per_um, q.c_per_um};
            },
            same_value) <= rounding);
  CHECK(difference<TestType>(
            periodic(in_y), periodic(field), queries,
            [](const Query& q) {
              return Query{q.qx_per_um, -q.qy_per_um, q.c_per_um};
            },
            same_value) <= rounding);
  CHECK(difference<TestType>(periodic(in_x), periodic(field), queries, same_query, same_value) >=
        1e-3);
}

TEMPLATE_TEST_CASE("a surface turned by 90 deg has the turned transform", "[amplitude][invariant]",
                   DirectSum, TaylorSeries) {
  // h'(x, y) = h(y, -x): the pattern turns by +90 deg, and a'(qx, qy) = a(qy, -qx).
  constexpr std::uint64_t seed = 103;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, oblong, 0, 0.3);
  const HeightField turned(field.heights_um().transpose().rowwise().reverse(),
                           Length::um(oblong.dy_um), Length::um(oblong.dx_um));
  CHECK(difference<TestType>(
            periodic(turned), periodic(field), random_queries(uniform, 20),
            [](const Query& q) {
              return Query{q.qy_per_um, -q.qx_per_um, q.c_per_um};
            },
            same_value) <= rounding);
}

TEMPLATE_TEST_CASE("scaling every length scales nothing else", "[amplitude][invariant]", DirectSum,
                   TaylorSeries) {
  constexpr std::uint64_t seed = 104;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, oblong, 0, 0.3);
  const HeightField larger(3 * field.heights_um(), Length::um(3 * oblong.dx_um),
                           Length::um(3 * oblong.dy_um));
  CHECK(difference<TestType>(
            periodic(field), periodic(larger, 3 * 0.45), random_queries(uniform, 20),
            [](const Query& q) {
              return Query{q.qx_per_um / 3, q.qy_per_um / 3, q.c_per_um / 3};
            },
            same_value) <= rounding);
}

TEMPLATE_TEST_CASE("the opposite scattering vector gives the conjugate", "[amplitude][invariant]",
                   DirectSum, TaylorSeries) {
  constexpr std::uint64_t seed = 105;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, oblong, 0, 0.3);
  CHECK(difference<TestType>(
            periodic(field), periodic(field), random_queries(uniform, 20),
            [](const Query& q) {
              return Query{-q.qx_per_um, -q.qy_per_um, -q.c_per_um};
            },
            [](const Complex& a, const Query&) { return std::conj(a); }) <= rounding);
}

TEMPLATE_TEST_CASE("a shift by whole pixels turns the phase of separate lines only",
                   "[amplitude][invariant]", DirectSum, TaylorSeries) {
  // Under a window of twice the patch the lines do not touch; under a quarter of it the window
  // sees another part of the surface and nothing of the kind holds.
  constexpr std::uint64_t seed = 106;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, {10, 10, 0.1, 0.1}, 0, 0.3);
  HeightArray moved(10, 10);
  for (Eigen::Index col = 0; col < 10; ++col)
    moved.col((col + 3) % 10) = field.heights_um().col(col);
  const HeightField shifted(moved, Length::um(0.1), Length::um(0.1));
  std::vector<Query> lines;
  for (int j = -5; j <= 5; ++j) lines.push_back({2 * pi * j, 2 * pi * (2 - j), -20.0 - j});
  const auto turned = [](const Complex& a, const Query& q) {
    return a * std::polar(1.0, 0.3 * q.qx_per_um);
  };
  CHECK(difference<TestType>(periodic(shifted, 2), periodic(field, 2), lines, same_query, turned) <=
        rounding);
  CHECK(difference<TestType>(periodic(shifted, 0.25), periodic(field, 0.25), lines, same_query,
                             turned) >= 1e-2);
}

TEMPLATE_TEST_CASE("swapping light and viewer changes no amplitude", "[amplitude][invariant]",
                   DirectSum, TaylorSeries) {
  constexpr std::uint64_t seed = 107;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, {5, 6, 0.11, 0.17}, 0, 0.3);
  const Surface surface = periodic(field, 0.2);
  std::vector<Query> there, back;
  for (int i = 0; i < 10000; ++i) {
    const brdf::Direction a = random_direction(uniform, 89.999),
                          b = random_direction(uniform, 89.999);
    const Length wavelength = Length::nm(uniform(380, 780));
    there.push_back(query(a, b, wavelength));
    back.push_back(query(b, a, wavelength));
  }
  const Amplitudes forth = amplitudes(TestType{}, surface, there, 1e-6);
  const Amplitudes again = amplitudes(TestType{}, surface, back, 1e-6);
  WorstError worst;
  for (std::size_t i = 0; i < there.size(); ++i)
    worst.see(std::abs(std::norm(forth[i]) - std::norm(again[i])));
  CHECK(worst.value() <= 1e-15);  // both depend on the sum of the directions, which commutes
}

TEMPLATE_TEST_CASE("amplitudes stay finite and at most 1 near the horizon",
                   "[amplitude][crossover]", DirectSum, TaylorSeries) {
  constexpr std::uint64_t seed = 108;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, oblong, 0, 0.3);
  std::vector<Query> grazing;
  for (const double from_horizon : {1e-3, 1e-6, 1e-9})
    for (const double phi_deg : {0.0, 77.0, 180.0})
      grazing.push_back(
          query(brdf::direction(brdf::Angle::rad(pi / 2 - from_horizon), {}),
                brdf::direction(brdf::Angle::rad(pi / 2 - from_horizon), brdf::Angle::deg(phi_deg)),
                Length::nm(380)));
  for (const Complex& a : amplitudes(TestType{}, periodic(field), grazing))
    CHECK(std::abs(a) <= 1 + rounding);
  // Towards the mirror at the horizon any surface is smooth: c h = 2 k 1e-9 h.
  CHECK(std::abs(amplitudes(TestType{}, periodic(field), grazing).back() - 1.0) <= 1e-6);
}

TEST_CASE("bounds need queries, all of them finite", "[amplitude][invariant]") {
  CHECK_ERROR(brdf::bounds_of({}, 1e-6), brdf::Errc::invalid_argument, "at least one");
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()})
    for (std::size_t count : {1, 2, 3, 4, 5, 8, 9})
      for (std::size_t at = 0; at < count; ++at)
        for (double Query::*component : {&Query::qx_per_um, &Query::qy_per_um, &Query::c_per_um}) {
          std::vector<Query> queries(count, Query{1, 2, 3});
          queries[at].*component = bad;
          CHECK_ERROR(brdf::bounds_of(queries, 1e-6), brdf::Errc::invalid_argument, "not finite");
        }
}

TEST_CASE("the outermost query may be any of them", "[amplitude][invariant]") {
  for (std::size_t count : {1, 2, 3, 4, 5, 8, 9})
    for (std::size_t at = 0; at < count; ++at)
      for (double Query::*component : {&Query::qx_per_um, &Query::qy_per_um, &Query::c_per_um})
        for (const double far : {-7.0, 7.0}) {
          std::vector<Query> queries(count, Query{1, 2, 3});
          queries[at].*component = far;
          const QueryBounds bounds = brdf::bounds_of(queries, 1e-6);
          CHECK((far < 0 ? bounds.lo : bounds.hi).*component == far);
        }
}
