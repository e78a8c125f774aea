#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"

namespace fs = std::filesystem;

namespace {

const std::string synth = "synth flat --size 9um --pixels 9 -o ";
const std::string sweep = "sweep g.gsf" + small_scene + " -o ";

/// Every command that writes a file.
void check_target_refused(const Scratch& folder, const std::string& target) {
  for (const std::string& command :
       {synth, sweep, std::string("peaks R.csv -o "), std::string("plot R.csv -o "),
        std::string("ridges R.csv -o "), std::string("ridges R.csv --plot "),
        std::string("precompute g.gsf --terms 3 -o "), std::string("colour R.csv -o "),
        std::string("render g.gsf --light 1deg,0deg -o "),
        std::string("map g.gsf --theta-i 1deg --size 16 -o "), std::string("bake g.gsf -o "),
        std::string("albedo g.gsf --theta-i 1deg --lambda 1um -o "),
        "tradeoff g.gsf" + small_scene + " -o ",
        "tradeoff g.gsf" + small_scene + " -o f.csv --plot ", std::string("stability -o "),
        std::string("stability --plot ")})
    check_refused(folder, command + target, 4, {target});
}

void check_standard_output_refused(const Scratch& folder, const std::string& command) {
  const Outcome outcome = folder.shedlight_into("/dev/full", command);
  INFO(command << "\n" << outcome.err);
  CHECK(outcome.exit_code == 4);
  CHECK_THAT(outcome.err, Catch::Matches("shedlight: [^\n]*standard output[^\n]*\n"));
}

}  // namespace

TEST_CASE("an output in a folder that is not there is refused", "[cli][output]") {
  const Scratch folder;
  make_response(folder);
  check_target_refused(folder, "nowhere/out.csv");
}

TEST_CASE("an output below a regular file is refused", "[cli][output]") {
  const Scratch folder;
  make_response(folder);
  check_target_refused(folder, "g.gsf/out.csv");
}

TEST_CASE("an output that is a folder is refused", "[cli][output]") {
  const Scratch folder;
  make_response(folder);
  fs::create_directory(folder / "sub");
  check_target_refused(folder, "sub");
  for (const std::string& command :
       {synth, sweep, std::string("peaks R.csv -o "), std::string("plot R.csv -o "),
        std::string("colour R.csv -o "), std::string("map g.gsf --theta-i 1deg --size 16 -o "),
        std::string("bake g.gsf --sigma 0.4um --colour-tolerance 0.1 -o "),
        std::string("render g.gsf --light 1deg,0deg -o ")})
    check_refused(folder, command + "sub/", 4, {"sub"});
}

TEST_CASE("an output whose sidecar cannot be written is refused", "[cli][output]") {
  const Scratch folder;
  make_response(folder);
  fs::create_directory(folder / "out.csv.json");
  check_target_refused(folder, "out.csv");
}

TEST_CASE("an output that is a device is refused", "[cli][output]") {
  const Scratch folder;
  make_response(folder);
  check_target_refused(folder, "/dev/full");
}

TEST_CASE("a target that cannot be written is found before anything is computed", "[cli][output]") {
  const Scratch folder;
  folder.prepare("synth blazed --period 2500nm --height 600nm --size 65um --pixels 650 -o g.gsf");
  // 1e6 directions over 4e5 pixels: hours, or the time limit where the order is wrong.
  check_refused(folder,
                "sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.01deg --lambda 380:1000:1nm "
                "--method direct --time-limit 5s -o nowhere/R.csv",
                4, {"nowhere/R.csv"});
}

TEST_CASE("results that standard output does not take are an error", "[cli][output]") {
  const Scratch folder;
  make_response(folder);
  for (const std::string& command :
       {"sweep g.gsf" + small_scene, std::string("peaks R.csv"),
        std::string("period R.csv --by peaks"), std::string("ridges R.csv"),
        std::string("colour R.csv"), std::string("period R.csv --by peaks --json"),
        std::string("info g.gsf"), std::string("info g.gsf --json"),
        std::string("advise g.gsf --theta-i 30deg"),
        "sweep g.gsf" + small_scene + " -o other.csv --json",
        std::string("validate R.csv R.csv --max-error 1"), std::string("validate --self"),
        std::string("render g.gsf --light 1deg,0deg --probe 0,0")})
    check_standard_output_refused(folder, command);
}

TEST_CASE("help that standard output does not take is an error", "[cli][output][help]") {
  const Scratch folder;
  for (const std::string command : {"--help", "sweep --help", "--version"})
    check_standard_output_refused(folder, command);
}

TEST_CASE("without gnuplot the refusal says so and the response stays as it was",
          "[cli][output][plot]") {
  const Scratch folder;
  make_response(folder);
  folder.write("older.png", "older");
  fs::create_directory(folder / "bin");
  check_refused(folder, words("plot R.csv -o older.png"), 4, {"gnuplot", "apt-get install"},
                {{"PATH", (folder / "bin").string()}});
}

TEST_CASE("a gnuplot that fails, or draws nothing, is an error in one line",
          "[cli][output][plot]") {
  const Scratch folder;
  make_response(folder);
  folder.write("older.png", "older");
  fs::create_directory(folder / "bin");
  for (const std::string script : {"#!/bin/sh\necho one line; echo another >&2; exit 3\n",
                                   "#!/bin/sh\nkill -9 $$\n", "#!/bin/sh\nexit 0\n"}) {
    folder.write("bin/gnuplot", script);
    fs::permissions(folder / "bin/gnuplot", fs::perms::owner_all);
    check_refused(folder, words("plot R.csv -o older.png"), 4, {"gnuplot"},
                  {{"PATH", (folder / "bin").string()}});
  }
}

TEST_CASE("an output that is written replaces the older one and its sidecar", "[cli][output]") {
  const Scratch folder;
  make_grating(folder);
  folder.write("R.csv", "older");
  folder.write("R.csv.json", "older");
  folder.prepare("sweep g.gsf" + small_scene + " -o R.csv");
  CHECK_THAT(folder.read("R.csv"), Catch::StartsWith("lambda_nm,"));
  CHECK_THAT(folder.read("R.csv.json"), Catch::StartsWith("{"));
  CHECK(folder.contents().size() == 4);  // the grating, the response, and their sidecars
}

TEST_CASE("an output through a link is written where the link points", "[cli][output]") {
  const Scratch folder;
  make_grating(folder);
  fs::create_directory(folder / "sub");
  folder.write("sub/R.csv", "older");
  fs::create_symlink("sub/R.csv", folder / "link.csv");
  folder.prepare("sweep g.gsf" + small_scene + " -o link.csv");
  CHECK(fs::is_symlink(folder / "link.csv"));
  CHECK_THAT(folder.read("sub/R.csv"), Catch::StartsWith("lambda_nm,"));
  CHECK(folder.shedlight("period link.csv --by peaks").exit_code == 0);
}
