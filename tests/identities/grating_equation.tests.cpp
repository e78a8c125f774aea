// From a peak's angle to the period, as the sources evaluate a grating.
#include "brdf/grating_equation.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "evaluation/period_fit.h"
#include "tests/support/exact_sums.h"
#include "tests/support/figure.h"
#include "tests/support/random_inputs.h"
#include "tests/support/worst_error.h"

using brdf::Angle;
using brdf::Length;
using brdf::pi;
using evaluation::Peak;
using evaluation::PlaneOfIncidence;
using evaluation::ResponseMatrix;
using exact::Real;

namespace {

/// The sources' scene: light at 75 deg, 380 to 780 nm in steps of 1 nm, angles of 0.01 deg.
const PlaneOfIncidence plane{Angle::deg(75), 1, {}};
constexpr int first_nm = 380, last_nm = 780;

double order_angle_deg(double period_um, double lambda_nm) {
  return brdf::viewing_angle(1, Length::um(period_um), Length::nm(lambda_nm), plane.theta_i)->deg();
}

/// Peaks at the exact angles of order +1, rounded to the grid of angles.
std::vector<Peak> rounded_peaks(double period_um) {
  std::vector<Peak> peaks;
  for (int lambda_nm = first_nm; lambda_nm <= last_nm; ++lambda_nm) {
    const double theta_deg = std::round(order_angle_deg(period_um, lambda_nm) * 100) / 100;
    peaks.push_back({static_cast<double>(lambda_nm), theta_deg, theta_deg, 1});
  }
  return peaks;
}

/// Lobes of order +1, Gaussians in u / lambda, brighter towards the red as exp(lambda / 100 nm).
ResponseMatrix reddish_lobes(double period_um, double sigma_um) {
  ResponseMatrix response;
  for (int lambda_nm = first_nm; lambda_nm <= last_nm; lambda_nm += 4)
    response.lambda_nm.values.push_back(lambda_nm);
  for (int i = 0; i <= 1500; ++i) response.theta_r_deg.values.push_back(-55 + i * 0.01);
  response.values.resize(static_cast<Eigen::Index>(response.lambda_nm.size()),
                         static_cast<Eigen::Index>(response.theta_r_deg.size()));
  for (Eigen::Index i = 0; i < response.values.rows(); ++i)
    for (Eigen::Index j = 0; j < response.values.cols(); ++j) {
      const double lambda_nm = response.lambda_nm[static_cast<std::size_t>(i)];
      const double f =
          plane.sines(response.theta_r_deg[static_cast<std::size_t>(j)]) / (lambda_nm / 1e3);
      response.values(i, j) = std::exp(lambda_nm / 100) *
                              std::exp(-std::pow(2 * pi * sigma_um * (f - 1 / period_um), 2));
    }
  return response;
}

}  // namespace

TEST_CASE("Thesis Algorithm 2.1: neighbouring grooves differ by m wavelengths",
          "[identity][oracle]") {
  constexpr std::uint64_t seed = 341;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError error;
  for (int i = 0; i < 10000; ++i) {
    const int order = static_cast<int>(std::floor(uniform(-4, 5)));
    const double d_um = uniform(0.5, 10), lambda_um = uniform(0.38, 0.78);
    const double theta_i_deg = uniform(-89, 89);
    const auto theta_r = brdf::viewing_angle(order, Length::um(d_um), Length::um(lambda_um),
                                             Angle::deg(theta_i_deg));
    if (!theta_r) continue;
    const Real path = d_um * (std::sin(theta_i_deg * exact::pi / 180) +
                              std::sin(static_cast<Real>(theta_r->rad())));
    error.see(static_cast<double>(std::abs(path - order * static_cast<Real>(lambda_um))) / d_um);
  }
  // Two sines in double and the angle's own rounding.
  CHECK(figure("Thesis Algorithm 2.1", "path of neighbouring grooves less m lambda, of d",
               error.value()) <= 5e-16);
}

TEST_CASE("Thesis Algorithm 2.2: the period from an angle is the same law", "[identity][oracle]") {
  constexpr std::uint64_t seed = 342;
  CAPTURE(seed);
  Uniform uniform(seed);
  WorstError error;
  for (int i = 0; i < 10000; ++i) {
    const double lambda_um = uniform(0.38, 0.78);
    const double theta_i_deg = uniform(0, 89), theta_r_deg = uniform(-theta_i_deg + 1, 89);
    const Real sines =
        std::sin(theta_i_deg * exact::pi / 180) + std::sin(theta_r_deg * exact::pi / 180);
    const auto d = brdf::period_from_angle(2, Length::um(lambda_um), Angle::deg(theta_i_deg),
                                           Angle::deg(theta_r_deg));
    REQUIRE(d);
    // Sines right to 2e-16 whose sum may be small: the period's error times that sum.
    error.see(static_cast<double>(std::abs(d->um() * sines / (2 * lambda_um) - 1) *
                                  std::min<Real>(1, sines)));
  }
  CHECK(figure("Thesis Algorithm 2.2", "period times sines over m lambda", error.value()) <= 5e-16);
}

