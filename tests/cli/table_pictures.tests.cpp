#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/cli/gratings.h"
#include "tests/cli/pictures.h"
#include "tests/cli/refusal.h"
#include "tests/cli/sidecars.h"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string precompute = "precompute g.gsf --terms 6 -o t.npy";

}  // namespace

TEST_CASE("pictures are drawn of the extrema and of the first 8 tables",
          "[cli][precompute][plot]") {
  const Scratch folder;
  make_small(folder);
  for (const int terms : {1, 3, 12}) {
    const std::string pics = "pics" + std::to_string(terms);
    const Outcome outcome = folder.shedlight("precompute g.gsf -o t.npy --terms " +
                                             std::to_string(terms) + " --pictures " + pics);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err == "");
    const json pictures = sidecar_of(folder, "t.npy").at("pictures");
    const int drawn = std::min(terms, 8) + 1;
    CHECK(pictures.size() == static_cast<std::size_t>(drawn));
    CHECK(std::distance(fs::directory_iterator(folder / pics), {}) == drawn);
    for (const json& picture : pictures) {
      const std::string file = picture.at("file");
      CAPTURE(file);
      check_picture(folder.read(file));
      CHECK(picture.at("sha256") == sha256sum(folder, file));
    }
    CHECK(folder.holds(pics + "/extrema.png"));
    CHECK(folder.holds(pics + "/power_" + std::to_string(drawn - 2) + ".png"));
  }
}

TEST_CASE("tables of one row, one pixel, a flat field or many bins are made and drawn",
          "[cli][precompute][plot]") {
  const Scratch folder;
  for (const std::string grating :
       {"blazed --period 2um --height 1um --size 26um,0.25um --pixels 260,1",
        "flat --size 1um --pixels 1", "flat --size 8um --pixels 8",
        "blazed --period 2um --height 1um --size 30um,0.2um --pixels 3001,2"}) {
    INFO(grating);
    folder.prepare("synth " + grating + " -o g.gsf");
    const Outcome outcome = folder.shedlight(precompute + " --normalise extrema --pictures pics");
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    check_picture(folder.read("pics/extrema.png"));
    check_picture(folder.read("pics/power_5.png"));
  }
}

TEST_CASE("pictures go into a folder that is there, beside what it holds",
          "[cli][precompute][output]") {
  const Scratch folder;
  make_small(folder);
  fs::create_directory(folder / "pics");
  folder.write("pics/mine.txt", "mine");
  folder.write("pics/extrema.png", "older");
  folder.prepare(precompute + " --pictures pics");
  CHECK(folder.read("pics/mine.txt") == "mine");
  check_picture(folder.read("pics/extrema.png"));
}

TEST_CASE("pictures that cannot be put in place are refused, and older files stay",
          "[cli][precompute][refusal]") {
  const Scratch folder;
  make_small(folder);
  const std::string to_older = " -o older.csv";
  const std::string pictures = "precompute g.gsf --terms 3 --pictures pics";
  check_refused(folder, "precompute missing.gsf --terms 3 --pictures pics" + to_older, 3,
                {"missing.gsf"});
  check_refused(folder, "precompute g.gsf --terms 3 --pictures none/pics" + to_older, 4,
                {"none/pics"});
  check_refused(folder, "precompute g.gsf --terms 3 --pictures g.gsf" + to_older, 4, {"g.gsf"});
  const auto check_same_file_refused = [&] {
    check_refused(folder, pictures + " -o pics/extrema.png", 2, {"pics/extrema.png", "pictures"});
    check_refused(folder, pictures + " -o ./pics/../pics/power_2.png", 2, {"power_2.png"});
  };
  check_same_file_refused();
  fs::create_directories(folder / "pics/power_1.png");
  check_refused(folder, pictures + to_older, 4, {"pics/power_1.png", "regular file"});
  fs::remove(folder / "pics/power_1.png");
  check_same_file_refused();
  folder.write("pics/power_0.png", folder.read("g.gsf"));
  check_refused(folder, "precompute pics/power_0.png --terms 3 --pictures pics" + to_older, 2,
                {"pics/power_0.png", "input"});
}

TEST_CASE("without gnuplot there are neither pictures nor tables", "[cli][precompute][output]") {
  const Scratch folder;
  make_small(folder);
  fs::create_directory(folder / "bin");
  const Environment no_gnuplot{{"PATH", (folder / "bin").string()}};
  check_refused(folder, words("precompute g.gsf --terms 3 --pictures pics -o older.csv"), 4,
                {"gnuplot"}, no_gnuplot);
  // And none is needed where no picture is asked for.
  CHECK(folder.shedlight(words(precompute), no_gnuplot).exit_code == 0);
}
