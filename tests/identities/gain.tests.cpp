// From P to the BRDF, the radiance and the relative reflectance.
#include "brdf/gain.h"

#include <catch2/catch.hpp>
#include <limits>

#include "brdf/direct_sum.h"
#include "tests/support/amplitudes.h"
#include "tests/support/exact_sums.h"
#include "tests/support/figure.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"

using brdf::Angle;
using brdf::Direction;
using brdf::direction;
using brdf::HeightField;
using brdf::Length;
using brdf::Surface;
using exact::pi;
using exact::Real;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double sigma_um = 0.5;
const Length lambda = Length::nm(550);

Direction in_plane(double theta_deg) {
  return direction(Angle::deg(theta_deg), {});
}

/// 1 + omega_i . omega_r and |w|, in long double.
struct Geometry {
  Real projection, w;
  Geometry(const Direction& light, const Direction& viewer)
      : projection(1 + light.cast<Real>().dot(viewer.cast<Real>())),
        w(static_cast<Real>(light.z()) + viewer.z()) {}
};

/// A random patch under a window, seen from random directions.
struct Patch {
  Uniform uniform;
  HeightField field = random_heights(uniform, {8, 10, 0.1, 0.12}, 0, 0.4);
  Surface surface{&field, brdf::GaussianWindow(Length::um(sigma_um)), brdf::SurfaceModel::isolated};

  explicit Patch(std::uint64_t seed) : uniform(seed) {}
  exact::Transform transform(const Direction& light, const Direction& viewer) const {
    const brdf::Query q = query(light, viewer, lambda);
    return exact::transform(field, q, exact::gaussian(sigma_um), exact::phase(q.c_per_um));
  }
  double power(const Direction& light, const Direction& viewer) const {
    return std::norm(amplitude(brdf::DirectSum{}, surface, query(light, viewer, lambda)));
  }
};

/// Stam; Thesis 1.4: f_r = k^2 F^2 G |P|^2 / (4 pi^2 A w^2) with F = 1.
Real brdf_of(const exact::Transform& sums, const Direction& light, const Direction& viewer) {
  const Geometry at(light, viewer);
  const Real k = 2 * pi / static_cast<Real>(lambda.um());
  const Real g = at.projection * at.projection / (static_cast<Real>(light.z()) * viewer.z());
  return k * k * g * std::norm(sums.p) / (4 * pi * pi * sums.g_squared * at.w * at.w);
}

/// Thesis 1.5, 1.10: L / I = F^2 (1 + omega_i . omega_r)^2 |P|^2 / (lambda^2 A w^2 cos theta_r).
Real radiance_of(const exact::Transform& sums, const Direction& light, const Direction& viewer) {
  const Geometry at(light, viewer);
  const Real lambda_um = lambda.um();
  return at.projection * at.projection * std::norm(sums.p) /
         (lambda_um * lambda_um * sums.g_squared * at.w * at.w * viewer.z());
}

/// Worst difference of code and formula over random directions, relative to what the code gives
/// for the peak of a flat patch.
template <class Code, class Formula>
double worst_of_random_directions(Patch& patch, Code gain, Formula formula) {
  WorstError error;
  for (int i = 0; i < 300; ++i) {
    const Direction light = random_direction(patch.uniform, 85),
                    viewer = random_direction(patch.uniform, 85);
    const double g = gain(light, viewer);
    const auto expected = static_cast<double>(formula(light, viewer));
    error.see(std::abs(g * patch.power(light, viewer) - expected) / g);
  }
  return error.value();
}

// Amplitudes right to 1e-15, with phases of a few radians; squares and the gain's few products.
constexpr double rounding = 4e-15;

}  // namespace

TEST_CASE("Thesis 1.4: the BRDF is k^2 F^2 G |P|^2 / (4 pi^2 A w^2)", "[identity][oracle]") {
  Patch patch(311);
  const double area_um2 = brdf::coherence_area_um2(patch.surface);
  const double error = worst_of_random_directions(
      patch,
      [&](const Direction& light, const Direction& viewer) {
        return brdf::brdf_gain(light, viewer, lambda, area_um2);
      },
      [&](const Direction& light, const Direction& viewer) {
        return brdf_of(patch.transform(light, viewer), light, viewer);
      });
  CHECK(figure("Thesis 1.4", "BRDF, of a flat patch's peak", error) <= rounding);
}

