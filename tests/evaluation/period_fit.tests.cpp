#include "evaluation/period_fit.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <random>

#include "brdf/error.h"
#include "brdf/grating_equation.h"

namespace {

using brdf::Angle;
using brdf::Length;
using evaluation::Peak;
using evaluation::PlaneOfIncidence;

const PlaneOfIncidence plane{Angle::deg(75), 1, {}};

/// The grating equation's own angles, each moved by error(i) degrees.
template <class Error>
std::vector<Peak> peaks_of(double period_um, int order, Error error) {
  std::vector<Peak> peaks;
  for (int i = 0; i <= 400; ++i) {
    const double lambda_nm = 380 + i;
    const auto angle =
        brdf::viewing_angle(order, Length::um(period_um), Length::nm(lambda_nm), plane.theta_i);
    Peak peak{lambda_nm, std::nullopt};
    if (angle) {
      peak.theta_r_deg = angle->deg() + error(i);
      peak.grid_theta_r_deg = *peak.theta_r_deg;
    }
    peaks.push_back(peak);
  }
  return peaks;
}

/// A normal deviate of own making: the standard library's differ between implementations.
double normal(std::mt19937_64& generator) {
  const auto uniform = [&] { return (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53; };
  const double radius = std::sqrt(-2 * std::log(uniform()));
  return radius * std::cos(2 * brdf::pi * uniform());
}

}  // namespace

TEST_CASE("exact angles give the period back", "[oracle]") {
  for (const double period_um : {0.8, 1.144262, 2.5, 5.0})
    for (const int order : {1, 2, -1}) {
      const auto peaks = peaks_of(period_um, order, [](int) { return 0.0; });
      std::size_t seen = 0;
      for (const Peak& peak : peaks) seen += peak.theta_r_deg ? 1 : 0;
      if (seen < 2) continue;
      CAPTURE(period_um, order);
      const auto fit = fit_period(peaks, plane, order, 0);
      CHECK(fit.status == evaluation::FitStatus::converged);
      CHECK(std::abs(fit.period_nm - 1000 * period_um) <= 1e-8 * period_um * 1000);
      CHECK(fit.outlier_lambdas_nm.empty());
      CHECK(fit.residuals_deg.size() == seen);
    }
}

TEST_CASE("rounding the exact angles to a grid gives the sources' mean and deviation", "[oracle]") {
  const auto exact = peaks_of(2.5, 1, [](int) { return 0.0; });
  std::vector<Peak> rounded = exact;
  for (Peak& peak : rounded) {
    peak.theta_r_deg = std::round(*peak.theta_r_deg * 100) / 100;
    peak.grid_theta_r_deg = *peak.theta_r_deg;
  }
  const auto spread = period_spread(rounded, plane, 1);
  // The two figures were computed elsewhere, to the digits shown.
  CHECK(std::abs(spread.mean_nm - 2499.9974453586824) <= 1e-9);
  CHECK(std::abs(spread.std_nm - 0.37726655) <= 5e-9);
  CHECK(spread.count == 401);
}

TEST_CASE("the standard error covers the truth as often as it says", "[oracle]") {
  std::mt19937_64 generator(20140106);
  const int trials = 400;
  int covered = 0;
  double sum = 0, sum_of_squares = 0, stated = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const auto peaks = peaks_of(2.5, 1, [&](int) { return 0.02 * normal(generator); });
    const auto fit = fit_period(peaks, plane, 1, 0);
    const double error = fit.period_nm - 2500;
    covered += std::abs(error) <= 1.96 * fit.std_error_nm ? 1 : 0;
    sum += error;
    sum_of_squares += error * error;
    stated += fit.std_error_nm;
  }
  const double spread = std::sqrt(sum_of_squares / trials);
  INFO("covered " << covered << " of " << trials << ", spread " << spread << " nm, stated "
                  << stated / trials << " nm");
  // A spread over 400 trials is itself known to 1 / sqrt(800) = 3.5 %; three times that.
  CHECK(std::abs(stated / trials / spread - 1) <= 0.11);
  // 95 % of 400 is 380, with a binomial deviation of 4.4; three times that.
  CHECK(covered >= 366);
  CHECK(covered <= 394);
  CHECK(std::abs(sum / trials) <= 4 * spread / std::sqrt(trials));  // no bias
}

TEST_CASE("peaks of another ridge are named as outliers and do not pull", "[invariant]") {
  std::mt19937_64 generator(7);
  auto peaks = peaks_of(2.5, 1, [&](int) { return 0.005 * normal(generator); });
  const auto other = peaks_of(2.3, 1, [](int) { return 0.0; });
  for (std::size_t i = 100; i < 140; ++i) peaks[i] = other[i];
  const auto fit = fit_period(peaks, plane, 1, 0);
  CHECK(std::abs(fit.period_nm - 2500) <= 0.2);  // the plain mean would be off by 20
  REQUIRE(fit.outlier_lambdas_nm.size() >= 40);
  CHECK(fit.outlier_lambdas_nm.size() <= 50);  // 3 robust deviations leave 0.3 % of the others
  CHECK(std::abs(period_spread(peaks, plane, 1).mean_nm - 2500) >= 15);
}

TEST_CASE("too few peaks, or order 0, is refused as not attainable", "[invariant]") {
  auto peaks = peaks_of(2.5, 1, [](int) { return 0.0; });
  const auto code = [](auto run) {
    try {
      run();
    } catch (const brdf::Error& error) {
      return error.code();
    }
    return brdf::Errc::over_limit;
  };
  CHECK(code([&] { fit_period(peaks, plane, 0, 0); }) == brdf::Errc::not_attainable);
  for (std::size_t i = 1; i < peaks.size(); ++i) peaks[i].theta_r_deg.reset();
  CHECK(code([&] { fit_period(peaks, plane, 1, 0); }) == brdf::Errc::not_attainable);
  CHECK(code([&] { period_spread(peaks, plane, 1); }) == brdf::Errc::not_attainable);
}

TEST_CASE("the side of an order is told from its sign", "[invariant]") {
  CHECK(evaluation::side_of(2) == "towards the light");
  CHECK(evaluation::side_of(-1) == "away from the light");
  CHECK(evaluation::side_of(0) == "mirror");
}
