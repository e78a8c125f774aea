#include "evaluation/peaks.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "brdf/error.h"
#include "brdf/grating_equation.h"

namespace {

using brdf::Angle;
using brdf::Length;
using evaluation::PeakSearch;
using evaluation::PlaneOfIncidence;
using evaluation::Refinement;
using evaluation::ResponseMatrix;

constexpr double sigma_um = 16.25;

PlaneOfIncidence plane_at(double theta_i_deg) {
  return {Angle::deg(theta_i_deg), 1, 1 / (2 * brdf::pi * sigma_um)};
}

/// Gaussian lobes of given strengths at the orders of a grating, exact in u.
ResponseMatrix lobes(double period_um, const std::vector<std::pair<int, double>>& orders,
                     double theta_i_deg = 75) {
  ResponseMatrix response;
  for (double lambda = 400; lambda <= 700; lambda += 50)
    response.lambda_nm.values.push_back(lambda);
  for (int i = 0; i <= 1400; ++i) response.theta_r_deg.values.push_back(-85 + i * 0.1);
  response.values.resize(static_cast<Eigen::Index>(response.lambda_nm.size()),
                         static_cast<Eigen::Index>(response.theta_r_deg.size()));
  for (Eigen::Index i = 0; i < response.values.rows(); ++i)
    for (Eigen::Index j = 0; j < response.values.cols(); ++j) {
      const double f =
          plane_at(theta_i_deg).sines(response.theta_r_deg[static_cast<std::size_t>(j)]) /
          Length::nm(response.lambda_nm[static_cast<std::size_t>(i)]).um();
      double value = 0;
      for (const auto& [order, strength] : orders)
        value +=
            strength * std::exp(-std::pow(2 * brdf::pi * sigma_um * (f - order / period_um), 2));
      response.values(i, j) = value;
    }
  return response;
}

}  // namespace

TEST_CASE("a refined peak of a Gaussian lobe is the order's angle", "[oracle]") {
  const ResponseMatrix response = lobes(2.5, {{1, 1.0}});
  const auto peaks = find_peaks(response, plane_at(75), {});
  REQUIRE(peaks.size() == response.lambda_nm.size());
  for (const auto& peak : peaks) {
    REQUIRE(peak.theta_r_deg);
    const double exact =
        brdf::viewing_angle(1, Length::um(2.5), Length::nm(peak.lambda_nm), Angle::deg(75))->deg();
    // The logarithm is a parabola in sin theta exactly: what is left is rounding, magnified by the
    // ratio of the lobe to the drop over one cell.
    CHECK(std::abs(*peak.theta_r_deg - exact) <= 1e-10);
    CHECK(std::abs(peak.grid_theta_r_deg - exact) <= 0.05 + 1e-9);  // half a cell
    const auto d = period_nm(plane_at(75), 1, peak.lambda_nm, *peak.theta_r_deg);
    REQUIRE(d);
    CHECK(std::abs(*d - 2500) <= 1e-6);
  }
}

TEST_CASE("without refinement the peak is the brightest cell", "[invariant]") {
  PeakSearch search;
  search.refinement = Refinement::grid;
  for (const auto& peak : find_peaks(lobes(2.5, {{1, 1.0}}), plane_at(75), search)) {
    REQUIRE(peak.theta_r_deg);
    CHECK(*peak.theta_r_deg == peak.grid_theta_r_deg);
  }
}

TEST_CASE("a period guess finds a weak order beside stronger ones", "[invariant]") {
  const ResponseMatrix response = lobes(2.5, {{0, 50.0}, {1, 1.0}, {2, 5.0}, {3, 9.0}});
  for (const int order : {1, 2, 3}) {
    PeakSearch search;
    search.order = order;
    search.period_guess = Length::um(2.6);
    for (const auto& peak : find_peaks(response, plane_at(75), search)) {
      REQUIRE(peak.theta_r_deg);
      const auto d = period_nm(plane_at(75), order, peak.lambda_nm, *peak.theta_r_deg);
      CHECK(std::abs(d.value_or(0) - 2500) <= 1e-3);  // the tails of the neighbours
    }
  }
}

TEST_CASE("the mirror lobe is no peak of another order", "[invariant]") {
  const ResponseMatrix response = lobes(2.5, {{0, 1e6}, {1, 1.0}});
  for (const auto& peak : find_peaks(response, plane_at(75), {})) {
    REQUIRE(peak.theta_r_deg);
    CHECK(period_nm(plane_at(75), 1, peak.lambda_nm, *peak.theta_r_deg).value_or(0) ==
          Approx(2500).epsilon(1e-6));
  }
}