TEST_CASE(
    "Thesis 1.5, 1.10: L / I = (1 + omega_i . omega_r)^2 |P|^2 / (lambda^2 A w^2 cos theta_r)",
    "[identity][oracle]") {
  Patch patch(312);
  const double area_um2 = brdf::coherence_area_um2(patch.surface);
  const double error = worst_of_random_directions(
      patch,
      [&](const Direction& light, const Direction& viewer) {
        return brdf::radiance_gain(light, viewer, lambda, area_um2);
      },
      [&](const Direction& light, const Direction& viewer) {
        return radiance_of(patch.transform(light, viewer), light, viewer);
      });
  CHECK(figure("Thesis 1.5, 1.10", "radiance, of a flat patch's peak", error) <= rounding);
  WorstError of_brdf;
  for (int i = 0; i < 1000; ++i) {
    const Direction a = random_direction(patch.uniform), b = random_direction(patch.uniform);
    of_brdf.see(std::abs(brdf::radiance_gain(a, b, lambda, area_um2) /
                             (brdf::brdf_gain(a, b, lambda, area_um2) * a.z()) -
                         1));
  }
  CHECK(figure("Thesis 1.5, 1.10", "L / I against f_r cos theta_i, relative", of_brdf.value()) <=
        8 * eps);  // the same product in another order
}

TEST_CASE("Thesis 1.13-1.16: rho is the radiance over that of a flat patch lit along its normal",
          "[identity][oracle]") {
  Patch patch(313);
  const HeightField flat(brdf::HeightArray::Zero(8, 10), Length::um(0.1), Length::um(0.12));
  const Direction normal = in_plane(0);
  const exact::Transform flat_sums =
      exact::transform(flat, {0, 0, 0}, exact::gaussian(sigma_um), exact::phase(0));
  const Real of_flat = radiance_of(flat_sums, normal, normal);
  const double error = worst_of_random_directions(
      patch, brdf::relative_gain, [&](const Direction& light, const Direction& viewer) {
        return radiance_of(patch.transform(light, viewer), light, viewer) / of_flat;
      });
  CHECK(figure("Thesis 1.13-1.16", "rho, of a flat patch's peak", error) <= rounding);
}

TEST_CASE("Thesis 1.13-1.16: rho of a flat patch is 1, cos theta and 1 over cos cubed",
          "[identity][oracle]") {
  CHECK(brdf::relative_gain(in_plane(0), in_plane(0)) == 1);
  WorstError error;
  for (const double theta_deg : {10.0, 45.0, 75.0, 85.0, 89.9}) {
    const Direction light = in_plane(theta_deg), mirror = in_plane(-theta_deg);
    const double cosine = light.z();
    error.see(std::abs(brdf::relative_gain(light, mirror) / cosine - 1));
    error.see(std::abs(brdf::relative_gain(light, light) * std::pow(cosine, 3) - 1));
  }
  CHECK(figure("Thesis 1.13-1.16", "cos theta and 1 / cos^3, relative", error.value()) <= 8 * eps);
}

TEST_CASE("reciprocity: f_r is the same with the directions swapped, the radiance is not",
          "[identity][invariant]") {
  Patch patch(314);
  const double area_um2 = brdf::coherence_area_um2(patch.surface);
  WorstError change, radiance;
  for (int i = 0; i < 1000; ++i) {
    const Direction a = random_direction(patch.uniform, 85),
                    b = random_direction(patch.uniform, 85);
    const auto f_r = [&](const Direction& light, const Direction& viewer) {
      return brdf::brdf_gain(light, viewer, lambda, area_um2) * patch.power(light, viewer);
    };
    change.see(std::abs(f_r(a, b) / f_r(b, a) - 1));
    // L(a, b) / L(b, a) = cos theta_a / cos theta_b.
    const double l = brdf::relative_gain(a, b) / brdf::relative_gain(b, a);
    radiance.see(std::abs(l * b.z() / a.z() - 1));
  }
  // Sums and products commute: the same query, to the last bit.
  CHECK(figure("reciprocity", "f_r, relative", change.value()) <= 4 * eps);
  CHECK(figure("reciprocity", "L cos theta_r / cos theta_i, relative", radiance.value()) <=
        4 * eps);
}

TEST_CASE("Erratum E25: 1 - k1 . k2 is to be squared", "[identity][erratum][E25]") {
  // k1 = -omega_i is the direction of travel. A flat patch lit along its normal would reflect half.
  const auto printed_drafts = [](const Direction& light, const Direction& viewer) {
    const Geometry at(light, viewer);
    return static_cast<double>(at.projection / (at.w * at.w * viewer.z()));
  };
  CHECK(figure("E25", "printed rho at normal incidence; right: 1",
               printed_drafts(in_plane(0), in_plane(0))) == 0.5);
  // In the mirror direction at 75 deg, where 1 + omega_i . omega_r = 2 cos^2.
  const double ratio = printed_drafts(in_plane(75), in_plane(-75)) /
                       brdf::relative_gain(in_plane(75), in_plane(-75));
  CHECK(figure("E25", "printed rho over ours, mirror at 75 deg", ratio) ==
        Approx(1 / (2 * std::pow(std::cos(brdf::pi * 75 / 180), 2))).epsilon(1e-13));
}
