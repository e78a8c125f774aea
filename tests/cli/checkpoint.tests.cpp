#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <random>

#include "tests/cli/gratings.h"
#include "tests/cli/outputs.h"
#include "tests/cli/refusal.h"

namespace {

/// A second or so each on an idle machine, in dozens of chunks.
const std::string sweep =
    "sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.5deg --lambda 400:700:2nm --method direct";
const std::vector<std::string> long_commands{
    sweep + " -o out.csv",
    "map small.gsf --theta-i 30deg --size 64 --method direct --lambda 380:780:2nm "
    "-o out.png",
    "bake small.gsf --method direct --sigma 1um --colour-tolerance 0.3 -o out.npy"};
const std::string keeping = " --checkpoint kept";

void make_surfaces(const Scratch& folder) {
  folder.prepare("synth blazed --period 2500nm --height 600nm --size 65um --pixels 325 -o g.gsf");
  folder.prepare("synth blazed --period 2500nm --height 600nm --size 6um --pixels 40 -o small.gsf");
}

Contents outputs(const Scratch& folder) {
  Contents all = folder.contents();
  std::erase_if(all, [](const auto& file) { return !file.first.starts_with("out."); });
  return all;
}

/// Outputs of a run without a checkpoint, which are removed again.
Contents reference(const Scratch& folder, const std::string& command) {
  for (const auto& [name, bytes] : outputs(folder)) std::filesystem::remove(folder / name);
  folder.prepare(command);
  const Contents all = outputs(folder);
  for (const auto& [name, bytes] : all) std::filesystem::remove(folder / name);
  return all;
}

/// The same command until its time is up, after a few chunks.
void interrupt(const Scratch& folder, const std::string& command) {
  for (int ms = 100; ms < 100'000; ms += ms / 2) {
    const Outcome outcome =
        folder.shedlight(command + keeping + " --time-limit " + std::to_string(ms) + "ms");
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 6);
    CHECK_THAT(outcome.err, Catch::Contains("--time-limit"));
    CHECK(outputs(folder).empty());
    const std::string kept = folder.holds("kept") ? folder.read("kept") : "";
    if (kept.empty()) continue;  // the time was up before
    CHECK_THAT(outcome.err, Catch::Contains("kept keeps what is done"));
    const std::size_t head = kept.find('\n', 90) + 1;
    if (std::count(kept.begin() + static_cast<std::ptrdiff_t>(head), kept.end(), '\0') <
        static_cast<std::ptrdiff_t>(kept.size() - head))
      return;
  }
  FAIL("no chunk was ever kept");
}

/// Where the slots lie, by the head.
struct Slots {
  explicit Slots(const std::string& kept) {
    first = kept.find('\n', 90) + 1;  // behind magic and hash
    const std::string key = "\"bytes\":";
    size = 64 + std::stoul(kept.substr(kept.rfind(key, first) + key.size()));
    for (std::size_t at = first; at + size <= kept.size(); at += size)
      if (kept[at] != '\0') done.push_back(at);
  }
  std::size_t first, size;
  std::vector<std::size_t> done;
};

/// Goes on to the end. Returns what was said.
std::string finish(const Scratch& folder, const std::string& command, const Contents& expected) {
  const Outcome outcome = folder.shedlight(command + keeping + " --threads 1");
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  const bool same = outputs(folder) == expected;
  CHECK(same);
  CHECK_FALSE(folder.holds("kept"));
  CHECK(temporaries(folder).empty());
  return outcome.err;
}

}  // namespace

TEST_CASE("a run that goes on from a checkpoint gives the same bytes", "[cli][checkpoint]") {
  const Scratch folder;
  make_surfaces(folder);
  for (const std::string& command : long_commands) {
    INFO(command);
    const Contents expected = reference(folder, command);
    interrupt(folder, command);
    const std::size_t done = Slots(folder.read("kept")).done.size();
    const std::string said = finish(folder, command, expected);
    CHECK(done > 0);
    CHECK_THAT(said, Catch::Contains("kept: " + std::to_string(done) + " of ") &&
                         Catch::Contains("taken over, 0 damaged"));
  }
}

TEST_CASE("a run that is killed again and again gives the same bytes", "[cli][checkpoint][fault]") {
  const Scratch folder;
  make_surfaces(folder);
  std::mt19937 random(7);
  for (const std::string& command : long_commands) {
    INFO(command);
    const Contents expected = reference(folder, command);
    for (int kill = 0; kill < 4; ++kill) {
      Running run = folder.start(words(command + keeping));
      std::this_thread::sleep_for(std::chrono::milliseconds(random() % 300));
      run.signal(SIGKILL);
      run.wait();
      wait_for_renaming(folder);
    }
    // Also where a run was done before it was killed, and one after it began anew.
    finish(folder, command, expected);
  }
}

