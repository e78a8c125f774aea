#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>

#include "brdf/gain.h"
#include "brdf/shadowing.h"
#include "evaluation/stability/groups.h"

namespace evaluation::stability {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

constexpr double lambda_um = 0.55, area_um2 = 4225;

struct DirectionPair {
  brdf::Direction omega_i, omega_r;
  std::string where;
};

/// The light from 1 to 1e-9 deg above the horizon; the viewer in the mirror direction, back at the
/// light, near both, beside it and overhead.
std::vector<DirectionPair> grazing_pairs() {
  using brdf::Angle;
  std::vector<DirectionPair> pairs;
  for (int decade = 0; decade >= -9; --decade) {
    const double above_deg = std::pow(10.0, decade);
    const auto at = [&](double elevation_deg, double phi_deg) {
      return brdf::direction(Angle::deg(90 - elevation_deg), Angle::deg(phi_deg));
    };
    const brdf::Direction light = at(above_deg, 20);
    const auto add = [&](const brdf::Direction& viewer, const char* name) {
      pairs.push_back(
          {light, viewer, "1e" + std::to_string(decade) + " deg above the horizon, " + name});
    };
    add(at(above_deg, 200), "mirror direction");
    add(at(above_deg * 3, 200), "above the mirror direction");
    add(at(above_deg, 200 + above_deg), "beside the mirror direction");
    add(at(above_deg, 200 + 1e-7), "1e-7 deg beside the mirror direction");
    add(light, "back at the light");
    add(at(above_deg * 2, 20), "above the light");
    add(at(above_deg, 110), "at 90 deg to the light");
    add(at(89, 75), "overhead");
    add(at(30, 200), "at 60 deg");
  }
  return pairs;
}

struct Wide {
  Real norm2;  // of omega_i + omega_r
  Real cos_i, cos_r;
  Real half() const { return norm2 / 2; }
  Real w2() const { return (cos_i + cos_r) * (cos_i + cos_r); }
};

Wide widened(const DirectionPair& pair) {
  Wide wide{0, pair.omega_i.z(), pair.omega_r.z()};
  for (int axis = 0; axis < 3; ++axis) {
    const Real sum = Real(pair.omega_i[axis]) + Real(pair.omega_r[axis]);
    wide.norm2 += sum * sum;
  }
  return wide;
}

CheckRow row(const char* subject, const std::function<double(const DirectionPair&)>& value,
             const std::function<Real(const Wide&)>& exact) {
  CheckTally tally(subject, "light 1 to 1e-9 deg above the horizon", "relative",
                   "some ten operations without cancellation round by 1.1e-16 each, with margin");
  for (const DirectionPair& pair : grazing_pairs()) {
    const Real expected = exact(widened(pair));
    tally.see(static_cast<double>(abs(Real(value(pair)) / expected - 1)), 1e-14, pair.where);
  }
  return tally.row();
}

}  // namespace

std::vector<CheckRow> grazing_rows() {
  const brdf::Length wavelength = brdf::Length::um(lambda_um);
  const Real per_lambda2 = Real(area_um2) / (Real(lambda_um) * Real(lambda_um));
  return {row(
              "(1 + omega_i.omega_r)^2",
              [](const DirectionPair& p) {
                const double projection = brdf::one_plus_cosine(p.omega_i, p.omega_r);
                return projection * projection;
              },
              [](const Wide& s) { return s.half() * s.half(); }),
          row(
              "relative gain",
              [](const DirectionPair& p) { return brdf::relative_gain(p.omega_i, p.omega_r); },
              [](const Wide& s) -> Real { return s.half() * s.half() / (s.w2() * s.cos_r); }),
          row(
              "BRDF gain",
              [&](const DirectionPair& p) {
                return brdf::brdf_gain(p.omega_i, p.omega_r, wavelength, area_um2);
              },
              [&](const Wide& s) -> Real {
                return s.half() * s.half() / (s.w2() * s.cos_i * s.cos_r) * per_lambda2;
              }),
          row(
              "radiance gain",
              [&](const DirectionPair& p) {
                return brdf::radiance_gain(p.omega_i, p.omega_r, wavelength, area_um2);
              },
              [&](const Wide& s) -> Real {
                return s.half() * s.half() / (s.w2() * s.cos_r) * per_lambda2;
              }),
          row(
              "V-cavity shadowing",
              [](const DirectionPair& p) { return brdf::v_cavity_shadowing(p.omega_i, p.omega_r); },
              [](const Wide& s) -> Real {
                const Real lower = s.cos_i < s.cos_r ? s.cos_i : s.cos_r;
                const Real shadow = 4 * (s.cos_i + s.cos_r) * lower / s.norm2;
                return shadow < 1 ? shadow : Real(1);
              })};
}

}  // namespace evaluation::stability
