#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "evaluation/albedo.h"
#include "tests/support/albedo.h"
#include "tests/support/is_error.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::Angle;
using brdf::Length;
using brdf::SurfaceModel;
using evaluation::AlbedoQuadrature;

namespace {

/// An amplitude of a function of the query.
template <class Function>
class Given final : public evaluation::Amplitude {
 public:
  explicit Given(Function function, double error_bound = 0)
      : function_(function), error_bound_(error_bound) {}
  void evaluate(std::span<const brdf::Query> queries,
                std::span<std::complex<double>> amplitudes) const override {
    for (std::size_t i = 0; i < queries.size(); ++i) amplitudes[i] = function_(queries[i]);
  }
  brdf::PlanReport report() const override {
    brdf::PlanReport report{};
    report.error_bound = error_bound_;
    return report;
  }

 private:
  Function function_;
  double error_bound_;
};

brdf::HeightField flat(Eigen::Index pixels, double pixel_um) {
  return sampled(pixels, pixels, pixel_um, pixel_um, [](double, double) { return 0.0; });
}

evaluation::Optics optics_of(const brdf::Surface& surface) {
  return {brdf::Quantity::brdf, coherence_area_um2(surface)};
}

/// A flat patch under an infinite Gaussian window, by its closed form.
auto gaussian_lobe(double sigma_um) {
  return [sigma_um](const brdf::Query& q) {
    return std::complex<double>(std::exp(-(q.qx_per_um * q.qx_per_um + q.qy_per_um * q.qy_per_um) *
                                         sigma_um * sigma_um / 2));
  };
}

}  // namespace

TEST_CASE("the albedo of a flat patch under a Gaussian window is the one in the tables",
          "[albedo][oracle]") {
  // Computed outside this project, sigma_s = 16.25 um, 550 nm; printed to six decimals.
  const brdf::HeightField field = flat(4, 1);
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(16.25)),
                              SurfaceModel::periodic};
  const Given amplitude(gaussian_lobe(16.25));
  const std::pair<double, double> cases[] = {
      {0, 1.000014}, {30, 1.000021}, {60, 1.000102}, {75, 1.001002}, {85, 0.898572}};
  const AlbedoQuadrature quadrature(surface, Length::nm(550));
  for (const auto& [theta, expected] : cases) {
    const evaluation::DirectionalAlbedo found = quadrature.integrate(
        brdf::direction(Angle::deg(theta), Angle::deg(37)), amplitude, optics_of(surface), {});
    INFO(theta << " deg, " << found.directions << " directions");
    CHECK(std::abs(found.value - expected) <= 6e-7);
    CHECK(found.is_physical() == (theta != 75));
  }
}

TEST_CASE("the albedo of an isolated flat patch is that of a grid in polar angles",
          "[albedo][oracle]") {
  // 65 um in pixels of 0.1 um over the whole hemisphere, computed in another language on a grid
  // that moved by 1e-6 when refined (as in gain.tests.cpp).
  const brdf::HeightField field = flat(650, 0.1);
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(16.25)),
                              SurfaceModel::isolated};
  const AlbedoQuadrature quadrature(surface, Length::nm(550));
  const std::vector<brdf::Direction> lights{brdf::direction(Angle::deg(60), Angle{}),
                                            brdf::direction(Angle::deg(85), Angle{})};
  const auto plan =
      evaluation::method_named("chebyshev").plan(surface, quadrature.bounds(lights, 1e-9), {});
  for (const auto& [theta, expected] : {std::pair(60.0, 1.000151), std::pair(85.0, 0.884207)}) {
    const auto found = quadrature.integrate(brdf::direction(Angle::deg(theta), Angle{}), *plan,
                                            optics_of(surface), {.threads = 2});
    INFO(theta << " deg: " << found.value);
    CHECK(std::abs(found.value - expected) <= 2e-6);
    CHECK(found.error_bound <= 1e-5);
  }
}

TEST_CASE("the albedo of lobes in many directions equals an integral line by line",
          "[albedo][oracle][long]") {
  // A patch of few wavelengths, so that the other rule is quick; its lobes reach the horizon.
  const double sigma_um = 1.5, lambda_um = 0.6;
  const brdf::HeightField field = flat(40, 0.25);
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(sigma_um)),
                              SurfaceModel::periodic};
  const double k = 2 * brdf::pi / lambda_um;
  const auto along_x = [&](double u) {
    const auto lobe = [&](double centre) {
      return std::exp(-std::pow(k * sigma_um * (u - centre), 2) / 2);
    };
    return 0.8 * lobe(0) + 0.5 * lobe(0.4) + 0.3 * lobe(0.95);
  };
  const auto along_y = [&](double v) { return std::exp(-std::pow(k * sigma_um * v, 2) / 2); };
  const Given amplitude([&](const brdf::Query& q) {
    // A query is k (-omega_i - omega_r); the other rule counts u along omega_i + omega_r.
    return std::complex<double>(along_x(-q.qx_per_um / k) * along_y(-q.qy_per_um / k));
  });
  const AlbedoQuadrature quadrature(surface, Length::um(lambda_um));
  for (const double theta : {0.0, 20.0, 65.0}) {
    const brdf::Direction light = brdf::direction(Angle::deg(theta), Angle{});
    const double found = quadrature.integrate(light, amplitude, optics_of(surface), {}).value;
    const double expected =
        albedo_of_separable(light, along_x, along_y, [&](const brdf::Direction& viewer) {
          return brdf::brdf_gain(light, viewer, Length::um(lambda_um), coherence_area_um2(surface));
        });
    INFO(theta << " deg: " << found << " against " << expected);
    // The lines' rule is the coarser: midpoints across a rim where 1 / cos ends.
    CHECK(std::abs(found - expected) <= 2e-5 * expected);
  }
}

