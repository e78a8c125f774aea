// A period from a whole response: engine-made responses of gratings whose period is known.
#include "evaluation/period/joint_fit.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "brdf/synthetic_profile.h"
#include "evaluation/diffraction.h"
#include "evaluation/period_fit.h"
#include "evaluation/sweep.h"
#include "tests/support/is_error.h"
#include "tests/support/surfaces.h"

namespace {

using brdf::Angle;
using brdf::Errc;
using brdf::Length;
using brdf::Profile;
using brdf::SurfaceModel;
using evaluation::fit_period_jointly;
using evaluation::JointFit;
using evaluation::JointScene;
using evaluation::JointStatus;
using evaluation::ResponseMatrix;

constexpr double pixel_um = 0.1;
constexpr double tolerance = 1e-9;  // of the engine's amplitude

/// What is swept: theta_i, sigma, model and quantity.
struct Setting {
  double theta_i_deg = 30, sigma_um = 16.25;
  SurfaceModel model = SurfaceModel::isolated;
  brdf::Quantity quantity = brdf::Quantity::relative;
  brdf::Replicas replicas = {};
  double lambda_step_nm = 20;
};

struct Swept {
  ResponseMatrix response;
  JointScene scene;
};

Swept swept(const brdf::HeightField& field, const Setting& setting = {}) {
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(setting.sigma_um)),
                              setting.model, brdf::Origin::patch_centre, setting.replicas};
  evaluation::SweepRequest request{Angle::deg(setting.theta_i_deg), {}, {}, {}, {}};
  for (double nm = 380; nm <= 780; nm += setting.lambda_step_nm)
    request.lambda_nm.values.push_back(nm);
  for (int i = 0; i <= 1600; ++i) request.theta_r_deg.values.push_back(-80 + 0.1 * i);
  const auto plan =
      evaluation::method_named("chebyshev").plan(surface, bounds_of(request, tolerance), {});
  const evaluation::Optics optics{setting.quantity};
  return {sweep(request, evaluation::Diffraction(*plan, optics), {2, {}}),
          {request.theta_i, request.phi_i, request.phi_r, optics, request.depth, setting.model,
           surface.window, x_axis(surface), y_axis(surface), tolerance * tolerance}};
}

brdf::HeightField grating(Profile profile, double period_um, double height_nm) {
  return brdf::synthetic_grating({.profile = profile,
                                  .period = Length::um(period_um),
                                  .height = Length::nm(height_nm),
                                  .duty = 0.4},
                                 2, 650, Length::um(pixel_um), Length::um(pixel_um));
}

/// The Fourier series of a falling sawtooth, cut after three harmonics.
brdf::HeightField smoothed_blaze(double period_um, double height_nm) {
  return sampled(2, 650, pixel_um, pixel_um, [=](double x_um, double) {
    double height = 0.5;
    for (int m = 1; m <= 3; ++m)
      height += std::sin(2 * brdf::pi * m * x_um / period_um) / (brdf::pi * m);
    return 1e-3 * height_nm * height;
  });
}

bool holds(const JointFit& fit, double period_um) {
  return fit.low_nm <= 1e3 * period_um && 1e3 * period_um <= fit.high_nm;
}

double relative_error(const JointFit& fit, double period_um) {
  return std::abs(fit.period_nm / (1e3 * period_um) - 1);
}

/// The fit of the peaks of the strongest of the orders 1 and -1, as `shedlight period` does it.
double period_of_peaks_nm(const Swept& made, double period_um) {
  const evaluation::PlaneOfIncidence plane{made.scene.theta_i, 1,
                                           made.scene.window.sigma_f_per_um()};
  evaluation::PeakSearch search;
  search.period_guess = Length::um(period_um);
  return fit_period(find_peaks(made.response, plane, search), plane, 1, 0).period_nm;
}

}  // namespace

TEST_CASE("the joint fit of a smooth grating gives its period to 1e-5",
          "[oracle][joint_fit][long]") {
  const double period_um = GENERATE(0.8137, 1.4442, 2.3329, 4.8763);
  const double theta_i_deg = GENERATE(0.0, 75.0);
  const double sigma_um = GENERATE(5.0, 16.25);
  const bool is_sinusoid = GENERATE(true, false);
  CAPTURE(period_um, theta_i_deg, sigma_um, is_sinusoid);
  const auto field =
      is_sinusoid ? grating(Profile::sinusoid, period_um, 300) : smoothed_blaze(period_um, 200);
  const Swept made = swept(field, {theta_i_deg, sigma_um});
  const JointFit fit = fit_period_jointly(made.response, made.scene, Length::um(1.01 * period_um));
  CAPTURE(fit.period_nm, fit.std_nm, fit.orders, fit.explained);
  CHECK(fit.status == JointStatus::converged);
  // The sidelobes are modelled to first order in D / K: some 1e-6 of d is left of them, more as
  // the square of d.
  CHECK(relative_error(fit, period_um) <= 1e-5 * std::max(1.0, std::pow(period_um / 2.5, 2)));
  CHECK(holds(fit, period_um));
  CHECK(fit.relative_width == Approx(1).epsilon(0.03));
  CHECK(fit.explained > 0.99);  // 21 rows bear polynomials of degree 10
}

