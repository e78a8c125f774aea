#include <catch2/catch.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"

namespace {

const std::string sweep = "sweep g.gsf -o older.csv";
const std::string viewer = " --theta-r -50:-25:1deg";
const std::string light = " --theta-i 75deg";
const std::string colours = " --lambda 500:600:10nm";

}  // namespace

TEST_CASE("polar angles of 90 deg and more are refused", "[cli][refusal]") {
  const Scratch folder;
  make_response(folder);
  for (const std::string angle : {"90", "95", "-90", "450"})
    check_refused(folder, sweep + viewer + colours + " --theta-i " + angle + "deg", 2,
                  {angle, "90"});
  check_refused(folder, sweep + viewer + colours + " --theta-i 1.6rad", 2, {"90"});
  check_refused(folder, sweep + light + colours + " --theta-r -90:-25:1deg", 2, {"-90"});
  check_refused(folder, sweep + light + colours + " --theta-r 0:90:1deg", 2, {"90"});
  check_refused(folder, sweep + light + colours + " --theta-r -100:-95:1deg", 2, {"-100"});
  for (const std::string command :
       {"peaks R.csv -o older.csv", "period R.csv --by peaks", "plot R.csv -o older.csv"})
    check_refused(folder, command + " --theta-i 90deg", 2, {"90"});
}

TEST_CASE("angles just below 90 deg are taken", "[cli]") {
  const Scratch folder;
  make_grating(folder);
  const Outcome outcome =
      folder.shedlight(sweep + " --theta-i 89.9deg --theta-r -89.9:89.9:89.9deg --lambda 2um");
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
}

TEST_CASE("wavelengths of zero and below are refused", "[cli][refusal]") {
  const Scratch folder;
  make_grating(folder);
  for (const std::string lambda : {"0nm", "0:780:1nm", "-5:780:1nm", "-780:-380:1nm"})
    check_refused(folder, sweep + light + viewer + " --lambda " + lambda, 2,
                  {"wavelength", lambda.substr(0, lambda.find_first_of(":n"))});
}

TEST_CASE("ranges that are empty or incomplete are refused", "[cli][refusal]") {
  const Scratch folder;
  make_grating(folder);
  for (const std::string range :
       {"-25:-50:1deg", "-50:-25:0deg", "-50:-25:-1deg", "-50:-25deg", "-50:-25:1:1deg",
        "-50::1deg", ":-25:1deg", "::deg", ":::", "-50:-25:1deg:", "-50:nan:1deg",
        "-50:-25:1degree", "-50nm:-25:1deg"})
    check_refused(folder, sweep + light + colours + " --theta-r " + range, 2, {"--theta-r"});
  for (const std::string range : {"780:380:1nm", "380:780:0nm", "380:780:-1nm", "380:780nm",
                                  "380::1nm", "380:780:1e-30nm", "380:780:infnm"})
    check_refused(folder, sweep + light + viewer + " --lambda " + range, 2, {"--lambda"});
}

TEST_CASE("an azimuth outside the plane of incidence has no grating equation", "[cli][refusal]") {
  const Scratch folder;
  make_response(folder);
  for (const std::string command :
       {"peaks R.csv -o older.csv", "period R.csv --by peaks", "plot R.csv -o older.csv"})
    check_refused(folder, command + " --phi-r 30deg", 2, {"phi_r", "30"});
}
