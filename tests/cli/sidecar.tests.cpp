#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/sidecars.h"

using nlohmann::json;

namespace {

void check_made_by(const json& sidecar, const std::string& command) {
  CHECK_THAT(sidecar.at("shedlight").at("version").get<std::string>(),
             Catch::Matches("[0-9]+\\.[0-9]+\\.[0-9]+"));
  CHECK(sidecar.at("shedlight").at("commit").get<std::string>() != "");
  CHECK(sidecar.at("command") == command);
}

}  // namespace

TEST_CASE("every output has a sidecar with the hashes of input and output", "[cli][sidecar]") {
  const Scratch folder;
  make_response(folder);
  folder.prepare("peaks R.csv -o peaks.csv");
  folder.prepare("plot R.csv -o R.png");
  struct Step {
    std::string command, input, output;
  };
  for (const Step& step : {Step{"synth", "", "g.gsf"}, Step{"sweep", "g.gsf", "R.csv"},
                           Step{"peaks", "R.csv", "peaks.csv"}, Step{"plot", "R.csv", "R.png"}}) {
    INFO(step.command);
    const json sidecar = sidecar_of(folder, step.output);
    check_made_by(sidecar, step.command);
    CHECK(sidecar.at("output").at("sha256") == sha256sum(folder, step.output));
    CHECK(sidecar.at("output").at("file") == step.output);
    if (step.input.empty()) continue;
    CHECK(sidecar.at("input").at("sha256") == sha256sum(folder, step.input));
    CHECK(sidecar.at("input").at("file") == step.input);
  }
}

TEST_CASE("the sidecar of a sweep holds every parameter as resolved", "[cli][sidecar]") {
  const Scratch folder;
  make_grating(folder);
  folder.prepare(
      "sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.1deg --lambda 400:700:100nm -o R.csv");
  const json p = sidecar_of(folder, "R.csv").at("parameters");
  CHECK(p.at("theta_i_deg").get<double>() == Approx(75).epsilon(1e-14));
  CHECK(p.at("phi_i_deg") == 0.0);
  CHECK(p.at("phi_r_deg") == 0.0);
  CHECK(p.at("theta_r_deg").at("first") == -55.0);
  CHECK(p.at("theta_r_deg").at("last") == -40.0);
  CHECK(p.at("theta_r_deg").at("count") == 151);
  CHECK(p.at("lambda_nm").at("first") == 400.0);
  CHECK(p.at("lambda_nm").at("last") == 700.0);
  CHECK(p.at("lambda_nm").at("count") == 4);
  CHECK(p.at("method") == "auto");
  CHECK(p.at("surface") == "isolated");
  CHECK(p.at("tolerance") == 1e-6);
  CHECK(p.at("quantity") == "relative");
  CHECK(p.at("layout") == "matrix");
  CHECK(p.at("level") == "none");
  CHECK(p.at("reduce") == 1);
  CHECK(p.at("columns") == 260);
  CHECK(p.at("rows") == 1);
  CHECK(p.at("strict") == false);
  // By default a quarter of the shorter side, which is 0.25 um.
  CHECK(p.at("sigma_um").get<double>() == Approx(0.0625).epsilon(1e-6));
  folder.prepare(
      "sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.1deg --lambda 400nm --method taylor "
      "-o T.csv");
  const json taylor = sidecar_of(folder, "T.csv").at("parameters");
  CHECK(taylor.at("surface") == "periodic");
  CHECK(taylor.at("window_radius_sigma_f").get<double>() == Approx(6).margin(2));
}