TEST_CASE("negative orders are looked for on the other side of the mirror", "[invariant]") {
  PeakSearch search;
  search.order = -1;
  const auto peaks = find_peaks(lobes(2.5, {{-1, 1.0}, {1, 100.0}}, 20), plane_at(20), search);
  for (const auto& peak : peaks) {
    REQUIRE(peak.theta_r_deg);
    CHECK(period_nm(plane_at(20), -1, peak.lambda_nm, *peak.theta_r_deg).value_or(0) ==
          Approx(2500).epsilon(1e-6));
  }
}

TEST_CASE("a maximum on the edge of the window is no peak", "[invariant]") {
  const ResponseMatrix response = lobes(2.5, {{1, 1.0}});
  PeakSearch search;
  const double at_400 =
      brdf::viewing_angle(1, Length::um(2.5), Length::nm(400), Angle::deg(75))->deg();
  search.theta_r_deg = {-85.0, at_400 - 0.3};  // the lobe rises up to the edge
  CHECK_FALSE(find_peaks(response, plane_at(75), search)[0].theta_r_deg);
  search.theta_r_deg = {at_400 + 0.3, 0.0};
  CHECK_FALSE(find_peaks(response, plane_at(75), search)[0].theta_r_deg);
  search.theta_r_deg = {at_400 - 0.3, at_400 + 0.3};
  CHECK(find_peaks(response, plane_at(75), search)[0].theta_r_deg);
  search.theta_r_deg = {at_400 - 0.04, at_400 + 0.04};  // a single cell
  CHECK_FALSE(find_peaks(response, plane_at(75), search)[0].theta_r_deg);
}

TEST_CASE("a flat response has no peak", "[invariant]") {
  ResponseMatrix response = lobes(2.5, {{1, 1.0}});
  for (const double level : {0.0, 3.0}) {
    response.values.setConstant(level);
    for (const auto& peak : find_peaks(response, plane_at(75), {})) CHECK_FALSE(peak.theta_r_deg);
  }
}

TEST_CASE("a maximum that the response's own error could make is no peak", "[invariant]") {
  PeakSearch search;
  search.floor = 0.9;
  for (const auto& peak : find_peaks(lobes(2.5, {{1, 1.0}}), plane_at(75), search))
    CHECK(peak.theta_r_deg);
  for (const auto& peak : find_peaks(lobes(2.5, {{1, 0.8}}), plane_at(75), search))
    CHECK_FALSE(peak.theta_r_deg);
}

TEST_CASE("a range of periods bounds the search from both sides", "[invariant]") {
  const ResponseMatrix response = lobes(2.5, {{1, 1.0}, {2, 5.0}});
  PeakSearch search;
  search.period_range = {Length::um(2.0), Length::um(3.0)};
  for (const auto& peak : find_peaks(response, plane_at(75), search)) CHECK(peak.theta_r_deg);
  search.period_range = {Length::um(2.6), Length::um(3.0)};
  for (const auto& peak : find_peaks(response, plane_at(75), search)) CHECK_FALSE(peak.theta_r_deg);
}

TEST_CASE("the viewer must stand in the plane of incidence", "[invariant]") {
  CHECK(evaluation::plane_of_incidence(Angle::deg(75), Angle::deg(90), Angle::deg(90)).light_side ==
        1);
  CHECK(
      evaluation::plane_of_incidence(Angle::deg(75), Angle::deg(90), Angle::deg(-270)).light_side ==
      1);
  CHECK(evaluation::plane_of_incidence(Angle::deg(75), Angle::deg(0), Angle::deg(180)).light_side ==
        -1);
  CHECK_THROWS_AS(evaluation::plane_of_incidence(Angle::deg(75), Angle::deg(0), Angle::deg(10)),
                  brdf::Error);
}

TEST_CASE("a viewer measured from the far side gives the same periods", "[invariant]") {
  ResponseMatrix response = lobes(2.5, {{1, 1.0}});
  ResponseMatrix mirrored = response;
  mirrored.values = response.values.rowwise().reverse();
  std::vector<double>& angles = mirrored.theta_r_deg.values;
  for (double& angle : angles) angle = -angle;
  std::reverse(angles.begin(), angles.end());
  PlaneOfIncidence far = plane_at(75);
  far.light_side = -1;
  const auto peaks = find_peaks(mirrored, far, {});
  for (const auto& peak : peaks) {
    REQUIRE(peak.theta_r_deg);
    CHECK(period_nm(far, 1, peak.lambda_nm, *peak.theta_r_deg).value_or(0) ==
          Approx(2500).epsilon(1e-9));
  }
}

TEST_CASE("rows without a peak stay empty in the CSV", "[golden]") {
  ResponseMatrix response;
  response.lambda_nm = {{500, 501}, 0};
  std::vector<evaluation::Peak> peaks{{500, std::nullopt}, {501, -50.25, -50.25, 0.125}};
  const std::string csv = to_csv(peaks, plane_at(75), 1, response);
  CHECK(csv.substr(0, csv.rfind(',')) ==
        "lambda_nm,order,theta_peak_deg,value,period_nm\n500,1,,,\n501,1,-50.25,0.125");
}
