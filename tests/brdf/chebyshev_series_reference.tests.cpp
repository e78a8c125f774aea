// The Chebyshev series and the direct sum against their definition in 50-digit arithmetic.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <vector>

#include "brdf/chebyshev_series.h"
#include "brdf/direct_sum.h"
#include "tests/support/amplitudes.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::ChebyshevSeries;
using brdf::HeightField;
using brdf::Length;
using brdf::pi;
using brdf::Query;
using brdf::Surface;
using brdf::SurfaceModel;

namespace {

using Real50 = boost::multiprecision::cpp_bin_float_50;

struct Complex50 {
  Real50 re = 0, im = 0;
};
Complex50 operator*(const Complex50& a, const Complex50& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
void operator+=(Complex50& sum, const Complex50& a) {
  sum.re += a.re;
  sum.im += a.im;
}
Complex50 phasor(const Real50& phase) {
  return {cos(phase), sin(phase)};
}
double distance(const std::complex<double>& a, const Complex50& b) {
  const Real50 re = a.real() - b.re, im = a.imag() - b.im;
  return static_cast<double>(sqrt(re * re + im * im));
}

/// One axis of a surface, from the definition of the models: nothing is taken from brdf/surface.h.
class Axis50 {
 public:
  Axis50(const Surface& surface, Eigen::Index count, double pixel_um, int replicas)
      : count_(count), pixel_um_(pixel_um) {
    long first = 0, last = count - 1;
    if (surface.model == SurfaceModel::replicated) last = count * replicas - 1;
    if (surface.model == SurfaceModel::periodic) {
      // All repetitions that a part of the window above exp(-12^2 / 2) = 5e-32 falls on.
      const long copies = 1 + static_cast<long>(12 * surface.window.sigma_um() /
                                                (pixel_um * static_cast<double>(count)));
      first = -count * copies;
      last = count * (copies + 1) - 1;
    }
    const Real50 middle = Real50(first + last) / 2, sigma = surface.window.sigma_um();
    for (long n = first; n <= last; ++n) {
      const Real50 x = pixel_um_ * (n - middle);
      g_.push_back(surface.model == SurfaceModel::replicated ? Real50(1)
                                                             : exp(-x * x / (2 * sigma * sigma)));
      sum_ += g_.back();
    }
    first_um_ = pixel_um_ * (first - middle);
  }

  /// Per pixel: the sum over its repetitions of g(x) exp(i q x), divided by the sum of all g.
  std::vector<Complex50> weights(double q_per_um) const {
    std::vector<Complex50> weights(static_cast<std::size_t>(count_));
    Complex50 wave = phasor(q_per_um * first_um_);
    const Complex50 step = phasor(q_per_um * pixel_um_);
    for (std::size_t n = 0; n < g_.size(); ++n) {
      const Real50 g = g_[n] / sum_;
      weights[n % weights.size()] += {g * wave.re, g * wave.im};
      wave = wave * step;  // loses one of 50 digits in a thousand steps
    }
    return weights;
  }

 private:
  Eigen::Index count_;
  Real50 pixel_um_, first_um_, sum_ = 0;
  std::vector<Real50> g_;
};

/// exp(i c h) of every pixel: the slow part, needed once for all models and planes.
std::vector<Complex50> relief_phasors(const HeightField& field, double c_per_um) {
  std::vector<Complex50> phasors;
  for (const double h : field.heights_um().reshaped<Eigen::RowMajor>())
    phasors.push_back(phasor(Real50(c_per_um) * h));
  return phasors;
}

/// The amplitudes of queries that share their c with the `reliefs`, in that order.
std::vector<Complex50> by_definition(const Surface& surface, const std::vector<Query>& queries,
                                     const std::vector<std::vector<Complex50>>& reliefs) {
  const HeightField& field = *surface.heights;
  const Axis50 x(surface, field.cols(), field.dx_um(), surface.replicas.x);
  const Axis50 y(surface, field.rows(), field.dy_um(), surface.replicas.y);
  std::vector<Complex50> amplitudes;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const std::vector<Complex50> along_x = x.weights(queries[i].qx_per_um);
    const std::vector<Complex50> along_y = y.weights(queries[i].qy_per_um);
    Complex50 total;
    for (std::size_t row = 0; row < along_y.size(); ++row) {
      Complex50 line;
      for (std::size_t col = 0; col < along_x.size(); ++col)
        line += along_x[col] * reliefs[i][row * along_x.size() + col];
      total += along_y[row] * line;
    }
    amplitudes.push_back(total);
  }
  return amplitudes;
}

constexpr std::uint64_t seed = 501;

enum class Relief { blazed, sinusoid, rough, deep_step, phase_depth_200 };

/// 36 x 45 pixels of 0.12 um x 0.1 um; grooves 8 degrees off the rows.
HeightField relief(Relief kind, double largest_c_per_um) {
  Uniform uniform(seed);
  const auto height_um = [&](double x_um, double y_um) {
    const double cycles = x_um / 2.33 + y_um / 16.6 + 0.1, tooth = cycles - std::floor(cycles);
    switch (kind) {
      case Relief::blazed:
        return 0.15 * (1 - tooth);
      case Relief::sinusoid:
        return 0.2 * std::cos(2 * pi * cycles);
      case Relief::rough:
        return uniform(0, 0.4);
      case Relief::deep_step:
        return x_um + y_um / 7 > 0.3 ? 3.0 : 0.0;
      case Relief::phase_depth_200:
        return uniform(-1, 1) * 100 / largest_c_per_um;
    }
    return 0.0;
  };
  HeightField field = sampled(36, 45, 0.1, 0.12, height_um);
  if (kind != Relief::phase_depth_200) return field;
  brdf::HeightArray heights_um = field.heights_um();
  heights_um(0, 0) = -100 / largest_c_per_um;  // the whole depth is there
  heights_um(35, 44) = 100 / largest_c_per_um;
  return HeightField(std::move(heights_um), Length::um(0.1), Length::um(0.12));
}

/// Turns queries of any direction into a request of one kind.
enum class Plane { along_x, along_y, general };
std::vector<Query> in_plane(std::vector<Query> queries, Plane plane) {
  for (Query& q : queries) {
    if (plane == Plane::along_x) q.qy_per_um = 0.3;
    if (plane == Plane::along_y) q.qx_per_um = -1.7;
  }
  return queries;
}

/// Every tolerance by the series, in the precision that it chooses and in single precision where
/// that is allowed, and the direct sum.
void check(const Surface& surface, const std::vector<Query>& queries,
           const std::vector<Complex50>& exact) {
  const auto worst_of = [&](const auto& plan) {
    Amplitudes amplitudes(queries.size());
    plan.evaluate(queries, amplitudes);
    WorstError worst;
    for (std::size_t i = 0; i < queries.size(); ++i) worst.see(distance(amplitudes[i], exact[i]));
    return worst.value();
  };
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12})
    for (const std::size_t double_table_bytes : {std::size_t{64} << 20, std::size_t{0}}) {
      const ChebyshevSeries method(brdf::portable_kernels,
                                   {brdf::SmallRequests::by_series, double_table_bytes});
      const auto plan = method.plan(surface, bounds_of(queries, tolerance));
      const double error = worst_of(plan), bound = plan.report().error_bound;
      CAPTURE(tolerance, double_table_bytes, bound);
      REQUIRE(plan.explain().path != brdf::SeriesPath::direct_sum);
      CHECK(error <= tolerance);
      CHECK(error <= bound);
      CHECK(bound <= tolerance);  // below 300 rad rounding, 7e-14, leaves 1e-12 attainable
    }
  const auto direct = brdf::DirectSum{}.plan(surface, bounds_of(queries, 1e-12));
  CHECK(worst_of(direct) <= direct.report().error_bound);
}

}  // namespace