TEST_CASE("an error of the amplitude moves the albedo by no more than its bound", "[albedo]") {
  const brdf::HeightField field = flat(4, 1);
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(3)), SurfaceModel::periodic};
  const brdf::Direction light = brdf::direction(Angle::deg(40), Angle{});
  const AlbedoQuadrature quadrature(surface, Length::nm(500));
  const auto lobe = gaussian_lobe(3);
  const double exact = quadrature.integrate(light, Given(lobe), optics_of(surface), {}).value;
  for (const double error : {1e-2, 1e-4, 1e-9}) {
    // In phase with the amplitude everywhere.
    const Given off([&](const brdf::Query& q) { return lobe(q) + error; }, error);
    const auto found = quadrature.integrate(light, off, optics_of(surface), {});
    INFO(error);
    CHECK(found.value > exact);
    CHECK(found.value - exact <= found.error_bound);
  }
}

TEST_CASE("the albedo is the same for any number of threads", "[albedo]") {
  const brdf::HeightField field = sampled(
      24, 24, 0.1, 0.1, [](double x, double y) { return 0.1 * std::sin(9 * x) * std::cos(5 * y); });
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(0.6)),
                              SurfaceModel::isolated};
  const brdf::Direction light = brdf::direction(Angle::deg(30), Angle{});
  const AlbedoQuadrature quadrature(surface, Length::nm(500));
  const auto plan =
      evaluation::method_named("direct").plan(surface, quadrature.bounds({&light, 1}, 1e-9), {});
  const double one = quadrature.integrate(light, *plan, optics_of(surface), {.threads = 1}).value;
  CHECK(one > 0.5);
  CHECK(one == quadrature.integrate(light, *plan, optics_of(surface), {.threads = 5}).value);
}

TEST_CASE("one box holds the queries of all lights and views, and nothing more",
          "[albedo][invariant]") {
  const brdf::HeightField field = flat(4, 1);
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(1)), SurfaceModel::isolated};
  const Length wavelength = Length::nm(500);
  const AlbedoQuadrature quadrature(surface, wavelength);
  std::vector<brdf::Direction> lights;
  for (const double theta : {-70.0, 0.0, 20.0, 85.0})
    lights.push_back(brdf::direction(Angle::deg(theta), Angle::deg(33)));
  const brdf::QueryBounds bounds = quadrature.bounds(lights, 1e-6);
  CHECK(bounds.count == 4 * quadrature.directions());
  std::vector<brdf::Query> queries;
  for (const brdf::Direction& light : lights)
    for (int phi = 0; phi < 360; phi += 2)
      for (const double theta : {0.0, 45.0, 90 - 1e-6})
        queries.push_back(
            brdf::query(light, brdf::direction(Angle::deg(theta), Angle::deg(phi)), wavelength));
  for (const brdf::Query& query : queries) CHECK(bounds.hold(query));
  // The views 2 deg apart miss the outermost by at most k (1 - cos 1 deg) = 1.5e-4 k.
  const brdf::QueryBounds tight = brdf::bounds_of(queries, 1e-6);
  const double near = 2e-4 * 2 * brdf::pi / 0.5;
  CHECK(std::abs(bounds.lo.qx_per_um - tight.lo.qx_per_um) <= near);
  CHECK(std::abs(bounds.hi.qx_per_um - tight.hi.qx_per_um) <= near);
  CHECK(std::abs(bounds.lo.qy_per_um - tight.lo.qy_per_um) <= near);
  CHECK(std::abs(bounds.hi.qy_per_um - tight.hi.qy_per_um) <= near);
  CHECK(std::abs(bounds.lo.c_per_um - tight.lo.c_per_um) <= near);
  CHECK(std::abs(bounds.hi.c_per_um - tight.hi.c_per_um) <= near);
}

TEST_CASE("a surface too wide for its albedo is refused before memory is taken", "[albedo]") {
  const brdf::HeightField field = flat(100, 0.5);
  const brdf::Surface surface{&field,
                              brdf::GaussianWindow(Length::um(5)),
                              SurfaceModel::replicated,
                              brdf::Origin::patch_centre,
                              {1000, 1000}};
  CHECK_ERROR(AlbedoQuadrature(surface, Length::nm(500)), brdf::Errc::over_limit, "1e9");
}
