#include "evaluation/advice/advice.h"

#include <catch2/catch.hpp>

#include "tests/support/is_error.h"
#include "tests/support/surfaces.h"

using brdf::Angle;
using brdf::Length;
using evaluation::AdviceScene;
using evaluation::OpticsReason;
using evaluation::OpticsVerdict;

namespace {

AdviceScene scene_of(const brdf::HeightField& field, double sigma_um, double theta_i_deg) {
  return {{&field, brdf::GaussianWindow(Length::um(sigma_um)), brdf::SurfaceModel::periodic},
          {Angle::deg(theta_i_deg), {}, {}, {{500}}, {{-80, -60, -40, -20, 0, 20, 40, 60, 80}}},
          evaluation::AxisOrigin::asked,
          evaluation::AxisOrigin::asked,
          1e-6,
          Angle::deg(1)};
}

brdf::HeightField wave(double period_um, double depth_um, double azimuth_deg) {
  const double phi = Angle::deg(azimuth_deg).rad();
  return sampled(200, 300, 0.1, 0.1, [&](double x, double y) {
    return depth_um / 2 *
           std::cos(2 * brdf::pi * (x * std::cos(phi) + y * std::sin(phi)) / period_um);
  });
}

}  // namespace

TEST_CASE("orders leave the plane of incidence as the grating equation in two dimensions says",
          "[advice]") {
  const auto field = wave(2, 0.1, 30);
  const auto orders =
      evaluation::advise_orders(scene_of(field, 10, 20), evaluation::measured(field));
  REQUIRE(!orders.cases.empty());
  for (const auto& order : orders.cases[0].nearest) {
    // m lambda / d (cos 30, sin 30) - (sin 20, 0); the period is read to 1e-3.
    const double along =
        order.order * 0.25 * std::cos(Angle::deg(30).rad()) - std::sin(Angle::deg(20).rad());
    const double across = order.order * 0.25 * 0.5;
    INFO("order " << order.order);
    CHECK(std::sin(order.out_of_plane.rad()) == Approx(across).margin(2e-3));
    CHECK(std::sin(order.theta_r.rad()) * std::cos(order.out_of_plane.rad()) ==
          Approx(along).margin(2e-3));
  }
}

TEST_CASE("crosswise orders are apart by lambda / d, in the plane by 1 / cos more", "[advice]") {
  const auto along = wave(2, 0.1, 0), across = wave(2, 0.1, 90);
  const auto spacing = [](const brdf::HeightField& field) {
    return evaluation::advise_optics(scene_of(field, 10, 60), evaluation::measured(field))
        .spacing.rad();
  };
  CHECK(spacing(along) == Approx(0.25 / 0.5).epsilon(2e-3));
  CHECK(spacing(across) == Approx(0.25).epsilon(2e-3));
}

TEST_CASE("the heights matter from the tolerance's phase on", "[advice][crossover]") {
  // k |w| depth / 2 with |w| = 2: 25.1 x depth / 2 = 1e-6 at 8e-8 um.
  const auto verdict = [](double depth_um) {
    const auto field = wave(2, depth_um, 0);
    return evaluation::advise_optics(scene_of(field, 10, 0), evaluation::measured(field)).verdict;
  };
  CHECK(verdict(7.8e-8) == OpticsVerdict::mirror);
  CHECK(verdict(8.1e-8) == OpticsVerdict::diffraction);
}

TEST_CASE("rays need half a turn of phase", "[advice][crossover]") {
  // Orders 0.025 apart under a lobe of 0.066. k |w| depth = pi at 0.125 um; but the facets must
  // spread further than the lobe, too: RMS slope above 0.014.
  const auto reason = [](double depth_um) {
    const auto field = wave(10, depth_um, 0);
    return evaluation::advise_optics(scene_of(field, 2, 0), evaluation::measured(field)).reason;
  };
  CHECK(reason(0.130) == OpticsReason::deep);
  CHECK(reason(0.122) == OpticsReason::shallow);
}

TEST_CASE("coherence lengths are lambda over the width of the lobe", "[advice]") {
  const auto field = wave(2, 0.1, 0);
  const AdviceScene scene = scene_of(field, 3, 0);
  const double expected = brdf::pi * 3 / std::sqrt(std::log(2.0));
  for (const double azimuth : {0.0, 40.0, 90.0}) {
    CHECK(evaluation::coherence_length_um(scene.surface, Angle::deg(azimuth)) == Approx(expected));
    CHECK(evaluation::lobe_width_sine(scene.surface, Angle::deg(azimuth), 0.5) ==
          Approx(0.5 / expected));
  }
}

TEST_CASE("steps are rounded down to 1, 2 or 5 of their decade", "[advice]") {
  const std::pair<double, double> expected[]{{0.132, 0.1}, {0.2, 0.2},   {0.4999, 0.2},
                                             {0.5, 0.5},   {0.99, 0.5},  {1, 1},
                                             {7, 5},       {0.03, 0.02}, {1000, 1000}};
  for (const auto& [value, rounded] : expected)
    CHECK(evaluation::rounded_down(value) == Approx(rounded));
}

TEST_CASE("a plane that is most of the range is a tilt, however wide the lobe", "[advice]") {
  const auto rising = [](double slope) {
    return sampled(1, 300, 0.1, 0.1, [&](double x, double) {
      return 0.05 * std::cos(2 * brdf::pi * x / 2) + slope * x;
    });
  };
  // A lobe of 15 deg (sigma 0.5 um) against 2 x 0.17 deg; the plane rises 0.09 um over 30 um,
  // beside 0.1 um of the wave; 0.12 um is more than half of the sum.
  const auto verdict = [](const brdf::HeightField& field) {
    return evaluation::advise_tilt(scene_of(field, 0.5, 0)).verdict;
  };
  CHECK(verdict(rising(0.003)) == evaluation::TiltVerdict::level);
  CHECK(verdict(rising(0.004)) == evaluation::TiltVerdict::tilted);
}

TEST_CASE("advice on a scene without meaning is refused", "[advice]") {
  const auto field = wave(2, 0.1, 0);
  AdviceScene scene = scene_of(field, 10, 0);
  scene.tolerance = std::numeric_limits<double>::quiet_NaN();
  CHECK_ERROR(evaluation::advise(scene), brdf::Errc::invalid_argument, "tolerance");
  scene = scene_of(field, 10, 90);
  CHECK_ERROR(evaluation::advise(scene), brdf::Errc::invalid_argument, "incidence");
}
