#include <catch2/catch.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/outputs.h"
#include "tests/cli/refusal.h"

namespace {

const std::string program = SHEDLIGHT_PROGRAM;

/// 60 kB or so of CSV.
const std::string sweep =
    " sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.1deg --lambda 400:700:20nm -o ";

/// Runs a script where `disk` is another file system, made by `mount ARGUMENTS disk`; false where
/// this machine lets nobody mount.
bool run_mounted(const Scratch& folder, const std::string& mount, const std::string& script,
                 Outcome& outcome) {
  std::filesystem::create_directory(folder / "disk");
  outcome = folder.run(
      {"unshare", "-rm", "sh", "-c", "mount " + mount + " disk 2>/dev/null || exit 77; " + script});
  if (outcome.exit_code != 77 && outcome.err.find("unshare") == std::string::npos) return true;
  WARN("skipped: no file system can be mounted here");
  return false;
}

void check_line(const Outcome& outcome, const std::vector<std::string>& named) {
  INFO(outcome.err);
  CHECK(outcome.exit_code == 4);
  CHECK(outcome.out == "");
  CHECK_THAT(outcome.err, Catch::Matches("shedlight: [^\n]*\n"));
  for (const std::string& part : named) CHECK_THAT(outcome.err, Catch::Contains(part));
}

}  // namespace

TEST_CASE("a disk that fills up leaves the older output", "[cli][fault]") {
  const Scratch folder;
  make_grating(folder);
  Outcome outcome;
  const std::string script = "echo older >disk/R.csv; " + program + sweep +
                             "disk/R.csv; code=$?; ls -A disk >names; "
                             "cat disk/R.csv >older; exit $code";
  if (!run_mounted(folder, "-t tmpfs -o size=32k none", script, outcome)) return;
  check_line(outcome, {"disk/R.csv", "No space left"});
  CHECK(folder.read("names") == "R.csv\n");
  CHECK(folder.read("older") == "older\n");
}

TEST_CASE("a folder that may only be read is refused before anything is computed", "[cli][fault]") {
  const Scratch folder;
  make_grating(folder);
  Outcome outcome;
  const std::string script =
      program +
      " sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.00001deg --lambda 400:700:1nm "
      "--method direct --memory-limit 1000GB -o disk/R.csv";
  if (!run_mounted(folder, "-t tmpfs -o ro none", script, outcome)) return;
  check_line(outcome, {"disk/R.csv", "Read-only file system"});
}

TEST_CASE("a limit on the size of files is an error, not a death", "[cli][fault]") {
  const Scratch folder;
  make_grating(folder);
  folder.write("R.csv", "older");
  const Contents before = folder.contents();
  Words command{"prlimit", "--fsize=10000", program};
  for (const std::string& word : words(sweep + "R.csv")) command.push_back(word);
  check_line(folder.run(command), {"R.csv", "File too large"});
  const bool same = folder.contents() == before;
  CHECK(same);
}

TEST_CASE("standard output that is closed is an error, and no output takes its place",
          "[cli][fault]") {
  const Scratch folder;
  make_response(folder);
  const Outcome closed =
      folder.run({"sh", "-c", "exec \"$0\" ridges R.csv -o ridges.csv >&-", SHEDLIGHT_PROGRAM});
  check_line(closed, {"standard output"});
  folder.prepare("ridges R.csv -o again.csv");
  const bool same = folder.read("ridges.csv") == folder.read("again.csv");
  CHECK(same);
}

TEST_CASE("standard error that takes nothing changes no exit code", "[cli][fault]") {
  const Scratch folder;
  for (const std::string target : {"2>&-", "2>/dev/full"})
    CHECK(folder.run({"sh", "-c", "exec \"$0\" nonsense " + target, SHEDLIGHT_PROGRAM}).exit_code ==
          2);
}
