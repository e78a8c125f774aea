#include "evaluation/period/ridges.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <random>

#include "tests/support/is_error.h"

namespace {

using brdf::Angle;
using brdf::Errc;
using brdf::Length;
using evaluation::PlaneOfIncidence;
using evaluation::ResponseMatrix;
using evaluation::Ridge;
using evaluation::Ridges;

constexpr double sigma_um = 16.25;
constexpr double sigma_f = 1 / (2 * brdf::pi * sigma_um);

PlaneOfIncidence plane_at(double theta_i_deg, double sigma = sigma_um) {
  return {Angle::deg(theta_i_deg), 1, 1 / (2 * brdf::pi * sigma)};
}

/// A response with value(lambda [nm], f [1/um]), light at 75 deg.
ResponseMatrix response_of(const std::function<double(double, double)>& value,
                           double lambda_step_nm = 5) {
  ResponseMatrix response;
  for (double lambda = 400; lambda <= 700; lambda += lambda_step_nm)
    response.lambda_nm.values.push_back(lambda);
  for (int i = 0; i <= 900; ++i) response.theta_r_deg.values.push_back(-70 + i * 0.1);
  response.values.resize(static_cast<Eigen::Index>(response.lambda_nm.size()),
                         static_cast<Eigen::Index>(response.theta_r_deg.size()));
  for (Eigen::Index i = 0; i < response.values.rows(); ++i)
    for (Eigen::Index j = 0; j < response.values.cols(); ++j) {
      const double lambda_nm = response.lambda_nm[static_cast<std::size_t>(i)];
      const double sines = plane_at(75).sines(response.theta_r_deg[static_cast<std::size_t>(j)]);
      response.values(i, j) = value(lambda_nm, sines / Length::nm(lambda_nm).um());
    }
  return response;
}

/// The window's lobe about an order.
double lobe(double f_per_um, double at_per_um, double sigma = sigma_um) {
  return std::exp(-std::pow(2 * brdf::pi * sigma * (f_per_um - at_per_um), 2));
}

/// Peak of the first order of a sinusoidal grating 200 nm deep: an efficiency that changes with the
/// wavelength.
double efficiency(double lambda_nm, int order) {
  return std::pow(std::cyl_bessel_j(order, 2 * brdf::pi / lambda_nm * 1.2 * 100), 2);
}

std::size_t jumps(const Ridges& found, int order) {
  for (const auto& entry : found.jumps)
    if (entry.order == order) return entry.jumps;
  return std::numeric_limits<std::size_t>::max();
}

}  // namespace

TEST_CASE("the orders of a grating are a ridge each", "[oracle][ridges]") {
  const double d_um = 2.5;
  const Ridges found = find_ridges(response_of([&](double lambda_nm, double f) {
                                     double sum = 0;
                                     for (const int m : {1, 2, 3})
                                       sum += efficiency(lambda_nm, m) * lobe(f, m / d_um);
                                     return sum;
                                   }),
                                   plane_at(75), {});
  REQUIRE(found.ridges.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const Ridge& ridge = found.ridges[i];
    const int m = static_cast<int>(i) + 1;  // J_1 > J_2 > J_3 here
    CHECK(ridge.order == m);
    // Cells 0.1 deg apart are up to 0.4 sigma_f apart: linear interpolation between them.
    CHECK(std::abs(ridge.f_per_um - m / d_um) <= 5e-3 * sigma_f);
    CHECK(std::abs(ridge.period_nm - 2500) <= 5e-3 * sigma_f * 2500 * d_um / m);
    CHECK(ridge.present == 1);
    CHECK(ridge.brightest == 1);
    REQUIRE(ridge.spans.size() == 1);
    CHECK(ridge.spans[0].first_nm == 400);
    REQUIRE(ridge.window_widths);
    // Cells s apart add s^2 / 6 to the variance sigma_f^2 / 2 of the lobe, s up to 0.4 sigma_f: 2.7
    // %; the step of the axis adds 0.2 %.
    CHECK(std::abs(*ridge.window_widths - 1) <= 0.03);
    CHECK(ridge.merged_with.empty());
    CHECK(jumps(found, m) == 0);
  }
}

