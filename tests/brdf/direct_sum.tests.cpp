#include "brdf/direct_sum.h"

#include <catch2/catch.hpp>

#include "brdf/grating_equation.h"
#include "tests/support/amplitudes.h"
#include "tests/support/is_error.h"
#include "tests/support/oracle_table.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::Angle;
using brdf::DirectSum;
using brdf::GaussianWindow;
using brdf::HeightField;
using brdf::Length;
using brdf::Origin;
using brdf::pi;
using brdf::Query;
using brdf::Surface;
using brdf::SurfaceModel;
using Complex = std::complex<double>;

namespace {

constexpr Grid small{6, 9, 0.11, 0.17};

/// The sum as it is written, in extended precision and with nothing taken out of the loops.
Complex by_definition(const Surface& surface, const Query& q, int copies) {
  using Wide = std::complex<long double>;
  const HeightField& field = *surface.heights;
  const long double sigma = surface.window.sigma_um();
  const bool corner = surface.origin == Origin::patch_corner;
  const long double x0 = corner ? 0 : static_cast<long double>(field.cols() - 1) / 2;
  const long double y0 = corner ? 0 : static_cast<long double>(field.rows() - 1) / 2;
  Wide sum = 0;
  long double area = 0;
  for (long row = -copies * field.rows(); row < (copies + 1) * field.rows(); ++row)
    for (long col = -copies * field.cols(); col < (copies + 1) * field.cols(); ++col) {
      const auto wrapped = [](long index, long count) { return (index % count + count) % count; };
      const long double x = (static_cast<long double>(col) - x0) * field.dx_um();
      const long double y = (static_cast<long double>(row) - y0) * field.dy_um();
      const long double h =
          field.heights_um()(wrapped(row, field.rows()), wrapped(col, field.cols()));
      const long double g = std::exp(-(x * x + y * y) / (2 * sigma * sigma));
      sum += std::polar(g, q.qx_per_um * x + q.qy_per_um * y + q.c_per_um * h);
      area += g;
    }
  return Complex(sum / area);
}

Query random_query(Uniform& uniform) {
  return query(random_direction(uniform), random_direction(uniform), Length::nm(uniform(380, 780)));
}

}  // namespace

TEST_CASE("the direct sum is its definition, within its reported rounding",
          "[direct_sum][oracle]") {
  constexpr std::uint64_t seed = 61;
  CAPTURE(seed);
  Uniform uniform(seed);
  // A second field far from height 0, where the phase c h is large.
  const HeightField low = random_heights(uniform, small, -0.3, 0.3);
  const HeightField high = random_heights(uniform, small, 40, 40.5);
  for (const HeightField* field : {&low, &high})
    for (const Origin origin : {Origin::patch_centre, Origin::patch_corner})
      for (const SurfaceModel model : {SurfaceModel::isolated, SurfaceModel::periodic}) {
        const Surface surface{field, GaussianWindow(Length::um(0.3)), model, origin};
        // 0.3 um in patches of 1 um: four copies on each side reach beyond 9 sigma.
        const int copies = model == SurfaceModel::isolated ? 0 : 4;
        WorstError over_bound;
        for (int i = 0; i < 20; ++i) {
          const Query q = random_query(uniform);
          const auto plan = DirectSum{}.plan(surface, brdf::bounds_of(std::vector{q}, 0));
          const double error =
              std::abs(amplitude(DirectSum{}, surface, q) - by_definition(surface, q, copies));
          over_bound.see(error / plan.report().error_bound);
        }
        CHECK(over_bound.value() <= 1);
      }
}

