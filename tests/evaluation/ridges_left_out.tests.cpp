// What is no ridge, or none that is asked for: noise, the mirror lobe, other orders.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <random>

#include "evaluation/period/ridges.h"
#include "tests/support/is_error.h"
#include "tests/support/ridge_responses.h"

using brdf::Errc;
using brdf::Length;
using evaluation::PlaneOfIncidence;
using evaluation::ResponseMatrix;
using evaluation::Ridges;

TEST_CASE("speckle, a smooth response and a bright spot have no ridge", "[invariant][ridges]") {
  const int seed = 20;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::exponential_distribution<double> speckle;
  // Ten draws: one of 50 grains of independent speckle in a single wavelength exceeds ten times the
  // mean with a probability of 0.2 %, in the mean of 61 never.
  for (int draw = 0; draw < 10; ++draw) {
    const auto rough = response_of([&](double, double) { return speckle(random); });
    CHECK(find_ridges(rough, plane_at(75), {}).ridges.empty());
  }
  const auto smooth =
      response_of([](double, double f) { return 1 + std::exp(-std::pow((f - 0.8) / 0.3, 2)); });
  CHECK(find_ridges(smooth, plane_at(75), {}).ridges.empty());
  // A hump of the surface's spectrum that stands clear, but 12 times as wide as the window: within
  // 5 sigma_f it falls to 0.84.
  const auto hump = response_of([](double, double f) { return lobe(f, 1.5, ridge_sigma_um / 12); });
  CHECK(find_ridges(hump, plane_at(75), {}).ridges.empty());
  // One of five wavelengths: a hundred widths of the window hold its power, so that it stands some
  // 100 / 5 times the mean.
  const auto spot = response_of(
      [](double lambda_nm, double f) { return 1 + (lambda_nm == 550 ? 1e6 * lobe(f, 0.8) : 0); },
      75);
  CHECK(find_ridges(spot, plane_at(75), {}).ridges.empty());
  const auto flat = response_of([](double, double) { return 3.0; });
  CHECK(find_ridges(flat, plane_at(75), {}).ridges.empty());
  const auto dark = response_of([](double, double) { return 0.0; });
  CHECK(find_ridges(dark, plane_at(75), {}).ridges.empty());
}

TEST_CASE("grains of a rough patch, at constant f, are seldom ridges", "[oracle][ridges]") {
  const int seed = 21;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  constexpr int draws = 100;
  int with_ridge = 0;
  for (int draw = 0; draw < draws; ++draw) {
    // White noise seen through the window: lobes of random amplitude every sigma_f.
    std::vector<std::complex<double>> amplitude(400);
    for (auto& a : amplitude) a = {normal(random), normal(random)};
    const auto grains = response_of(
        [&](double, double f) {
          std::complex<double> sum = 0;
          const auto middle = static_cast<int>(f / ridge_sigma_f);
          for (int n = std::max(middle - 6, 0); n < std::min(middle + 7, 400); ++n)
            sum += amplitude[static_cast<std::size_t>(n)] *
                   std::exp(-0.5 * std::pow(f / ridge_sigma_f - n, 2));
          return std::norm(sum);
        },
        50);
    if (!find_ridges(grains, plane_at(75), {}).ridges.empty()) ++with_ridge;
  }
  // 150 grains of probability exp(-10) would give one; medians over octaves of few grains near the
  // mirror direction are uncertain.
  CHECK(with_ridge <= 5);
}

TEST_CASE("the mirror lobe is no ridge, and sides are told apart", "[invariant][ridges]") {
  ResponseMatrix response;
  for (double lambda = 400; lambda <= 700; lambda += 5) response.lambda_nm.values.push_back(lambda);
  for (int i = 0; i <= 1600; ++i) response.theta_r_deg.values.push_back(-80 + i * 0.1);
  response.values.resize(static_cast<Eigen::Index>(response.lambda_nm.size()), 1601);
  const PlaneOfIncidence plane = plane_at(20);
  for (Eigen::Index i = 0; i < response.values.rows(); ++i)
    for (Eigen::Index j = 0; j < 1601; ++j) {
      const double f = plane.sines(response.theta_r_deg[static_cast<std::size_t>(j)]) /
                       Length::nm(response.lambda_nm[static_cast<std::size_t>(i)]).um();
      response.values(i, j) = 1e4 * lobe(f, 0) + lobe(f, 0.5) + 0.7 * lobe(f, -0.5);
    }
  const Ridges found = find_ridges(response, plane, {});
  REQUIRE(found.ridges.size() == 2);
  for (std::size_t j = 0; j < found.mean.size(); ++j)
    if (std::abs(found.f_per_um[j]) < 5.9 * ridge_sigma_f) CHECK(found.mean[j] == 0);
  CHECK(found.ridges[0].order == 1);
  CHECK(found.ridges[1].order == -1);
  CHECK(found.ridges[0].period_nm == Approx(2000).epsilon(1e-3));
  CHECK(found.ridges[1].period_nm == Approx(2000).epsilon(1e-3));
}

TEST_CASE("an order with a guess, and a range of periods, keep only those", "[invariant][ridges]") {
  const ResponseMatrix response = response_of(
      [](double, double f) { return lobe(f, 0.4) + 0.5 * lobe(f, 0.8) + 0.4 * lobe(f, 0.45); });
  evaluation::RidgeSearch search;
  CHECK(find_ridges(response, plane_at(75), search).ridges.size() == 3);
  search.period_guess = Length::um(2.5);
  search.order = 2;
  Ridges found = find_ridges(response, plane_at(75), search);
  REQUIRE(found.ridges.size() == 1);
  CHECK(found.ridges[0].order == 2);
  CHECK(found.ridges[0].relative == 1);
  search.order.reset();
  search.period_range = {Length::um(2.2), Length::um(2.3)};
  found = find_ridges(response, plane_at(75), search);
  REQUIRE(found.ridges.size() == 1);
  CHECK(found.ridges[0].period_nm == Approx(1000 / 0.45).epsilon(1e-3));
}

TEST_CASE("searches without meaning are refused", "[ridges][refusal]") {
  ResponseMatrix response = response_of([](double, double f) { return lobe(f, 0.4); });
  const auto find = [&](const evaluation::RidgeSearch& search) {
    return find_ridges(response, plane_at(75), search);
  };
  evaluation::RidgeSearch search;
  search.order = 0;
  CHECK_ERROR(find(search), Errc::invalid_argument, "order 0");
  for (const double contrast : {1.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    search = {};
    search.least_contrast = contrast;
    CHECK_ERROR(find(search), Errc::invalid_argument, "contrast");
  }
  search = {};
  search.period_guess = Length::um(0);
  CHECK_ERROR(find(search), Errc::invalid_argument, "period 0");
  response.values(3, 4) = std::numeric_limits<double>::quiet_NaN();
  CHECK_ERROR(find({}), Errc::bad_input, "415 nm");
  response = response_of([](double, double f) { return lobe(f, 0.4); }, 200);
  CHECK_ERROR(find({}), Errc::not_attainable, "2 of them");
}
