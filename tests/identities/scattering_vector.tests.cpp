// The scattering vector: what it is, and the sign and the powers of w.
#include <catch2/catch.hpp>

#include "brdf/direct_sum.h"
#include "brdf/directions.h"
#include "tests/support/amplitudes.h"
#include "tests/support/exact_sums.h"
#include "tests/support/figure.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"

using brdf::Angle;
using brdf::Direction;
using brdf::DirectSum;
using brdf::HeightField;
using brdf::Length;
using brdf::pi;

TEST_CASE("Thesis 1.12: (u, v, w) . s is the path from a far lamp by s to a far eye",
          "[identity][oracle]") {
  constexpr std::uint64_t seed = 301;
  CAPTURE(seed);
  Uniform uniform(seed);
  using Vector = Eigen::Matrix<long double, 3, 1>;
  constexpr long double far_um = 1e9L;
  WorstError error;
  for (int i = 0; i < 1000; ++i) {
    const Direction light = random_direction(uniform), viewer = random_direction(uniform);
    const Vector s(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    const auto from = [&](const Direction& direction) {
      return (far_um * direction.cast<long double>().normalized() - s).norm() - far_um;
    };
    const auto path = static_cast<double>(from(light) + from(viewer));
    error.see(std::abs(path - brdf::scattering_vector(light, viewer).dot(s.cast<double>())));
  }
  // The waves are spheres of radius R: s^2 / R, 3e-9 um at most.
  CHECK(figure("Thesis 1.12", "path against (u, v, w) . s [um]", error.value()) <= 3e-9);
}

TEST_CASE("Thesis 1.12: a pixel's phase is k (u x + v y + w h)", "[identity][oracle]") {
  constexpr std::uint64_t seed = 302;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError error;
  for (int i = 0; i < 200; ++i) {
    const Direction light = random_direction(uniform), viewer = random_direction(uniform);
    const HeightField field = random_heights(uniform, {4, 5, 0.3, 0.4}, 0, 0.5);
    const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(0.5)),
                                brdf::SurfaceModel::isolated};
    const double k = brdf::wavenumber_per_um(Length::nm(550));
    const exact::Real u = -static_cast<exact::Real>(light.x()) - viewer.x(),
                      v = -static_cast<exact::Real>(light.y()) - viewer.y(),
                      w = -static_cast<exact::Real>(light.z()) - viewer.z();
    const brdf::Query q{static_cast<double>(k * u), static_cast<double>(k * v),
                        static_cast<double>(k * w)};
    const exact::Transform sums =
        exact::transform(field, q, exact::gaussian(0.5L), exact::phase(k * w));
    error.see(exact::difference(
        amplitude(DirectSum{}, surface, query(light, viewer, Length::nm(550))), sums.amplitude()));
  }
  // Phases of up to 35 rad, each right to 2^-53 of itself.
  CHECK(figure("Thesis 1.12", "amplitude of a random patch", error.value()) <= 2e-14);
}

TEST_CASE("Erratum E13: w = +1 turns the relief inside out", "[identity][erratum][E13]") {
  // A blaze falling in +x at phase depth 2 pi sends everything to order +1; with the other sign
  // of w, to order -1, as if it rose.
  const double height_um = 0.2, c = 2 * pi / height_um;
  const HeightField field =
      one_period({.period = Length::um(2.5), .height = Length::um(height_um)}, 100);
  const auto power = [&](int order, double w_sign) {
    brdf::Query q = order_query(order, 2.5, c);
    q.c_per_um = w_sign * c;
    return std::norm(amplitude(DirectSum{}, separate_lines(field), q));
  };
  CHECK(std::abs(power(1, -1) - 1) <= 1e-14);  // 100 pixels in phase
  CHECK(power(-1, -1) <= 1e-14);
  CHECK(std::abs(power(-1, 1) - 1) <= 1e-14);
  CHECK(figure("E13", "power of order +1 with w = +1; right: 1", power(1, 1)) <= 1e-14);
}

TEST_CASE("Erratum E13: dropping w changes the strength of every order but those where w = -1",
          "[identity][erratum][E13]") {
  // Order m of a sawtooth of height H has sinc^2(pi (m - C H / 2 pi)); light at 75 deg, H = 0.6 um.
  const double height_um = 0.6, period_um = 2.5;
  const HeightField field =
      one_period({.period = Length::um(period_um), .height = Length::um(height_um)}, 400);
  WorstError right, printed;
  for (int order = 1; order <= 4; ++order)
    for (const double lambda_nm : {400.0, 500.0, 600.0, 700.0}) {
      const double k = brdf::wavenumber_per_um(Length::nm(lambda_nm));
      const double sine = order * lambda_nm / 1e3 / period_um - std::sin(Angle::deg(75).rad());
      const brdf::Query q =
          query_in_plane(Angle::deg(75), Angle::rad(std::asin(sine)), Length::nm(lambda_nm));
      const double w = std::cos(Angle::deg(75).rad()) + std::sqrt(1 - sine * sine);
      const auto expected = [&](double c) {
        return std::norm(
            exact::sinc(exact::pi * order - static_cast<exact::Real>(c) * height_um / 2));
      };
      const auto power = [&](double c) {
        return std::norm(amplitude(DirectSum{}, separate_lines(field), {q.qx_per_um, 0, -c}));
      };
      right.see(std::abs(power(-q.c_per_um) - static_cast<double>(expected(k * w))));
      printed.see(std::abs(power(k) - static_cast<double>(expected(k * w))));
    }
  // With n = 400 samples a period an edge loses power (pi a / n)^2 / 3 of sinc^2(pi a): 1 / (3
  // n^2).
  CHECK(figure("E13", "power of an order, w from the directions", right.value()) <= 2.1e-6);
  CHECK(figure("E13", "power of an order, w = -1, off by", printed.value()) ==
        Approx(0.3675).epsilon(1e-3));  // from the closed form
}