TEST_CASE("two populations whose strengths swap stay apart where the brightest jumps",
          "[oracle][ridges]") {
  // 3 % apart, 5 sigma_f at these periods.
  const double first = 1 / 0.6, second = first / 1.03;
  const auto first_share = [](double lambda_nm) { return 0.5 + 0.4 * std::sin(lambda_nm / 30); };
  const ResponseMatrix response = response_of([&](double lambda_nm, double f) {
    const double a = first_share(lambda_nm);
    return 1e-3 + a * lobe(f, first) + (1 - a) * lobe(f, second);
  });
  const Ridges found = find_ridges(response, plane_at(75), {});
  REQUIRE(found.ridges.size() == 2);
  std::size_t swaps = 0;
  for (double lambda = 400; lambda < 700; lambda += 5)
    if ((first_share(lambda) > 0.5) != (first_share(lambda + 5) > 0.5)) ++swaps;
  REQUIRE(swaps > 0);
  for (const Ridge& ridge : found.ridges) {
    const double exact =
        std::abs(ridge.f_per_um - first) < std::abs(ridge.f_per_um - second) ? first : second;
    // The other's tail, 9 times as high at worst, 4.9 sigma_f away, is 9 exp(-24) of its peak.
    CHECK(std::abs(ridge.f_per_um - exact) <= 5e-3 * sigma_f);
    CHECK(ridge.order == 1);
    CHECK(ridge.present == 1);
    CHECK(ridge.brightest > 0.2);
    CHECK(ridge.f_spread_per_um <= 0.02 * sigma_f);
  }
  CHECK(jumps(found, 1) == swaps);
}

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
  const auto hump = response_of([](double, double f) { return lobe(f, 1.5, sigma_um / 12); });
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
          const auto middle = static_cast<int>(f / sigma_f);
          for (int n = std::max(middle - 6, 0); n < std::min(middle + 7, 400); ++n)
            sum += amplitude[static_cast<std::size_t>(n)] *
                   std::exp(-0.5 * std::pow(f / sigma_f - n, 2));
          return std::norm(sum);
        },
        50);
    if (!find_ridges(grains, plane_at(75), {}).ridges.empty()) ++with_ridge;
  }
  // 150 grains of probability exp(-10) would give one; medians over octaves of few grains near the
  // mirror direction are uncertain.
  CHECK(with_ridge <= 5);
}

TEST_CASE("a ridge that ends halfway has that span", "[oracle][ridges]") {
  const Ridges found =
      find_ridges(response_of([](double lambda_nm, double f) {
                    return 1e-4 + lobe(f, 0.4) + (lambda_nm <= 550 ? 0.5 * lobe(f, 0.5) : 0);
                  }),
                  plane_at(75), {});
  REQUIRE(found.ridges.size() == 2);
  const Ridge& ending = found.ridges[1];
  CHECK(std::abs(ending.f_per_um - 0.5) <= 5e-3 * sigma_f);
  REQUIRE(ending.spans.size() == 1);
  CHECK(ending.spans[0].first_nm == 400);
  CHECK(ending.spans[0].last_nm == 550);
  CHECK(ending.present == Approx(31.0 / 61));  // 400, 405, ... 550 of 400 ... 700
  CHECK(found.ridges[0].present == 1);
}

TEST_CASE("how bright a wavelength is does not matter", "[invariant][ridges]") {
  const auto shape = [](double lambda_nm, double f) {
    return 1e-4 + lobe(f, 0.4) + (lambda_nm <= 550 ? 0.5 * lobe(f, 0.5) : 0);
  };
  const Ridges plain = find_ridges(response_of(shape), plane_at(75), {});
  const Ridges uneven = find_ridges(response_of([&](double lambda_nm, double f) {
                                      return shape(lambda_nm, f) *
                                             std::exp(lambda_nm / 40);  // by 1800 from end to end
                                    }),
                                    plane_at(75), {});
  REQUIRE(plain.ridges.size() == 2);
  REQUIRE(uneven.ridges.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    // Gains are iterated to 1e-6 per round.
    CHECK(uneven.ridges[i].strength == Approx(plain.ridges[i].strength).epsilon(1e-4));
    CHECK(uneven.ridges[i].f_per_um == Approx(plain.ridges[i].f_per_um).epsilon(1e-9));
  }
}

TEST_CASE("ridges that a window cannot part everywhere are merged there", "[oracle][ridges]") {
  // exp(-x^2) + a exp(-(x - 2)^2) has two maxima for a = 0.8, and one, with a shoulder, for a =
  // 0.1.
  const double apart = 2 * sigma_f;
  const auto weaker = [](double lambda_nm) { return lambda_nm <= 600 ? 0.8 : 0.1; };
  const ResponseMatrix response = response_of([&](double lambda_nm, double f) {
    return lobe(f, 0.5) + weaker(lambda_nm) * lobe(f, 0.5 + apart);
  });
  const Ridges found = find_ridges(response, plane_at(75), {});
  REQUIRE(found.ridges.size() == 2);
  REQUIRE(found.ridges[0].merged_with.size() == 1);
  REQUIRE(found.ridges[1].merged_with.size() == 1);
  CHECK(found.ridges[0].merged_with[0].with == 1);
  CHECK(found.ridges[1].merged_with[0].with == 0);
  CHECK(found.ridges[1].merged_with[0].wavelengths == 20);  // 605 ... 700
  CHECK(found.ridges[1].spans.back().last_nm == 600);

  // At 1.2 sigma_f they have one maximum, and a width that says so: the half maximum of two equal
  // lobes lies 1.33 as far out as that of one.
  const Ridges one = find_ridges(
      response_of([](double, double f) { return lobe(f, 0.5) + lobe(f, 0.5 + 1.2 * sigma_f); }),
      plane_at(75), {});
  REQUIRE(one.ridges.size() == 1);
  REQUIRE(one.ridges[0].window_widths);
  CHECK(*one.ridges[0].window_widths > 1.2);
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
    if (std::abs(found.f_per_um[j]) < 5.9 * sigma_f) CHECK(found.mean[j] == 0);
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