TEST_CASE("the interval of a grating with sharp edges holds its period", "[oracle][joint_fit]") {
  const double period_um = GENERATE(0.8137, 1.2377, 2.3329, 3.3737);
  const double sigma_um = GENERATE(5.0, 16.25);
  const Profile profile = GENERATE(Profile::blazed, Profile::lamellar);
  CAPTURE(period_um, sigma_um, static_cast<int>(profile));
  const Swept made = swept(grating(profile, period_um, 150), {30, sigma_um});
  const JointFit fit = fit_period_jointly(made.response, made.scene, Length::um(0.99 * period_um));
  CAPTURE(fit.period_nm, fit.low_nm, fit.high_nm);
  CHECK(fit.status == JointStatus::converged);
  CHECK(holds(fit, period_um));
  // An edge is placed within half a pixel; over the periods in three sigma the slope is off by no
  // more than a pixel in that length.
  CHECK(relative_error(fit, period_um) <= pixel_um / (3 * sigma_um));
}

TEST_CASE("peaks are biased where the joint fit is not", "[oracle][joint_fit]") {
  // Under the sources' window the sidelobes of the mirror pull the peaks of a weak order, whatever
  // the pixels might have done.
  const Swept weak = swept(smoothed_blaze(3.3737, 20), {0, 16.25});
  const JointFit fit = fit_period_jointly(weak.response, weak.scene, Length::um(3.3737));
  const double peaks_nm = period_of_peaks_nm(weak, 3.3737);
  CAPTURE(fit.period_nm, fit.low_nm, fit.high_nm, peaks_nm);
  CHECK(holds(fit, 3.3737));
  CHECK_FALSE((fit.low_nm <= peaks_nm && peaks_nm <= fit.high_nm));
  CHECK(std::abs(peaks_nm - 3373.7) >= 10 * std::abs(fit.period_nm - 3373.7));
}

TEST_CASE("a relief known to be smooth has a narrow interval that holds its period",
          "[oracle][joint_fit]") {
  // Strong orders, too, are pulled by their neighbours, and under a window of 2 um by the slope
  // of the efficiency across the wide lobe.
  const double sigma_um = GENERATE(2.0, 16.25);
  Swept made = swept(smoothed_blaze(1.4442, 150), {30, sigma_um});
  made.scene.relief = evaluation::Relief::smooth;
  const JointFit fit = fit_period_jointly(made.response, made.scene, Length::um(1.4442));
  const double peaks_nm = period_of_peaks_nm(made, 1.4442);
  CAPTURE(sigma_um, fit.period_nm, fit.low_nm, fit.high_nm, peaks_nm);
  CHECK(fit.uncertainty_nm.pixel == 0);
  CHECK(holds(fit, 1.4442));
  CHECK(fit.high_nm - fit.low_nm <= 1444.2 * 1e-3);
  CHECK_FALSE((fit.low_nm <= peaks_nm && peaks_nm <= fit.high_nm));
  CHECK(std::abs(peaks_nm - 1444.2) >= 10 * std::abs(fit.period_nm - 1444.2));
}

TEST_CASE("every surface model and quantity gives the same period", "[oracle][joint_fit]") {
  const auto field = grating(Profile::sinusoid, 2.5, 200);  // 26 periods across: it may repeat
  const SurfaceModel model =
      GENERATE(SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated);
  const brdf::Quantity quantity = GENERATE(brdf::Quantity::power, brdf::Quantity::brdf);
  CAPTURE(static_cast<int>(model), static_cast<int>(quantity));
  const Swept made = swept(field, {10, 16.25, model, quantity, {1, 1}});
  const JointFit fit = fit_period_jointly(made.response, made.scene, Length::um(2.52));
  CAPTURE(fit.period_nm, fit.low_nm, fit.high_nm);
  CHECK(relative_error(fit, 2.5) <= 2e-5);
  CHECK(holds(fit, 2.5));
}

TEST_CASE("the order of the rows and the side of the viewer play no part",
          "[invariant][joint_fit]") {
  const Swept made = swept(smoothed_blaze(1.4442, 200));
  const JointFit fit = fit_period_jointly(made.response, made.scene, Length::um(1.45));
  Swept other = made;
  std::reverse(other.response.lambda_nm.values.begin(), other.response.lambda_nm.values.end());
  other.response.values = made.response.values.colwise().reverse().eval();
  const JointFit reversed = fit_period_jointly(other.response, other.scene, Length::um(1.45));
  CHECK(reversed.period_nm == fit.period_nm);
  CHECK(reversed.low_nm == fit.low_nm);
  CHECK(reversed.uncertainty_nm.model == fit.uncertainty_nm.model);

  Swept mirrored = made;
  mirrored.scene.phi_r = Angle::deg(180);
  mirrored.response.values = made.response.values.rowwise().reverse().eval();
  const JointFit far = fit_period_jointly(mirrored.response, mirrored.scene, Length::um(1.45));
  // Thinned from the other end, the cells are others.
  CHECK(far.period_nm == Approx(fit.period_nm).epsilon(1e-7));
}

