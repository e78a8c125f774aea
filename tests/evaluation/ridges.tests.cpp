#include "evaluation/period/ridges.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/support/ridge_responses.h"

namespace {

using evaluation::ResponseMatrix;
using evaluation::Ridge;
using evaluation::Ridges;

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
    CHECK(std::abs(ridge.f_per_um - m / d_um) <= 5e-3 * ridge_sigma_f);
    CHECK(std::abs(ridge.period_nm - 2500) <= 5e-3 * ridge_sigma_f * 2500 * d_um / m);
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
    CHECK(std::abs(ridge.f_per_um - exact) <= 5e-3 * ridge_sigma_f);
    CHECK(ridge.order == 1);
    CHECK(ridge.present == 1);
    CHECK(ridge.brightest > 0.2);
    CHECK(ridge.f_spread_per_um <= 0.02 * ridge_sigma_f);
  }
  CHECK(jumps(found, 1) == swaps);
}

TEST_CASE("a ridge that ends halfway has that span", "[oracle][ridges]") {
  const Ridges found =
      find_ridges(response_of([](double lambda_nm, double f) {
                    return 1e-4 + lobe(f, 0.4) + (lambda_nm <= 550 ? 0.5 * lobe(f, 0.5) : 0);
                  }),
                  plane_at(75), {});
  REQUIRE(found.ridges.size() == 2);
  const Ridge& ending = found.ridges[1];
  CHECK(std::abs(ending.f_per_um - 0.5) <= 5e-3 * ridge_sigma_f);
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
  const double apart = 2 * ridge_sigma_f;
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
  const Ridges one = find_ridges(response_of([](double, double f) {
                                   return lobe(f, 0.5) + lobe(f, 0.5 + 1.2 * ridge_sigma_f);
                                 }),
                                 plane_at(75), {});
  REQUIRE(one.ridges.size() == 1);
  REQUIRE(one.ridges[0].window_widths);
  CHECK(*one.ridges[0].window_widths > 1.2);
}