TEST_CASE("series and direct sum meet 50-digit arithmetic within tolerance and bound",
          "[chebyshev_series][oracle]") {
  const auto kind = GENERATE(Relief::blazed, Relief::sinusoid, Relief::rough, Relief::deep_step,
                             Relief::phase_depth_200);
  Uniform uniform(seed + 1);
  std::vector<Query> queries;
  for (int i = 0; i < 8; ++i)
    queries.push_back(
        query(random_direction(uniform), random_direction(uniform), Length::nm(uniform(380, 780))));
  const HeightField field = relief(kind, bounds_of(queries, 1).max_abs_c_per_um());
  std::vector<std::vector<Complex50>> reliefs;
  for (const Query& q : queries) reliefs.push_back(relief_phasors(field, q.c_per_um));
  // The window is cut at the patch's edge, at 1.2 sigma.
  for (const SurfaceModel model :
       {SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated})
    for (const Plane plane : {Plane::along_x, Plane::along_y, Plane::general}) {
      CAPTURE(static_cast<int>(kind), static_cast<int>(model), static_cast<int>(plane), seed);
      const Surface surface{
          &field, brdf::GaussianWindow(Length::um(1.8)), model, brdf::Origin::patch_centre, {3, 2}};
      const std::vector<Query> request = in_plane(queries, plane);
      check(surface, request, by_definition(surface, request, reliefs));
    }
}

TEST_CASE("bounds cover the rounding of a window over hundreds of patches",
          "[chebyshev_series][direct_sum][oracle]") {
  CAPTURE(seed);
  const double sigma_um = GENERATE(2.0, 35.0);
  CAPTURE(sigma_um);
  const HeightField field = sampled(2, 2, 0.45, 0.45, [](double, double) { return 0.1; });
  const Surface surface{&field, brdf::GaussianWindow(Length::um(sigma_um)), SurfaceModel::periodic};
  Uniform uniform(seed + 2);
  std::vector<Query> queries;
  std::vector<std::vector<Complex50>> reliefs;
  for (int i = 0; i < 8; ++i) {
    // Where the amplitude is large: about the first lines, each 2 pi / 0.9 um and 1 / sigma wide.
    queries.push_back({(i % 2) * 2 * pi / 0.9 + uniform(-0.3, 0.3) / sigma_um, 0, -uniform(2, 10)});
    reliefs.push_back(relief_phasors(field, queries.back().c_per_um));
  }
  check(surface, queries, by_definition(surface, queries, reliefs));
}