TEST_CASE("rows that do not belong hardly move the joint fit", "[invariant][joint_fit]") {
  Swept made = swept(smoothed_blaze(1.9127, 200), {.lambda_step_nm = 10});
  made.scene.relief = evaluation::Relief::smooth;
  const JointFit clean = fit_period_jointly(made.response, made.scene, Length::um(1.92));
  // Every tenth row: three times as bright, and moved by five cells, half of the lobe's width.
  for (Eigen::Index row = 4; row < made.response.values.rows(); row += 10)
    for (Eigen::Index col = made.response.values.cols() - 1; col >= 5; --col)
      made.response.values(row, col) = 3 * made.response.values(row, col - 5);
  const JointFit fit = fit_period_jointly(made.response, made.scene, Length::um(1.92));
  CAPTURE(clean.period_nm, fit.period_nm, fit.low_nm, fit.high_nm);
  // Without weights of the rows it is 3e-5, with them 1e-7.
  CHECK(std::abs(fit.period_nm / clean.period_nm - 1) <= 1e-6);
  CHECK(holds(fit, 1.9127));
}

TEST_CASE("noise on the cells is held by the interval", "[oracle][joint_fit]") {
  Swept clean = swept(grating(Profile::sinusoid, 1.4442, 200));
  clean.scene.relief = evaluation::Relief::smooth;
  std::mt19937_64 generator(11);
  // Evenly spread over 2 % of the strongest cell in view.
  const double level = 0.02 * clean.response.values.maxCoeff();
  int held = 0;
  constexpr int trials = 20;
  for (int trial = 0; trial < trials; ++trial) {
    Swept made = clean;
    for (double& value : made.response.values.reshaped())
      value += level * (static_cast<double>(generator() >> 11) * 0x1p-53 - 0.5);
    held += holds(fit_period_jointly(made.response, made.scene, Length::um(1.45)), 1.4442) ? 1 : 0;
  }
  // 19 of 20 are to be expected; 16 or fewer have a chance of 1.6 %.
  CAPTURE(held);
  CHECK(held >= 17);
}

TEST_CASE("a response without a single period is refused", "[invariant][joint_fit]") {
  std::mt19937_64 generator(5);
  brdf::HeightArray heights(2, 650);
  for (Eigen::Index col = 0; col < heights.cols(); ++col)
    heights.col(col) = 0.3 * static_cast<double>(generator() >> 11) * 0x1p-53;
  const Swept rough = swept(brdf::HeightField(heights, Length::um(pixel_um), Length::um(pixel_um)));
  CHECK_ERROR(fit_period_jointly(rough.response, rough.scene, Length::um(2)), Errc::not_attainable,
              "shedlight ridges");
  // A period that grows by a tenth over the patch: every order is several lobes wide.
  const Swept chirped = swept(sampled(2, 650, pixel_um, pixel_um, [](double x_um, double) {
    return 0.1 * std::cos(2 * brdf::pi * x_um / 1.5 * (1 + 0.1 * x_um / 65));
  }));
  CHECK_ERROR(fit_period_jointly(chirped.response, chirped.scene, Length::um(1.5)),
              Errc::not_attainable, "shedlight ridges");
}

TEST_CASE("what is missing for a joint fit is named", "[invariant][joint_fit]") {
  Swept made = swept(grating(Profile::sinusoid, 2.3329, 200));
  const auto fit = [&](double start_um) {
    return fit_period_jointly(made.response, made.scene, Length::um(start_um));
  };
  CHECK_ERROR(fit(0), Errc::invalid_argument, "must be > 0");
  CHECK_ERROR(fit(std::nan("")), Errc::invalid_argument, "must be > 0");
  CHECK_ERROR(fit(0.1), Errc::not_attainable, "stands above");  // evanescent
  made.scene.floor = 10;
  CHECK_ERROR(fit(2.3329), Errc::not_attainable, "stands above");
  made.scene.floor = 0;
  made.response.values(3, 400) = std::numeric_limits<double>::quiet_NaN();
  CHECK_ERROR(fit(2.3329), Errc::bad_input, "is not finite");
  made.response.values(3, 400) = 0;
  made.response.lambda_nm.values.resize(2);
  made.response.values.conservativeResize(2, Eigen::NoChange);
  CHECK_ERROR(fit(2.3329), Errc::not_attainable, "at least 3 wavelengths");
}
