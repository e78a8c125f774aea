#include "brdf/spectral_integral.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "brdf/direct_sum.h"
#include "brdf/synthetic_surface.h"
#include "tests/support/is_error.h"
#include "tests/support/worst_error.h"

namespace {

using brdf::AdaptiveIntegral;
using brdf::BandIntegral;
using brdf::Length;
using brdf::SpectralBand;
using brdf::SpectralNode;
using brdf::SurfaceModel;
using brdf::Xyz;
using Eigen::Vector3d;

/// Ten periods of 1.3 um, 13 um long.
struct Grating {
  brdf::HeightField field =
      brdf::synthetic_grating({brdf::Profile::sinusoid, Length::nm(1300), Length::nm(180)}, 3, 260,
                              Length::nm(50), Length::nm(1000));
  brdf::Surface surface;

  explicit Grating(SurfaceModel model)
      : surface{&field, brdf::GaussianWindow(Length::um(3)), model} {}

  /// The colour of the power at a scattering vector.
  template <class Nodes>
  Xyz colour(const Nodes& nodes, const Vector3d& s) const {
    std::vector<brdf::Query> queries;
    for (const SpectralNode& node : nodes) {
      const double k = wavenumber_per_um(node.wavelength);
      queries.push_back({k * s.x(), k * s.y(), k * s.z()});
    }
    if (queries.empty()) return {};
    std::vector<std::complex<double>> amplitudes(queries.size());
    brdf::DirectSum{}.plan(surface, bounds_of(queries, 1e-9)).evaluate(queries, amplitudes);
    Xyz sum;
    for (std::size_t i = 0; i < queries.size(); ++i)
      sum = sum + std::norm(amplitudes[i]) * nodes[i].weight;
    return sum;
  }
};

/// Steps of 0.1 nm: 0.02 rad of phase in the fastest spectrum below.
brdf::StepIntegral fine_steps() {
  std::vector<Length> wavelengths;
  for (int i = 0; i <= 4000; ++i) wavelengths.push_back(Length::nm(380 + 0.1 * i));
  return brdf::StepIntegral(wavelengths);
}

double difference(const Xyz& a, const Xyz& b) {
  WorstError worst;
  for (const double error : {a.x - b.x, a.y - b.y, a.z - b.z}) worst.see(std::abs(error));
  return worst.value();
}

std::vector<Vector3d> scattering() {
  std::vector<Vector3d> all{{0, 0, -2}, {0.01, 0.02, -1.9}};
  for (const double u : {-0.1, 0.27, 0.41, -0.6, 0.9, 1.4, -1.9})
    for (const double v : {0.0, 0.05}) all.emplace_back(u, v, -std::sqrt(3.9 - u * u - v * v));
  return all;
}

}  // namespace

TEST_CASE("wavelengths of one's own are weighed as a spectrum is, for every direction",
          "[spectral_integral]") {
  std::vector<Length> wavelengths;
  for (const double nm : {360.0, 380.0, 400.0, 470.0, 555.0, 600.0, 700.0, 830.0, 900.0, 1000.0})
    wavelengths.push_back(Length::nm(nm));
  const auto weights = brdf::colour_weights(wavelengths);
  const brdf::StepIntegral integral(wavelengths);
  std::size_t j = 0;
  const auto nodes = integral.nodes({0.1, 0.2, -1});
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] == Xyz{}) continue;  // what the eye does not see is not computed
    REQUIRE(j < nodes.size());
    CHECK(nodes[j].wavelength == wavelengths[i]);
    CHECK(nodes[j].weight == weights[i]);
    ++j;
  }
  CHECK(j == nodes.size());
  CHECK(j < wavelengths.size());
  CHECK(integral.largest_count() == j);
  CHECK(integral.nodes({0, 0, -2}).data() == nodes.data());
}

TEST_CASE("the wavelengths of a direction grow with its phase, up to the largest count",
          "[spectral_integral]") {
  const brdf::InterferenceReach reach{40, 0.5};
  const double farthest_rad = reach.phase_rad({2, 0, -2}, {});
  const AdaptiveIntegral integral({}, reach, 1e-3, farthest_rad);
  std::size_t last = 0;
  for (int i = 0; i <= 200; ++i) {
    const std::size_t count = integral.nodes({0.01 * i, 0, -0.01 * i}).size();
    CHECK(count >= last);
    CHECK(count <= integral.largest_count());
    last = count;
  }
  CHECK(last == integral.largest_count());
  // Steps fewer than x / pi would take an oscillation within the range for the mean.
  CHECK(static_cast<double>(last) >= farthest_rad / brdf::pi);
}

