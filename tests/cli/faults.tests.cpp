#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <deque>
#include <random>
#include <thread>

#include "tests/cli/gratings.h"
#include "tests/cli/outputs.h"
#include "tests/cli/sidecars.h"

namespace {

using Clock = std::chrono::steady_clock;

/// Half an hour of work, should nobody end it.
const std::string long_sweep =
    "sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.005deg --lambda 400:700:0.5nm "
    "--method direct -o R.csv";

/// The same commands with other numbers, each whole in some tenths of a second.
const std::vector<std::string> short_commands{
    "sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.1deg --lambda 400:700:10nm --method direct "
    "-o out.png",
    "map g.gsf --theta-i 30deg --size 64 --colour-tolerance 0.1 --surface periodic -o out.png",
    "plot R.csv -o out.png"};

void make_long(const Scratch& folder) {
  folder.prepare("synth blazed --period 2500nm --height 600nm --size 65um --pixels 650 -o g.gsf");
}

int kills() {
  const char* wanted = std::getenv("SHEDLIGHT_KILLS");
  return wanted == nullptr ? 20 : std::atoi(wanted);
}

Contents outputs(const Scratch& folder) {
  Contents all = folder.contents();
  std::erase_if(all, [](const auto& file) { return !file.first.starts_with("out."); });
  return all;
}

/// What a command leaves that nobody disturbs.
Contents finished_by(const Scratch& folder, const std::string& command,
                     const Environment& system = {}) {
  for (const auto& [name, bytes] : outputs(folder)) std::filesystem::remove(folder / name);
  const Outcome outcome = folder.shedlight(words(command), system);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return outputs(folder);
}

}  // namespace

TEST_CASE("whenever a run is killed, its outputs are whole or as they were", "[cli][fault]") {
  const Scratch folder;
  make_response(folder);
  constexpr unsigned seed = 20240229;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  int unchanged = 0;
  for (int i = 0; i < kills(); ++i) {
    const std::string command = short_commands[static_cast<std::size_t>(i) % 3];
    // Writing and renaming take microseconds: every other run spends most of its time on them.
    const Environment system = with_faults(i % 2 == 0 ? "" : "slow writes, slow renames");
    const auto began = Clock::now();
    const Contents finished = finished_by(folder, command, system);
    const std::chrono::duration<double> whole_run = Clock::now() - began;
    // Nothing there before, or something else of every file.
    const bool older = random() % 2 == 0;
    for (const auto& [name, bytes] : finished)
      if (older)
        folder.write(name, "older " + name);
      else
        std::filesystem::remove(folder / name);
    const Contents before = outputs(folder);

    Running run = folder.start(words(command), system);
    std::this_thread::sleep_for(std::uniform_real_distribution(0.0, 1.1)(random) * whole_run);
    run.signal(SIGKILL);
    const int code = run.wait().exit_code;
    wait_for_renaming(folder);
    const Contents after = outputs(folder);
    INFO(command << ", kill " << i << ", exit code " << code);
    const bool is_unchanged = after == before, is_finished = after == finished;
    unchanged += is_unchanged ? 1 : 0;
    CHECK((is_unchanged || is_finished));
    CHECK((code == 128 + SIGKILL || is_finished));
    CHECK(temporaries(folder).empty());
  }
  CHECK(unchanged > 0);  // the kills did come in time
}

TEST_CASE("a run that is killed between two renames leaves both files done", "[cli][fault]") {
  const Scratch folder;
  make_response(folder);
  for (const std::string& command : short_commands) {
    const Contents finished = finished_by(folder, command);
    for (const auto& [name, bytes] : finished) folder.write(name, "older");
    const Outcome outcome =
        folder.shedlight(words(command), with_faults("killed at the first rename, slow renames"));
    CHECK(outcome.exit_code == 128 + SIGKILL);
    wait_for_renaming(folder);
    const bool same = outputs(folder) == finished;
    CHECK(same);
    CHECK(temporaries(folder).empty());
  }
}

TEST_CASE("a signal ends a run as a shell expects, and nothing is left", "[cli][fault]") {
  const Scratch folder;
  make_long(folder);
  folder.write("R.csv", "older");
  const Contents before = folder.contents();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    for (const std::string faults : {"", "no unnamed files"}) {
      INFO("signal " << signal << " " << faults);
      Running run = folder.start(words(long_sweep), with_faults(faults));
      if (faults.empty())
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
      else
        CHECK(wait_for_temporaries(folder, 2));
      run.signal(signal);
      CHECK(run.wait().exit_code == 128 + signal);
      const bool same = folder.contents() == before;
      CHECK(same);
    }
}

TEST_CASE("a signal that was ignored stays ignored", "[cli][fault]") {
  const Scratch folder;
  make_response(folder);
  const Outcome outcome = folder.run(
      {"sh", "-c", "trap '' HUP; \"$0\" plot R.csv -o out.png & sleep 0.02; kill -HUP $!; wait $!",
       SHEDLIGHT_PROGRAM});
  CHECK(outcome.exit_code == 0);
  CHECK(folder.holds("out.png.json"));
}

