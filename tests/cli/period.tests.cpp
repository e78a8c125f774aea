#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/periods.h"
#include "tests/cli/tables.h"

using nlohmann::json;

namespace {

/// A response with a Gaussian lobe where the grating equation puts order +1 of a period.
std::string lobes(double period_nm, double outlier_lambda_nm) {
  constexpr double deg = 3.14159265358979323846 / 180;
  std::string csv = "lambda_nm";
  for (int i = 0; i <= 150; ++i) csv += "," + std::to_string(-55 + i * 0.1);
  csv += "\n";
  for (double lambda = 400; lambda <= 700; lambda += 10) {
    const double d = lambda == outlier_lambda_nm ? period_nm * 1.02 : period_nm;
    csv += std::to_string(lambda);
    for (int i = 0; i <= 150; ++i) {
      const double off = std::sin((-55 + i * 0.1) * deg) + std::sin(75 * deg) - lambda / d;
      csv += "," + std::to_string(std::exp(-std::pow(off / 0.01, 2)));
    }
    csv += "\n";
  }
  return csv;
}

}  // namespace

TEST_CASE("period prints all that the fit knows as JSON", "[cli][period]") {
  const Scratch folder;
  make_response(folder);
  const json result = period(folder, "R.csv --order 1 --by peaks");
  for (const std::string key : {"period_nm", "std_error_nm", "source_mean_nm", "source_std_nm"}) {
    INFO(key);
    REQUIRE(result.contains(key));
    CHECK(result[key].is_number());
  }
  CHECK(result.at("order") == 1);
  CHECK(result.at("side").is_string());
  CHECK(result.at("outliers").is_array());
  CHECK(result.at("status") == "converged");
}

TEST_CASE("period speaks to people without being asked for JSON", "[cli][period]") {
  const Scratch folder;
  make_response(folder);
  const Outcome outcome = folder.shedlight("period R.csv --by peaks");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  CHECK_THAT(outcome.out, Catch::Contains("period") && Catch::Contains("nm") &&
                              Catch::Contains("standard error") && Catch::Contains("order"));
}

TEST_CASE("a period made by formula is found, with the wavelength that is off", "[cli][period]") {
  const Scratch folder;
  folder.write("R.csv", lobes(2500, 550));
  const json result = period(folder, "R.csv --theta-i 75deg");
  // Six digits in the file's lobes move a peak by 1e-5 of its width, 0.01 in sin theta_r.
  CHECK(result.at("period_nm").get<double>() == Approx(2500).margin(0.01));
  REQUIRE(result.at("outliers").size() == 1);
  CHECK(result.at("outliers")[0] == 550.0);
}

TEST_CASE("a blaze of 2500 nm is measured to 1 nm", "[cli][period]") {
  const Scratch folder;
  folder.prepare(
      "synth blazed --period 2500nm --height 600nm --size 65um --pixels 650 "
      "--facing +x -o g.gsf");
  folder.prepare(
      "sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.05deg --lambda 380:780:5nm -o R.csv");
  const json result = period(folder, "R.csv --order 1 --period-guess 2500nm");
  CHECK(result.at("by") == "lobes");
  CHECK(std::abs(result.at("period_nm").get<double>() - 2500) <= 1);
  CHECK(result.at("interval_nm")[0].get<double>() <= 2500);
  CHECK(result.at("interval_nm")[1].get<double>() >= 2500);
  // Known to be without edges the interval would be too narrow for a blaze; it is narrower.
  const json smooth =
      period(folder, "R.csv --order 1 --period-guess 2500nm --relief smooth").at("interval_nm");
  CHECK(smooth[1].get<double>() - smooth[0].get<double>() <
        result.at("interval_nm")[1].get<double>() - result.at("interval_nm")[0].get<double>());
  CHECK(result.at("peaks").at("side") == "towards the light");
}

TEST_CASE("a blaze turned round sends its light into order -1", "[cli][period]") {
  const Scratch folder;
  for (const auto& [facing, order, angles] :
       {std::tuple{"+x", "1", "5:25:0.05deg"}, std::tuple{"-x", "-1", "-25:-5:0.05deg"}}) {
    folder.prepare(
        "synth blazed --period 2500nm --height 270nm --size 65um --pixels 650 -o g.gsf "
        "--facing " +
        std::string(facing));
    folder.prepare("sweep g.gsf --theta-i 0deg --lambda 400:700:20nm -o R.csv --theta-r " +
                   std::string(angles));
    const json result = period(folder, "R.csv --by peaks --order " + std::string(order));
    INFO(facing << " " << result.dump());
    CHECK(result.at("order") == std::stoi(order));
    // The lobes of a strong order lie right to some tenths of a nanometre.
    CHECK(std::abs(result.at("period_nm").get<double>() - 2500) <= 2);
    // A blaze of half a wavelength's height puts most of its light into the one order.
    const std::vector<Cells> peaks =
        table_of(folder.shedlight("peaks R.csv --order " + std::string(order)).out);
    for (std::size_t row = 5; row < peaks.size(); ++row) CHECK(value_of(peaks[row][3]) > 0.3);
  }
}

TEST_CASE("the azimuths of the sidecar put the viewer on the right side", "[cli][period]") {
  const Scratch folder;
  make_grating(folder);
  folder.prepare("sweep g.gsf" + small_scene + " -o same.csv");
  folder.prepare(
      "sweep g.gsf --theta-i 75deg --theta-r 40:55:0.1deg --lambda 400:700:100nm "
      "--sigma 16.25um --phi-r 180deg -o opposite.csv");
  const double same = period(folder, "same.csv --by peaks").at("period_nm").get<double>();
  // The same directions in the other order; only the rounding of sines differs.
  CHECK(period(folder, "opposite.csv --by peaks").at("period_nm").get<double>() ==
        Approx(same).margin(1e-6));
}