TEST_CASE("orders of a sinusoid have the angles, depths and powers of the table",
          "[direct_sum][oracle]") {
  WorstError c_error, power_error;
  for (const OracleRow& row : oracle_table("sinusoid_orders.csv")) {
    const brdf::ProfileParameters profile{.profile = brdf::Profile::sinusoid,
                                          .period = Length::um(number(row[3])),
                                          .height = Length::um(number(row[1]))};
    // 64 samples a period: the nearest alias is J_53(3), below 1e-50.
    const HeightField field = one_period(profile, 64);
    const Length lambda = Length::um(number(row[4]));
    const Angle theta_i = Angle::deg(number(row[5]));
    const auto theta_r =
        brdf::viewing_angle(static_cast<int>(number(row[6])), profile.period, lambda, theta_i);
    REQUIRE(theta_r);
    const Query q = query_in_plane(theta_i, *theta_r, lambda);
    c_error.see(std::abs(-q.c_per_um - number(row[8])));
    power_error.see(
        std::abs(std::norm(amplitude(DirectSum{}, separate_lines(field), q)) - number(row[9])));
  }
  CHECK(c_error.value() <= 1e-13);  // c up to 31 per um; cosines of angles near 84 deg carry 1e-15
  // The frequency of the order is right to 1e-15 of k; over 20 periods of 2.5 um it makes phases
  // of 1e-13, and their mean over the symmetric window vanishes to first order.
  CHECK(power_error.value() <= 1e-14);
}

TEST_CASE("a tilted plane reflects like a tilted mirror", "[direct_sum][oracle]") {
  const Length lambda = Length::nm(550);
  for (const OracleRow& row : oracle_table("tilted_plane.csv")) {
    const double slope = number(row[0]), theta_i_deg = number(row[1]);
    const double peak_deg = number(row[2]);
    CAPTURE(slope, theta_i_deg);
    const HeightField along_x =
        sampled(1, 201, 0.1, 0.1, [&](double x, double) { return slope * x; });
    const HeightField along_y =
        sampled(201, 1, 0.1, 0.1, [&](double, double y) { return slope * y; });
    for (const double phi_deg : {0.0, 90.0}) {
      const HeightField& field = phi_deg == 0 ? along_x : along_y;
      const Surface surface{&field, GaussianWindow(Length::um(4)), SurfaceModel::isolated};
      const auto power = [&](double theta_r_deg) {
        const Angle phi = Angle::deg(phi_deg);
        return std::norm(amplitude(DirectSum{}, surface,
                                   query(brdf::direction(Angle::deg(theta_i_deg), phi),
                                         brdf::direction(Angle::deg(theta_r_deg), phi), lambda)));
      };
      // All pixels in phase; phases of up to 230 rad carry 1e-13, to second order here.
      CHECK(std::abs(power(peak_deg) - 1) <= 1e-14);
      // The peak is found where it is, by thirds, up to the root of the rounding: it is about
      // 1 deg wide, so 1e-7 deg.
      double lo = peak_deg - 1, hi = peak_deg + 0.8;
      while (hi - lo > 1e-8) {
        const double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
        (power(a) < power(b) ? lo : hi) = power(a) < power(b) ? a : b;
      }
      CHECK(std::abs((lo + hi) / 2 - peak_deg) <= 1e-6);
    }
  }
}

TEST_CASE("a flat periodic patch has the transform of its window", "[direct_sum][oracle]") {
  const HeightField field = sampled(10, 13, 0.1, 0.12, [](double, double) { return 0.25; });
  constexpr std::uint64_t seed = 62;
  CAPTURE(seed);
  Uniform uniform(seed);
  for (const Origin origin : {Origin::patch_centre, Origin::patch_corner}) {
    const double sigma_um = 0.5;
    const Surface surface{&field, GaussianWindow(Length::um(sigma_um)), SurfaceModel::periodic,
                          origin};
    WorstError error;
    for (int i = 0; i < 200; ++i) {
      // u and v up to 1: the lattice's own aliases lie 40 per um away, exp(-(20)^2 / 2).
      const double k = uniform(8, 16.5), u = uniform(-1, 1), v = uniform(-1, 1);
      const double c = -k * uniform(0.2, 2);
      const double closed = std::exp(-std::pow(k * sigma_um, 2) * (u * u + v * v) / 2);
      error.see(std::abs(amplitude(DirectSum{}, surface, {k * u, k * v, c}) -
                         std::polar(closed, c * 0.25)));
    }
    CHECK(error.value() <= 2e-14);  // phases of up to 16.5 * 2 * 6 um: 200 eps / 2
  }
}