TEST_CASE("the sidecar of a sweep holds what was asked for", "[cli][sidecar]") {
  const Scratch folder;
  folder.prepare(
      "synth blazed --period 2um --height 100nm --size 20um,2um --pixels 200,20 -o g.gsf");
  folder.prepare(
      "sweep g.gsf --theta-i 30deg --phi-i 90deg --phi-r 270deg --theta-r 0:10:1deg "
      "--lambda 500:600:10nm --sigma 4um --reduce 2 --level plane --pixel 100nm,200nm "
      "--quantity brdf --layout long --terms 25 --window-radius 5 --strict -o R.csv");
  const json p = sidecar_of(folder, "R.csv").at("parameters");
  CHECK(p.at("phi_i_deg").get<double>() == Approx(90).epsilon(1e-14));
  CHECK(p.at("phi_r_deg").get<double>() == Approx(270).epsilon(1e-14));
  CHECK(p.at("columns") == 100);
  CHECK(p.at("rows") == 10);
  CHECK(p.at("pixel_um").at(0).get<double>() == Approx(0.2).epsilon(1e-14));
  CHECK(p.at("pixel_um").at(1).get<double>() == Approx(0.4).epsilon(1e-14));
  CHECK(p.at("reduce") == 2);
  CHECK(p.at("level") == "plane");
  CHECK(p.at("sigma_um").get<double>() == Approx(4).epsilon(1e-14));
  CHECK(p.at("quantity") == "brdf");
  CHECK(p.at("layout") == "long");
  CHECK(p.at("terms") == 25);
  CHECK(p.at("window_radius_sigma_f") == 5.0);
  CHECK(p.at("strict") == true);
}

TEST_CASE("the sidecar of a sweep says what the method reports about its error", "[cli][sidecar]") {
  const Scratch folder;
  make_grating(folder);
  folder.prepare("sweep g.gsf" + small_scene + " --method chebyshev --tolerance 1e-7 -o R.csv");
  const json series = sidecar_of(folder, "R.csv").at("error");
  CHECK(series.at("amplitude_bound").get<double>() > 0);
  CHECK(series.at("amplitude_bound").get<double>() <= 1e-7);
  CHECK(series.at("terms").get<int>() > 5);
  CHECK(series.at("input_phase_error_rad").get<double>() > 0);
  folder.prepare("sweep g.gsf" + small_scene + " --terms 21 -o R.csv");
  CHECK(sidecar_of(folder, "R.csv").at("error").at("terms") == 21);
}

TEST_CASE("a sweep asked for JSON prints the sidecar that it wrote", "[cli][sidecar]") {
  const Scratch folder;
  make_grating(folder);
  const Outcome outcome = folder.shedlight("sweep g.gsf" + small_scene + " -o R.csv --json");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  CHECK(outcome.out == folder.read("R.csv.json"));
}

TEST_CASE("a file name of any characters stands in the sidecar as it is", "[cli][sidecar]") {
  const Scratch folder;
  make_grating(folder);
  const std::string name = "a \"quoted\" \\ name, \xC3\xBC.gsf";
  folder.write(name, folder.read("g.gsf"));
  Words command = words("sweep" + small_scene + " -o R.csv");
  command.insert(command.begin() + 1, name);
  REQUIRE(folder.shedlight(command).exit_code == 0);
  CHECK(sidecar_of(folder, "R.csv").at("input").at("file") == name);
}

TEST_CASE("options override what the sidecar says", "[cli][sidecar]") {
  const Scratch folder;
  make_response(folder);
  const auto period = [&](const std::string& options) {
    const Outcome outcome = folder.shedlight("period R.csv --json" + options);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return json::parse(outcome.out).at("period_nm").get<double>();
  };
  const double from_sidecar = period("");
  CHECK(period(" --theta-i 75deg") == from_sidecar);
  CHECK(std::abs(period(" --theta-i 74deg") - from_sidecar) > 1);
}

TEST_CASE("parameters of another type than they should be are as good as missing",
          "[cli][sidecar]") {
  const Scratch folder;
  make_response(folder);
  const json good = sidecar_of(folder, "R.csv");
  for (const std::string place : {"/parameters/quantity", "/parameters/preset",
                                  "/parameters/sigma_um", "/error/amplitude_bound"}) {
    json sidecar = good;
    sidecar[json::json_pointer(place)] = json::array({5});
    folder.write("R.csv.json", sidecar.dump());
    const Outcome outcome = folder.shedlight("period R.csv");
    CAPTURE(place);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err == "");
  }
}
