#include <cmath>

#include "evaluation/self_check/checker.h"

namespace evaluation::self {
namespace {

using brdf::HeightField;
using brdf::Length;
using brdf::pi;
using brdf::Query;
using brdf::Surface;
using brdf::SurfaceModel;

constexpr const char* of_amplitude = "the tolerance asked for, 1e-10";
constexpr const char* of_power = "twice the tolerance asked for, abs(a) being at most 1";

std::string where(const Surface& surface, const std::string& at) {
  return std::string(name_of(surface.model)) + ", " + at;
}

/// sin(n x) / (n sin x), 1 at multiples of pi with n x.
double dirichlet(int n, double x) {
  return std::abs(std::sin(x)) < 1e-14 ? 1 : std::sin(n * x) / (n * std::sin(x));
}

/// a = exp(-k^2 sigma^2 (u^2 + v^2) / 2).
CheckRow flat_patch(const Method& method) {
  CheckTally found = tally("flat patch: Gaussian lobe", method, of_amplitude);
  const HeightField field(brdf::HeightArray::Constant(12, 16, 0), Length::um(0.2),
                          Length::um(0.25));
  const Surface surface{&field, brdf::GaussianWindow(Length::um(1.3)), SurfaceModel::periodic};
  std::vector<Query> queries;
  for (const double q : {0.0, 0.2, 0.7, 1.5, 3.0}) {
    queries.push_back({q, 0, -20});
    queries.push_back({-q, 0.4, -15});
  }
  const Amplitudes a = amplitudes(method, surface, queries);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double radius2 =
        queries[i].qx_per_um * queries[i].qx_per_um + queries[i].qy_per_um * queries[i].qy_per_um;
    found.see(std::abs(a[i] - std::exp(-1.3 * 1.3 * radius2 / 2)), tolerance,
              "k u = " + brdf::text(queries[i].qx_per_um));
  }
  return found.row();
}

/// power: of an order, from its number and the phase depth c H.
template <class Power>
CheckRow orders(const char* check, const Method& method, const HeightField& field, Power power) {
  CheckTally found = tally(check, method, of_power);
  for (const double depth_rad : {0.5, 2.0, 4.7, 9.0})
    for (const Surface& surface : tiles(method, field)) {
      const double c_per_um = -depth_rad / (2 * field.half_range_um());
      std::vector<Query> queries;
      for (int order = -5; order <= 5; ++order)
        queries.push_back(at_cycles(field, order, 0, c_per_um));
      const Amplitudes a = amplitudes(method, surface, queries);
      for (std::size_t i = 0; i < a.size(); ++i) {
        const int order = static_cast<int>(i) - 5;
        found.see(
            std::abs(std::norm(a[i]) - power(order, depth_rad)), 2 * tolerance,
            where(surface, "order " + std::to_string(order) + ", c H = " + brdf::text(depth_rad)));
      }
    }
  return found.row();
}

CheckRow sinusoid(const Method& method) {
  const HeightField field = one_period(
      {.profile = brdf::Profile::sinusoid, .period = Length::um(2.5), .height = Length::um(0.3)},
      64);
  return orders("orders of a sinusoid: J_m(c H / 2)^2", method, field,
                [](int order, double depth_rad) {
                  const double j = std::cyl_bessel_j(std::abs(order), depth_rad / 2);
                  return j * j;
                });
}

/// n samples falling by H / n each: a geometric series in the phase c H / n + 2 pi m / n.
CheckRow blaze(const Method& method) {
  constexpr int n = 50;
  const HeightField field = one_period(
      {.profile = brdf::Profile::blazed, .period = Length::um(2.5), .height = Length::um(0.3)}, n);
  // From 0 to H (1 - 1/n): the range of the heights is not H.
  return orders("orders of a sawtooth: sampled sinc^2", method, field,
                [](int order, double depth_rad) {
                  const double step_rad = depth_rad / (n - 1);
                  const double sum = dirichlet(n, (step_rad + 2 * pi * order / n) / 2);
                  return sum * sum;
                });
}

CheckRow lamellar(const Method& method) {
  constexpr int n = 40, high = 12;
  const HeightField field = one_period({.profile = brdf::Profile::lamellar,
                                        .period = Length::um(2.5),
                                        .height = Length::um(0.3),
                                        .duty = static_cast<double>(high) / n},
                                       n);
  return orders("orders of a lamellar grating", method, field, [](int order, double depth_rad) {
    const double duty = static_cast<double>(high) / n;
    if (order == 0) return std::norm(1 - duty + duty * std::polar(1.0, depth_rad));
    const double step = 2 * std::sin(depth_rad / 2);
    const double slit = duty * dirichlet(high, pi * order / n);
    return step * step * slit * slit;
  });
}

/// N evenly lit copies of a flat tile are one wide one.
CheckRow slits(const Method& method) {
  CheckTally found = tally("slits: sin(N x) / (N sin x)", method, of_amplitude);
  constexpr int pixels = 6, copies = 5;
  const HeightField field(brdf::HeightArray::Constant(1, pixels, 0), Length::um(0.3),
                          Length::um(1));
  const Surface surface{&field, brdf::GaussianWindow(Length::um(1)), SurfaceModel::replicated,
                        brdf::Origin::patch_centre, brdf::Replicas{copies, 1}};
  std::vector<Query> queries;
  for (double q = -4; q <= 4; q += 0.37) queries.push_back({q, 0, -20});
  const Amplitudes a = amplitudes(method, surface, queries);
  for (std::size_t i = 0; i < a.size(); ++i)
    found.see(std::abs(a[i] - dirichlet(pixels * copies, queries[i].qx_per_um * 0.3 / 2)),
              tolerance, "k u = " + brdf::text(queries[i].qx_per_um));
  return found.row();
}

}  // namespace

std::vector<CheckRow> closed_form_rows(const Method& method) {
  std::vector<CheckRow> rows;
  if (has(method, SurfaceModel::periodic)) rows.push_back(flat_patch(method));
  rows.push_back(sinusoid(method));
  rows.push_back(blaze(method));
  rows.push_back(lamellar(method));
  if (has(method, SurfaceModel::replicated)) rows.push_back(slits(method));
  return rows;
}

}  // namespace evaluation::self
