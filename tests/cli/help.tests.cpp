#include <catch2/catch.hpp>

#include "tests/cli/refusal.h"

TEST_CASE("help at every level exits 0 and shows a worked example", "[cli][help]") {
  const Scratch folder;
  for (const std::string command :
       {"",        "synth ",  "info ",     "convert ",   "advise ",   "precompute ", "sweep ",
        "peaks ",  "period ", "ridges ",   "plot ",      "colour ",   "map ",        "bake ",
        "render ", "albedo ", "tradeoff ", "stability ", "validate ", "completion ", "manual "}) {
    for (const std::string help : {"--help", "-h"}) {
      const Outcome outcome = folder.shedlight(command + help);
      INFO(command << help);
      CHECK(outcome.exit_code == 0);
      CHECK(outcome.err == "");
      CHECK_THAT(outcome.out,
                 Catch::Contains("Example") && Catch::Contains("shedlight " + command));
    }
  }
}

TEST_CASE("the version is printed on standard output", "[cli][help]") {
  const Scratch folder;
  const Outcome outcome = folder.shedlight("--version");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  CHECK_THAT(outcome.out,
             Catch::Matches("shedlight [0-9]+\\.[0-9]+\\.[0-9]+.*\nreads PNG, .*gwy.*NumPy.*\n"));
}

TEST_CASE("without a subcommand nothing is done and the exit code is 2", "[cli][refusal]") {
  const Scratch folder;
  check_refused(folder, "", 2, {"command", "sweep"});
}

TEST_CASE("an unknown subcommand or option is named and refused", "[cli][refusal]") {
  const Scratch folder;
  check_refused(folder, "frobnicate", 2, {"frobnicate"});
  check_refused(folder, "frobnicate --help-me", 2, {"frobnicate"});
  check_refused(folder, "--frobnicate", 2, {"--frobnicate"});
  for (const std::string command :
       {"synth flat --size 9um --pixels 9 -o older.csv", "info x.png", "convert x.png -o older.csv",
        "albedo x.png --theta-i 1deg --lambda 1um -o older.csv",
        "tradeoff x.png --theta-i 1deg --theta-r 1deg --lambda 1um -o older.csv",
        "stability -o older.csv", "advise x.png --theta-i 1deg",
        "sweep x.png --theta-i 75deg --theta-r -5deg --lambda 1um", "peaks R.csv", "period R.csv",
        "ridges R.csv", "precompute x.png --terms 3 -o older.csv", "plot R.csv -o older.csv",
        "colour R.csv", "map x.png --theta-i 1deg -o older.csv", "bake x.png -o older.csv",
        "render x.png --light 1deg,0deg -o older.csv", "validate a.csv b.csv --max-error 1"})
    check_refused(folder, command + " --frobnicate", 2, {"--frobnicate"});
}

TEST_CASE("a missing argument is named and refused", "[cli][refusal]") {
  const Scratch folder;
  check_refused(folder, "sweep g.gsf --theta-r -50:-25:1deg --lambda 550nm", 2, {"--theta-i"});
  check_refused(folder, "sweep g.gsf --theta-i 75deg --lambda 550nm", 2, {"--theta-r"});
  check_refused(folder, "sweep g.gsf --theta-i 75deg --theta-r -50:-25:1deg", 2, {"--lambda"});
  check_refused(folder, "sweep --theta-i 75deg --theta-r -5deg --lambda 550nm", 2, {"file"});
  check_refused(folder, "info", 2, {"file"});
  check_refused(folder, "convert g.gsf", 2, {"--output"});
  check_refused(folder, "convert -o older.csv", 2, {"file"});
  check_refused(folder, "advise g.gsf", 2, {"--theta-i"});
  check_refused(folder, "advise --theta-i 1deg", 2, {"file"});
  check_refused(folder, "plot R.csv", 2, {"--output"});
  check_refused(folder, "precompute g.gsf --terms 3", 2, {"--output"});
  check_refused(folder, "precompute g.gsf -o t.npy", 2, {"--terms"});
  check_refused(folder, "colour", 2, {"response"});
  check_refused(folder, "ridges", 2, {"response"});
  check_refused(folder, "map g.gsf -o older.csv", 2, {"--theta-i"});
  check_refused(folder, "map g.gsf --theta-i 1deg", 2, {"--output"});
  check_refused(folder, "map --theta-i 1deg -o older.csv", 2, {"file"});
  check_refused(folder, "bake g.gsf", 2, {"--output"});
  check_refused(folder, "bake -o older.csv", 2, {"file"});
  check_refused(folder, "render g.gsf -o older.csv", 2, {"--light"});
  check_refused(folder, "validate a.csv b.csv", 2, {"--max-error"});
  check_refused(folder, "validate a.csv --max-error 1", 2, {"reference"});
  check_refused(folder, "validate --max-error 1", 2, {"response"});
  check_refused(folder, "synth blazed --period 1um --height 1um --size 9um --pixels 9", 2,
                {"--output"});
}
