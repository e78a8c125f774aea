// What advise says of optics: wave or geometry, scalar strengths, window, orders, steps.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "brdf/units.h"
#include "tests/cli/advice.h"

using brdf::pi;
using nlohmann::json;

TEST_CASE("a wide deep sinusoid with a short coherence length needs geometric optics only",
          "[cli][advise]") {
  const Scratch folder;
  make(folder, wide_sinusoid);
  for (const std::string light : {"0deg", "30deg", "75deg", "-75deg"}) {
    const json advice = advise(folder, "g.gsf --sigma 2um --theta-i " + light);
    INFO(light);
    CHECK(verdict(advice, "optics") == "geometric");
    CHECK(advice.at("optics").at("decided_by").at("value") == "deep");
    CHECK(verdict(advice, "method") == "microfacet");
    CHECK_THAT(advice.at("command").get<std::string>(), Catch::Contains("--method microfacet"));
    // lambda / d against 2 sqrt(ln 2) lambda / (2 pi sigma): 0.38 lobes.
    CHECK(advice.at("window").at("periods_inside").at("value").at(0).get<double>() ==
          Approx(pi * 2 / std::sqrt(std::log(2.0)) / 20).epsilon(0.01));
  }
}

TEST_CASE("the same sinusoid needs diffraction where the orders are seen apart", "[cli][advise]") {
  const Scratch folder;
  make(folder, wide_sinusoid);
  const std::string wide = "g.gsf --sigma 16um --theta-i 0deg --lambda 500nm";
  const json fine = advise(folder, wide + " --resolution 0.1deg");
  CHECK(verdict(fine, "optics") == "diffraction");
  CHECK(fine.at("optics").at("decided_by").at("value") == "resolved");
  // 0.5 / 20 rad = 1.4324 deg; the period is read to 1e-3.
  CHECK(value(fine, "optics", "spacing") == Approx(1.4324).epsilon(2e-3));
  CHECK(verdict(advise(folder, wide + " --resolution 1.42deg"), "optics") == "diffraction");
  CHECK(verdict(advise(folder, wide + " --resolution 1.45deg"), "optics") == "geometric");
}

TEST_CASE("orders blur where the window holds less than one period", "[cli][advise]") {
  const Scratch folder;
  make(folder, wide_sinusoid);
  // 3.7733 sigma = 20 um at sigma = 5.3 um.
  const std::string scene = "g.gsf --theta-i 30deg --resolution 0.01deg --sigma ";
  CHECK(verdict(advise(folder, scene + "5.2um"), "optics") == "geometric");
  CHECK(verdict(advise(folder, scene + "5.4um"), "optics") == "diffraction");
}

TEST_CASE("a shallow surface needs the wave even where nothing is seen apart", "[cli][advise]") {
  const Scratch folder;
  make(folder, "sinusoid --period 20um --height 50nm" + patch);
  const json advice = advise(folder, "g.gsf --theta-i 30deg --sigma 2um");
  CHECK(verdict(advice, "optics") == "diffraction");
  CHECK(advice.at("optics").at("decided_by").at("value") == "shallow");
}

TEST_CASE("a flat patch has its mirror lobe and nothing else", "[cli][advise]") {
  const Scratch folder;
  make(folder, "flat" + patch);
  const json advice = advise(folder, "g.gsf --theta-i 30deg");
  CHECK(verdict(advice, "optics") == "mirror");
  CHECK(verdict(advice, "spectrum") == "flat");
  CHECK(verdict(advice, "tilt") == "level");
  CHECK(verdict(advice, "scalar") == "no_period");
  CHECK(verdict(advice, "orders") == "no_period");
  CHECK(verdict(advice, "heights") == "fine_enough");
  CHECK_THAT(advice.at("optics").at("sentence").get<std::string>(), Catch::Contains("mirror lobe"));
}

TEST_CASE("scalar strengths of a fine lamellar grating are wrong at 75 deg", "[cli][advise]") {
  const Scratch folder;
  make(folder, "lamellar --period 1.15um --height 100nm" + patch);
  const json advice = advise(folder, "g.gsf --theta-i 75deg");
  CHECK(verdict(advice, "scalar") == "invalid");
  CHECK(advice.at("scalar").at("sentence") == "directions are right, strengths are not at 75 deg");
  const json& cases = advice.at("scalar").at("cases").at("value");
  REQUIRE(cases.size() == 2);
  CHECK(cases[0].at("limit_over_lambda") == 0.071);  // d / lambda = 3.03
  CHECK(cases[0].at("table") == "inside");
  CHECK(cases[1].at("table") == "below");
  CHECK(verdict(advice, "optics") == "diffraction");
}

TEST_CASE("scalar strengths of a smooth shallow grating are right at normal incidence",
          "[cli][advise]") {
  const Scratch folder;
  make(folder, "sinusoid --period 2.5um --height 100nm" + patch);
  CHECK(verdict(advise(folder, "g.gsf --theta-i 0deg"), "scalar") == "valid");
  CHECK(verdict(advise(folder, "g.gsf --theta-i 75deg"), "scalar") == "invalid");
}