TEST_CASE("the adaptive integral is within its tolerance with fewer wavelengths",
          "[spectral_integral][oracle][long]") {
  const auto reference = fine_steps();
  for (const auto model : {SurfaceModel::isolated, SurfaceModel::periodic}) {
    const Grating grating(model);
    for (const double tolerance : {1e-2, 1e-4}) {
      const auto reach = interference_reach(grating.surface, tolerance);
      const AdaptiveIntegral integral({}, reach, tolerance,
                                      reach.phase_rad({2, 0, -2}, SpectralBand{}));
      CHECK(integral.nodes({0, 0, -2}).size() < 25);
      CHECK(integral.nodes({1.9, 0, -0.5}).size() > 2 * integral.nodes({0.1, 0, -2}).size());
      for (const Vector3d& s : scattering()) {
        CAPTURE(tolerance, s.transpose());
        CHECK(difference(grating.colour(integral.nodes(s), s),
                         grating.colour(reference.nodes(s), s)) <= tolerance);
      }
    }
  }
}

TEST_CASE("the bands of the orders hold all light of a periodic grating",
          "[spectral_integral][oracle]") {
  const Grating grating(SurfaceModel::periodic);
  const auto reference = fine_steps();
  const BandIntegral bands({}, brdf::OrderBands(grating.surface, {Length::nm(1300)}, 4));
  std::size_t seen = 0, all = 0;
  for (const Vector3d& s : scattering()) {
    CAPTURE(s.transpose());
    const auto nodes = bands.nodes(s);
    // 1e-3 of the white: steps of sigma_f leave 1e-4 of a lobe, the ends of the visible the rest.
    CHECK(difference(grating.colour(nodes, s), grating.colour(reference.nodes(s), s)) <= 1e-3);
    CHECK(nodes.size() <= bands.largest_count());
    seen += nodes.size();
    all += reference.nodes(s).size();
  }
  CHECK(seen > 0);
  CHECK(seen < all / 20);
  CHECK(bands.nodes({0.4, 0.3, -1.5}).empty());  // out of the plane of the orders
}

TEST_CASE("bands that overlap count once, each with its measure", "[spectral_integral]") {
  const Grating grating(SurfaceModel::periodic);
  // Orders of 1.3 um are 14.5 sigma_f apart, 1 / (2 pi 3 um): at 12 each band overlaps the next,
  // and no wavelength may come twice.
  for (const double radius : {12.0, 100.0}) {
    const BandIntegral wide({}, brdf::OrderBands(grating.surface, {Length::nm(1300)}, radius));
    const auto nodes = wide.nodes({0.9, 0, -1});
    CHECK(nodes.size() > 10);
    for (std::size_t i = 1; i < nodes.size(); ++i)
      CHECK(nodes[i].wavelength < nodes[i - 1].wavelength);
  }
  // A radius of 100 sigma_f covers everything: rho = 1 is white, to 2e-3 of the steps' ends.
  const BandIntegral all({}, brdf::OrderBands(grating.surface, {Length::nm(1300)}, 100));
  for (const double u : {0.05, 0.5, 1.5}) {
    Xyz white;
    for (const SpectralNode& node : all.nodes({u, 0, -1})) white = white + node.weight;
    CHECK(std::abs(white.y - 1) <= 2e-3);
  }
}

TEST_CASE("interference reaches as far as window and surface let it", "[spectral_integral]") {
  // k_half (5 um + 1.5 um) for abs(u, v) = 0.5, w = -1.5.
  CHECK(brdf::InterferenceReach{10, 1}.phase_rad({0.3, -0.4, -1.5}, SpectralBand{}) ==
        Approx((2 * brdf::pi / 0.38 - 2 * brdf::pi / 0.78) / 2 * 6.5));
  const double window_um = 2 * 3 * std::sqrt(std::log(1e3));
  CHECK(interference_reach(Grating(SurfaceModel::periodic).surface, 1e-3).lateral_um ==
        Approx(window_um));
  Grating grating(SurfaceModel::isolated);
  CHECK(interference_reach(grating.surface, 1e-9).lateral_um ==
        Approx(std::hypot(260 * 0.05, grating.field.height_um())));
  // 26 samples of a period miss its crests by less than 1 %.
  CHECK(interference_reach(grating.surface, 1e-9).vertical_um == Approx(0.18).epsilon(1e-2));
  grating.surface.model = SurfaceModel::replicated;
  grating.surface.replicas = {3, 1};
  CHECK(interference_reach(grating.surface, 1e-3).lateral_um ==
        Approx(std::hypot(3 * 260 * 0.05, grating.field.height_um())));
}

TEST_CASE("a spectrum that oscillates without end is refused", "[spectral_integral]") {
  const auto integral = [](double farthest_rad) {
    return AdaptiveIntegral({}, {1e4, 1}, 1e-2, farthest_rad);
  };
  CHECK_ERROR(integral(1e5), brdf::Errc::invalid_argument, "--lambda");
  CHECK_ERROR(integral(AdaptiveIntegral::most_rad * (1 + 1e-12)), brdf::Errc::invalid_argument,
              "--lambda");
  CHECK_ERROR(integral(std::nan("")), brdf::Errc::invalid_argument, "--lambda");
  CHECK_NOTHROW(integral(AdaptiveIntegral::most_rad));
  CHECK_ERROR(BandIntegral(
                  {Length::nm(900), Length::nm(1000)},
                  brdf::OrderBands(Grating(SurfaceModel::periodic).surface, {Length::nm(1300)}, 4)),
              brdf::Errc::invalid_argument, "nm");
}