TEST_CASE("an isolated patch far wider than the window is as good as periodic",
          "[direct_sum][crossover]") {
  constexpr std::uint64_t seed = 63;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, {40, 44, 0.1, 0.1}, 0, 0.5);
  const auto difference = [&](double sigma_um) {
    WorstError worst;
    const GaussianWindow window(Length::um(sigma_um));
    for (int i = 0; i < 10; ++i) {
      const Query q = random_query(uniform);
      worst.see(std::abs(amplitude(DirectSum{}, {&field, window, SurfaceModel::isolated}, q) -
                         amplitude(DirectSum{}, {&field, window, SurfaceModel::periodic}, q)));
    }
    return worst.value();
  };
  CHECK(difference(0.2) <= 1e-14);  // the edge at 10 sigma holds exp(-50); rounding is left
  CHECK(difference(1.0) >= 1e-3);   // the sources' quarter: they differ by per cents of the peak
}

TEST_CASE("the direct sum says what it supports, holds and knows", "[direct_sum][invariant]") {
  const HeightField field(brdf::HeightArray::Zero(2, 2), Length::um(0.1), Length::um(0.1),
                          Length::nm(2));
  const Surface surface{&field, GaussianWindow(Length::um(1)), SurfaceModel::isolated};
  const brdf::QueryBounds bounds{{0, 0, -30}, {1, 1, -10}, 5, 1e-6};
  CHECK(DirectSum::supports(SurfaceModel::isolated));
  CHECK(DirectSum::supports(SurfaceModel::periodic));
  const brdf::PlanReport report = DirectSum{}.plan(surface, bounds).report();
  CHECK(std::abs(report.input_phase_error_rad - 0.03) <= 1e-17);  // 30 per um times 1 nm
  CHECK(report.terms == 0);
  CHECK(report.bytes == DirectSum::bytes(surface, bounds));
}

TEST_CASE("amplitudes do not depend on the queries beside them", "[direct_sum][invariant]") {
  constexpr std::uint64_t seed = 64;
  CAPTURE(seed);
  Uniform uniform(seed);
  const HeightField field = random_heights(uniform, small, -0.3, 0.3);
  const Surface surface{&field, GaussianWindow(Length::um(0.3)), SurfaceModel::periodic};
  std::vector<Query> queries;
  for (int i = 0; i < 30; ++i) queries.push_back(random_query(uniform));
  const Amplitudes together = amplitudes(DirectSum{}, surface, queries);
  for (std::size_t i = 0; i < queries.size(); ++i)
    REQUIRE(amplitude(DirectSum{}, surface, queries[i]) == together[i]);
}

TEST_CASE("a direct sum over more copies than there is room for is refused",
          "[direct_sum][invariant]") {
  const HeightField field(brdf::HeightArray::Zero(2, 3), Length::um(0.1), Length::um(0.1));
  const auto copies = [&](int x, int y) {
    return Surface{&field,
                   GaussianWindow(Length::um(1)),
                   SurfaceModel::replicated,
                   brdf::Origin::patch_centre,
                   {x, y}};
  };
  const brdf::QueryBounds bounds{{0, 0, -30}, {1, 1, -10}, 5, 1e-6};
  CHECK_ERROR(DirectSum{}.plan(copies(1'000'000'000, 1), bounds), brdf::Errc::over_limit, "3e+09");
  CHECK_ERROR(DirectSum{}.plan(copies(1, 40'000'000), bounds), brdf::Errc::over_limit, "8e+07");
  // A position and an illumination for each pixel of an axis.
  CHECK(DirectSum::bytes(copies(5, 1000), bounds) == (15 + 2000) * 2 * sizeof(double));
}