TEST_CASE("the scalar verdict turns at the tabulated depth", "[cli][advise][crossover]") {
  const Scratch folder;
  // At 700 nm d / lambda is 3.57: at 75 deg the limits around are 0.087 and, where the period is
  // read low, 0.071 of the next shorter one.
  const std::string scene = "g.gsf --theta-i 75deg --lambda 700nm";
  make(folder, "sinusoid --period 2.6um --height 60nm" + patch);  // 0.0857
  CHECK(verdict(advise(folder, scene), "scalar") == "valid");
  make(folder, "sinusoid --period 2.6um --height 62nm" + patch);  // 0.0886
  CHECK(verdict(advise(folder, scene), "scalar") == "invalid");
  const json beyond = advise(folder, "g.gsf --theta-i 85deg --lambda 700nm");
  CHECK_THAT(beyond.at("scalar").at("sentence").get<std::string>(),
             Catch::Contains("the table ends at 75 deg"));
  CHECK(beyond.at("scalar").at("cases").at("value").at(0).at("limit_theta_i_deg") == 75.0);
}

TEST_CASE("the orders in view are those of the grating equation", "[cli][advise]") {
  const Scratch folder;
  make(folder, "sinusoid --period 2.5um --height 100nm" + patch);
  for (const double theta_i : {75.0, -75.0}) {
    const json advice =
        advise(folder, "g.gsf --lambda 500nm --theta-i " + std::to_string(theta_i) + "deg");
    CHECK(verdict(advice, "orders") == "in_view");
    const json& orders = advice.at("orders").at("cases").at("value").at(0);
    // m / 5 - sin theta_i within +-1: 1.97 x 5 = 9.83.
    CHECK(orders.at("first") == (theta_i > 0 ? 0 : -9));
    CHECK(orders.at("last") == (theta_i > 0 ? 9 : 0));
    for (const json& order : orders.at("nearest")) {
      const double sine = order.at("m").get<int>() / 5.0 - std::sin(theta_i * pi / 180);
      CHECK(std::sin(order.at("theta_r_deg").get<double>() * pi / 180) ==
            Approx(sine).margin(2e-3));
    }
  }
  // The lines run along the plane of incidence: the orders leave it sideways.
  CHECK(verdict(advise(folder, "g.gsf --theta-i 30deg --phi-i 90deg"), "orders") == "out_of_view");
  make(folder, "sinusoid --period 300nm --height 50nm --size 32.5um --pixels 650,65");
  CHECK(verdict(advise(folder, "g.gsf --theta-i 0deg --lambda 500nm"), "orders") == "mirror_only");
}

TEST_CASE("the steps recommended resolve a lobe, and coarser ones are named", "[cli][advise]") {
  const Scratch folder;
  make(folder, "sinusoid --period 2.5um --height 100nm" + patch);
  const std::string scene =
      "g.gsf --theta-i 75deg --surface periodic --sigma 16.25um --lambda 400:700:";
  const double third = 2 * std::sqrt(std::log(2.0)) * 0.4 / (2 * pi * 16.25) / 3;  // in the sine
  const json fine = advise(folder, scene + "0.4nm --theta-r -60:0:0.12deg");
  CHECK(verdict(fine, "steps") == "fine_enough");
  // At theta_r = 0: 0.1246 deg. At the largest |u|, sin 75 deg: 0.90 nm.
  CHECK(value(fine, "steps", "theta_r_needed") == Approx(third * 180 / pi));
  CHECK(value(fine, "steps", "theta_r") == Approx(0.1));
  CHECK(value(fine, "steps", "lambda_needed") == Approx(400 * third / std::sin(75 * pi / 180)));
  CHECK(value(fine, "steps", "lambda") == Approx(0.5));
  CHECK(verdict(advise(folder, scene + "0.4nm --theta-r -60:0:0.125deg"), "steps") == "too_coarse");
  CHECK(verdict(advise(folder, scene + "1nm --theta-r -60:0:0.12deg"), "steps") == "too_coarse");
  CHECK(verdict(advise(folder, "g.gsf --theta-i 75deg"), "steps") == "recommended");
}

TEST_CASE("the window's verdict follows the surface model", "[cli][advise]") {
  const Scratch folder;
  make(folder, "sinusoid --period 2.5um --height 100nm --size 20um --pixels 200");
  const auto window = [&](const std::string& options) {
    return verdict(advise(folder, "g.gsf --theta-i 30deg " + options), "window");
  };
  CHECK(window("") == "cut");  // exp(-2) = 0.135
  CHECK(window("--sigma 3um") == "smooth");
  CHECK(window("--surface periodic") == "repeated");
  CHECK(window("--replicas 3") == "even");
}