TEST_CASE("names that killed runs have left are removed by the next, those of living runs are not",
          "[cli][fault]") {
  const Scratch folder;
  make_long(folder);
  folder.write("mine.tmp", "");
  folder.write(".shedlight-0123.tmp", "");
  {
    Running killed = folder.start(words(long_sweep), with_faults("no unnamed files"));
    REQUIRE(wait_for_temporaries(folder, 4));
    killed.signal(SIGKILL);
    killed.wait();
  }
  const std::vector<std::string> left = temporaries(folder);
  CHECK(left.size() == 4);  // such a system cannot do better
  Running living = folder.start(words(long_sweep), with_faults("no unnamed files"));
  const auto is_left = [&](const std::string& name) { return folder.holds(name); };
  REQUIRE(wait_until([&] { return std::ranges::count_if(left, is_left) == 2; }));
  REQUIRE(wait_for_temporaries(folder, 4));
  const std::vector<std::string> names = temporaries(folder);
  folder.prepare("synth flat --size 9um --pixels 9 -o flat.gsf");
  CHECK(temporaries(folder) == names);
  living.signal(SIGKILL);
  living.wait();
  folder.prepare("synth flat --size 9um --pixels 9 -o flat.gsf");
  CHECK(temporaries(folder) == std::vector<std::string>{".shedlight-0123.tmp", "mine.tmp"});
}

TEST_CASE("outputs are the same where files cannot be without a name", "[cli][fault]") {
  const Scratch folder;
  make_response(folder);
  for (const std::string& command : short_commands) {
    const Contents finished = finished_by(folder, command);
    CHECK(folder.shedlight(words(command), with_faults("no unnamed files")).exit_code == 0);
    const bool same = outputs(folder) == finished;
    CHECK(same);
    CHECK(temporaries(folder).empty());
    const auto permissions = [&](const std::string& name) {
      return std::filesystem::status(folder / name).permissions();
    };
    folder.write("plain", "");
    CHECK(permissions("out.png") == permissions("plain"));
  }
}

TEST_CASE("runs that write one output at once do not mix", "[cli][fault]") {
  const Scratch folder;
  make_response(folder);
  for (int round = 0; round < 10; ++round) {
    std::deque<Running> runs;
    for (int i = 1; i <= 4; ++i)
      runs.emplace_back(words(SHEDLIGHT_PROGRAM " synth sinusoid --period 3um --size 9um "
                                                "--pixels 9 -o s.gsf --height " +
                              std::to_string(100 * i) + "nm"),
                        folder.path(), with_faults("slow renames"), "");
    for (Running& run : runs) CHECK(run.wait().exit_code == 0);
    CHECK(sidecar_of(folder, "s.gsf").at("output").at("sha256") == sha256sum(folder, "s.gsf"));
  }
  std::deque<Running> maps;
  for (int i = 1; i <= 3; ++i)
    maps.emplace_back(words(SHEDLIGHT_PROGRAM " map g.gsf --size 32 --colour-tolerance 0.1 "
                                              "--surface periodic -o m.png --theta-i " +
                            std::to_string(10 * i) + "deg"),
                      folder.path(), with_faults("slow renames"), "");
  for (Running& run : maps) CHECK(run.wait().exit_code == 0);
  const nlohmann::json sidecar = sidecar_of(folder, "m.png");
  CHECK(sidecar.at("output").at("sha256") == sha256sum(folder, "m.png"));
  CHECK(sidecar.at("linear_xyz").at("sha256") == sha256sum(folder, "m.npy"));
}

TEST_CASE("a folder that a script holds for itself does not stop its runs", "[cli][fault]") {
  const Scratch folder;
  const Outcome outcome = folder.run({"flock", ".", SHEDLIGHT_PROGRAM, "synth", "flat", "--size",
                                      "9um", "--pixels", "9", "-o", "flat.gsf"});
  CHECK(outcome.exit_code == 0);
  CHECK(folder.holds("flat.gsf.json"));
}

TEST_CASE("outputs are synced before they are renamed, and their folder after", "[cli][fault]") {
  const Scratch folder;
  make_grating(folder);
  for (const std::string& command : short_commands) {
    if (command.starts_with("plot")) continue;
    INFO(command);
    for (const std::string unnamed : {"", " no unnamed files"}) {
      // A system on which a file that was renamed before it was synced is lost, and on which a run
      // fails at its end unless a folder was synced after the last renaming.
      const Outcome outcome = folder.shedlight(command, with_faults("power cuts" + unnamed));
      INFO(outcome.err);
      CHECK(outcome.exit_code == 0);
      CHECK(folder.holds("out.png.json"));
    }
  }
}