TEST_CASE("Thesis 2.3: the mean over the wavelengths of d from the brightest cells",
          "[identity][oracle]") {
  const ResponseMatrix response = reddish_lobes(2.5, 16.25);
  evaluation::PeakSearch search;
  search.refinement = evaluation::Refinement::grid;
  const auto peaks = evaluation::find_peaks(response, plane, search);
  const auto spread = evaluation::period_spread(peaks, plane, 1);
  REQUIRE(spread.count == response.lambda_nm.size());
  // Half a cell, 0.005 deg, moves d by up to d cos theta_r / sines * 8.7e-5: 1.1 nm.
  WorstError cell;
  for (const Peak& peak : peaks)
    cell.see(std::abs(*peak.theta_r_deg - order_angle_deg(2.5, peak.lambda_nm)));
  CHECK(figure("Thesis 2.3", "peak against the grating equation [deg]", cell.value()) <=
        0.005 + 1e-9);
  // 101 roundings, evenly spread over a cell: 0.4 nm each, over the root of 101, and three times.
  CHECK(figure("Thesis 2.3", "mean period less 2500 nm", std::abs(spread.mean_nm - 2500)) <= 0.12);
}

TEST_CASE("Erratum E9: the maximum is over angles for each wavelength, not over wavelengths",
          "[identity][erratum][E9]") {
  // Where the lamp or the grating brightens towards the red, the brightest wavelength of an angle
  // is too red: d comes out too long.
  const ResponseMatrix response = reddish_lobes(2.5, 16.25);
  double printed_mean_nm = 0, mean_um = 0;
  int count = 0;
  for (Eigen::Index j = 0; j < response.values.cols(); ++j) {
    Eigen::Index brightest = 0;
    response.values.col(j).maxCoeff(&brightest);
    if (brightest == 0 || brightest + 1 == response.values.rows()) continue;
    printed_mean_nm +=
        *evaluation::period_nm(plane, 1, response.lambda_nm[static_cast<std::size_t>(brightest)],
                               response.theta_r_deg[static_cast<std::size_t>(j)]);
    mean_um += response.lambda_nm[static_cast<std::size_t>(brightest)] / 1e3;
    ++count;
  }
  printed_mean_nm /= count;
  mean_um /= count;
  // lambda / 0.1 um - (2 pi sigma (u / lambda - 1 / d))^2 is largest where d is too long by
  // d^3 lambda / (2 (2 pi sigma)^2 0.1 um), to first order.
  const double expected_nm =
      1e3 * std::pow(2.5, 3) * mean_um / (2 * std::pow(2 * pi * 16.25, 2) * 0.1);
  CHECK(figure("E9", "maxima over wavelengths: mean period less 2500 nm", printed_mean_nm - 2500) ==
        Approx(expected_nm).epsilon(0.03));
}

TEST_CASE("Erratum E9: max - min over the count does not reach the last wavelength",
          "[identity][erratum][E9]") {
  const int count = last_nm - first_nm + 1;
  const double printed_step_nm = static_cast<double>(last_nm - first_nm) / count;
  const double right_step_nm = static_cast<double>(last_nm - first_nm) / (count - 1);
  CHECK(right_step_nm == 1);
  CHECK(figure("E9", "last wavelength of 401 by the printed step; right: 780",
               first_nm + (count - 1) * printed_step_nm) == Approx(779.0025).epsilon(1e-7));
}

TEST_CASE("Erratum E10: at a fixed theta_i each wavelength has its own theta_r",
          "[identity][erratum][E10]") {
  CHECK(figure("E10", "theta_r from 380 to 780 nm, d = 2.5 um [deg]; printed: 0",
               order_angle_deg(2.5, 780) - order_angle_deg(2.5, 380)) ==
        Approx(13.64).epsilon(5e-4));  // grating_equation_75deg.csv
}

TEST_CASE("Erratum E11: the recorded 2499.997 and 0.377 nm are the angle grid's rounding",
          "[identity][erratum][E11]") {
  const auto spread = evaluation::period_spread(rounded_peaks(2.5), plane, 1);
  // Known from rounding exact angles elsewhere; 401 sums of 2500 round to 1e-10.
  CHECK(spread.mean_nm == Approx(2499.9974453586824).margin(1e-9).epsilon(0));
  CHECK(figure("E11", "N - 1 standard deviation of the rounded angles [nm]", spread.std_nm) ==
        Approx(0.37726655).margin(5e-9).epsilon(0));
  // Its square is the variance, in nm^2: the Thesis prints 0.16 for it, and the unit mm.
  CHECK(figure("E11", "its square [nm^2]; printed: 0.16", spread.std_nm * spread.std_nm) ==
        Approx(0.1423).epsilon(1e-3));
  // Over N instead of N - 1 it would be 1 - 1 / 802 of it: both round to 0.377.
  const double over_n = spread.std_nm * std::sqrt(400.0 / 401);
  CHECK(std::abs(over_n - 0.377) <= 5e-4);
}

TEST_CASE("Erratum E11: the spread does not say how right the mean is",
          "[identity][erratum][E11]") {
  // A scan whose pixel is off by 1 % puts every peak where a period 1 % longer would.
  const auto right = evaluation::period_spread(rounded_peaks(2.5), plane, 1);
  const auto off = evaluation::period_spread(rounded_peaks(2.525), plane, 1);
  CHECK(figure("E11", "mean moved by a pixel 1 % off [nm]", off.mean_nm - right.mean_nm) ==
        Approx(25).epsilon(0.01));
  CHECK(figure("E11", "and its standard deviation [nm]", off.std_nm) ==
        Approx(right.std_nm).epsilon(0.1));
}