TEST_CASE("a damaged chunk is computed anew", "[cli][checkpoint]") {
  const Scratch folder;
  make_surfaces(folder);
  const std::string command = long_commands.front();
  const Contents expected = reference(folder, command);
  interrupt(folder, command);
  const std::string kept = folder.read("kept");
  const Slots slots(kept);
  REQUIRE(!slots.done.empty());
  const auto check_damaged = [&](const std::string& damaged, const std::string& what) {
    for (const auto& [name, bytes] : outputs(folder)) std::filesystem::remove(folder / name);
    folder.write("kept", damaged);
    CHECK_THAT(finish(folder, command, expected), Catch::Contains(what));
  };
  const std::size_t slot = slots.done.back();
  const std::string others = std::to_string(slots.done.size() - 1) + " of 151 chunks taken over, 1";
  for (const std::size_t at : {slot + 3, slot + 64 + 7, slot + slots.size - 1}) {
    std::string damaged = kept;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    check_damaged(damaged, others);
  }
  // A chunk in another's place, one half written, and a file cut off.
  std::string moved = kept;
  const std::size_t empty = slots.first + slots.size * 150;
  REQUIRE(kept[empty] == '\0');
  moved.replace(empty, slots.size, kept.substr(slot, slots.size));
  check_damaged(moved, " 1 damaged");
  std::string torn = kept;
  std::fill_n(torn.begin() + static_cast<std::ptrdiff_t>(slot + slots.size / 2), slots.size / 2,
              '\0');
  check_damaged(torn, others);
  check_damaged(kept.substr(0, slot + 100), " damaged");
}

TEST_CASE("a checkpoint with a damaged head, and what is none, are refused", "[cli][checkpoint]") {
  const Scratch folder;
  make_surfaces(folder);
  interrupt(folder, long_commands.front());
  const std::string kept = folder.read("kept"), again = sweep + " -o older.csv" + keeping;
  for (const std::size_t at : {std::size_t{3}, std::size_t{40}, std::size_t{200}}) {
    std::string damaged = kept;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    folder.write("kept", damaged);
    check_refused(folder, again, 3, {"kept", "head is damaged"});
  }
  for (const std::string& bytes : {std::string(), std::string("mine"), kept.substr(0, 100)}) {
    folder.write("kept", bytes);
    check_refused(folder, again, 3, {"kept"});
  }
  check_refused(folder, sweep + " -o older.csv --checkpoint nowhere/kept", 4, {"nowhere/kept"});
  std::filesystem::create_directory(folder / "sub");
  check_refused(folder, sweep + " -o older.csv --checkpoint sub", 4, {"sub"});
}

TEST_CASE("a checkpoint of another request is refused by what differs", "[cli][checkpoint]") {
  const Scratch folder;
  make_surfaces(folder);
  interrupt(folder, long_commands.front());
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string command = sweep + " -o older.csv" + keeping;
    return command.replace(command.find(from), from.size(), to);
  };
  check_refused(folder, changed("400:700", "400:690"), 3, {"kept", "lambda_nm", "700", "690"});
  check_refused(folder, changed("75deg", "74deg"), 3, {"kept", "theta_i_deg", "75", "74"});
  check_refused(folder, changed("direct", "direct --sigma 9um"), 3, {"kept", "sigma_um", "9"});
  check_refused(folder, changed("direct", "direct --quantity power"), 3, {"kept", "quantity"});
  check_refused(folder, changed("g.gsf", "g.gsf --level plane"), 3, {"kept", "level", "plane"});
  check_refused(folder, changed("g.gsf", "small.gsf"), 3, {"kept", "input.sha256"});
  check_refused(folder, "map small.gsf --theta-i 10deg --size 64 -o older.png" + keeping, 3,
                {"kept", "command"});
  // What does not change a number is free: the file's name, and the output's.
  std::filesystem::copy(folder / "g.gsf", folder / "same.gsf");
  CHECK(folder.shedlight(changed("g.gsf", "same.gsf") + " --memory-limit 1GB").exit_code == 0);
}

TEST_CASE("two runs do not share a checkpoint", "[cli][checkpoint]") {
  const Scratch folder;
  make_surfaces(folder);
  Running first = folder.start(words(long_commands.front() + keeping));
  REQUIRE(wait_until([&] { return folder.holds("kept"); }));
  const Outcome second = folder.shedlight(sweep + " -o second.csv" + keeping);
  CHECK(second.exit_code == 3);
  CHECK_THAT(second.err, Catch::Matches("shedlight: [^\n]*kept: another run [^\n]*\n"));
  CHECK(first.wait().exit_code == 0);
}
