#include <catch2/catch.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"

namespace {

const std::string sweep = "sweep g.gsf -o older.csv --sigma 16.25um --theta-i 75deg";
const std::string too_few_terms =
    sweep + " --theta-r -55:-40:0.1deg --lambda 400:700:100nm --terms 3";
// Pixels of 250 nm at 400 nm: sin theta_r must stay below 0.8 - sin 75 deg, so -9.551 deg.
const std::string past_nyquist = sweep + " --theta-r -20:10:0.01deg --lambda 400:700:100nm";

}  // namespace

TEST_CASE("too few terms warn, and are refused where strict", "[cli][strict]") {
  const Scratch folder;
  make_grating(folder);
  check_refused(folder, too_few_terms + " --strict", 5, {"g.gsf", "bound", "0.01"});
  check_warned(folder.shedlight(too_few_terms), {"g.gsf", "bound", "0.01"});
  CHECK_THAT(folder.read(older_output), Catch::StartsWith("lambda_nm,-55.0"));
}

TEST_CASE("enough terms neither warn nor are refused", "[cli][strict]") {
  const Scratch folder;
  make_grating(folder);
  const Outcome outcome = folder.shedlight(
      sweep + " --theta-r -55:-40:0.1deg --lambda 400:700:100nm --terms 40 --strict");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
}

TEST_CASE(
    "angles past the Nyquist limit warn with the largest safe one, and are refused where "
    "strict",
    "[cli][strict]") {
  const Scratch folder;
  make_grating(folder);
  const std::vector<std::string> named{"g.gsf", "400", "Nyquist", "-9.5"};
  check_refused(folder, past_nyquist + " --strict", 5, named);
  check_warned(folder.shedlight(past_nyquist), named);
  CHECK_THAT(folder.read(older_output), Catch::StartsWith("lambda_nm,-20.00"));
}

TEST_CASE("angles inside the Nyquist limit neither warn nor are refused", "[cli][strict]") {
  const Scratch folder;
  make_grating(folder);
  const Outcome outcome =
      folder.shedlight(sweep + " --theta-r -20:-9.56:0.01deg --lambda 400:700:100nm --strict");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
}

TEST_CASE("coarse stored heights are reported as an error of the input, never a failure",
          "[cli][strict]") {
  const Scratch folder;
  make_grating(folder);
  const Outcome outcome =
      folder.shedlight(sweep + " --theta-r -55:-40:0.1deg --lambda 400:700:100nm --strict");
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(folder.read(older_output + ".json"), Catch::Contains("input_phase_error_rad"));
}

TEST_CASE("a response without peaks has no period", "[cli][period]") {
  const Scratch folder;
  // The brightest angle lies on the edge at every wavelength.
  folder.write("edge.csv", "lambda_nm,-50,-49,-48\n500,3,2,1\n510,1,2,3\n520,3,2,1\n");
  check_refused(folder, "period edge.csv --theta-i 75deg", 5, {"edge.csv", "peak"});
  check_refused(folder, "period edge.csv --theta-i 75deg --json", 5, {"edge.csv", "peak"});
  folder.write("one.csv", "lambda_nm,-50,-49,-48\n500,1,2,1\n510,1,2,3\n520,3,2,1\n");
  check_refused(folder, "period one.csv --theta-i 75deg", 5, {"one.csv", "peak"});
}

TEST_CASE("a flat patch has no period", "[cli][period]") {
  const Scratch folder;
  folder.prepare("synth flat --size 65um,0.25um --pixels 260,1 -o g.gsf");
  folder.prepare("sweep g.gsf" + small_scene + " --surface periodic -o R.csv");
  check_refused(folder, "period R.csv --order 1", 5, {"R.csv", "peak"});
}

TEST_CASE("the mirror direction has no period", "[cli][period]") {
  const Scratch folder;
  make_response(folder);
  check_refused(folder, "period R.csv --order 0", 5, {"order 0"});
}

TEST_CASE("a file name with a line break still gives one line", "[cli][refusal]") {
  const Scratch folder;
  make_grating(folder);
  const std::string name = "two\nlines.gsf";
  check_refused(folder, words("info") + name, 3, {"lines.gsf"});
  check_refused(folder, words("info g.gsf") + name, 2, {"lines.gsf"});
  folder.write(name, folder.read("g.gsf"));
  check_warned(folder.shedlight(words("sweep --theta-i 75deg --theta-r -20:10:5deg --lambda 400nm "
                                      "--sigma 16.25um") +
                                name),
               {"lines.gsf", "Nyquist"});
}
