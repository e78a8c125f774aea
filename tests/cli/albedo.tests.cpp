#include <catch2/catch.hpp>

#include "tests/cli/refusal.h"
#include "tests/cli/sidecars.h"

namespace {

/// A flat patch of pixels fine enough for all directions at 550 nm.
void make_flat(const Scratch& folder) {
  folder.prepare("synth flat --size 2.6um --pixels 26 -o g.gsf");
}

const std::string periodic = " --surface periodic --sigma 16.25um --lambda 550nm --phi-i 30deg";

}  // namespace

TEST_CASE("albedos of a flat patch, flagged where they are outside the scalar theory",
          "[cli][albedo]") {
  const Scratch folder;
  make_flat(folder);
  const Outcome outcome =
      folder.shedlight("albedo g.gsf --theta-i 60:75:15deg" + periodic + " --tolerance 1e-10");
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 0);
  // Reference values of the closed form: 1.000102 and 1.001002.
  CHECK_THAT(outcome.out, Catch::Matches("theta_i_deg,lambda_nm,albedo,error_bound,directions,"
                                         "outside_scalar_theory\n"
                                         "60,550,1\\.00010[12][0-9]*,[-0-9.e]*,[0-9]*,\n"
                                         "75,550,1\\.00100[12][0-9]*,[-0-9.e]*,[0-9]*,yes\n"));
  check_warned(outcome, {"g.gsf", "1 of 2", "1.0010", "75 deg", "550 nm"});
}

TEST_CASE("albedos go into a file, and --strict refuses what is outside the theory",
          "[cli][albedo]") {
  const Scratch folder;
  make_flat(folder);
  folder.prepare("albedo g.gsf --theta-i 30deg" + periodic + " -o a.csv");
  CHECK_THAT(folder.read("a.csv"), Catch::Contains("\n30,550,1.0000"));
  CHECK(sidecar_of(folder, "a.csv")["parameters"]["sigma_um"] == 16.25);
  check_refused(folder, "albedo g.gsf --theta-i 75deg --strict -o older.csv" + periodic, 5,
                {"g.gsf", "scalar theory"});
}

TEST_CASE("albedos that make no sense are refused", "[cli][albedo]") {
  const Scratch folder;
  make_flat(folder);
  const std::string albedo = "albedo g.gsf --lambda 550nm -o older.csv --theta-i ";
  check_refused(folder, albedo + "90deg", 2, {"--theta-i", "90"});
  check_refused(folder, albedo + "1deg --quantity brdf", 2, {"--quantity"});
  check_refused(folder, albedo + "1deg --tolerance 0", 2, {"--tolerance", "0"});
  check_refused(folder, albedo + "1deg --method magic", 2, {"magic"});
  check_refused(folder, albedo + "1deg --replicas 1000000", 6, {"g.gsf", "1e9"});
  check_refused(folder, albedo + "1deg --surface periodic --sigma 1m", 6, {"g.gsf", "--sigma"});
  check_refused(folder, "albedo g.gsf --theta-i 1deg --lambda 0nm -o older.csv", 2, {"--lambda"});
  // 0.1 um pixels serve lambda / 2 and more where the light is along the normal.
  check_refused(folder, "albedo g.gsf --theta-i 0deg --lambda 199nm --strict -o older.csv", 5,
                {"g.gsf", "pixels", "199"});
  check_refused(folder, "albedo g.gsf --theta-i 0deg --lambda 201nm --strict -o older.csv", 5,
                {"g.gsf", "scalar theory", "201"});
}
