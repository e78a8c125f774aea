#include <catch2/catch.hpp>
#include <string>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"
#include "tests/cli/sidecars.h"

namespace {

const std::string bake = "bake g.gsf --sigma 0.4um --colour-tolerance 5e-2 ";

/// A folder with g.gsf and its volume v.npy.
void make_volume(const Scratch& folder) {
  make_small(folder);
  folder.prepare(bake + "-o v.npy");
}

}  // namespace

TEST_CASE("a map from a volume is the map from the heights", "[cli][bake][oracle]") {
  const Scratch folder;
  make_volume(folder);
  for (const std::string optics : {"", " --fresnel schlick --shadowing v-cavity"}) {
    const std::string light = " --theta-i 35deg --phi-i 10deg --size 40 --exposure 3" + optics;
    folder.prepare("map v.npy" + light + " -o baked.png");
    folder.prepare("map g.gsf --sigma 0.4um" + light + " -o direct.png");
    // CIEDE2000 of 1 is just noticeable; the volume was asked for 5 % at its rarest.
    folder.prepare("validate baked.npy direct.npy --exposure 3 --max-error 1");
  }
  const auto sidecar = sidecar_of(folder, "v.npy");
  CHECK(sidecar["command"] == "bake");
  CHECK(sidecar["error"]["volume"]["rms_of_local_brightness"].get<double>() <= 5e-2);
  CHECK(sidecar["volume"]["terms"].get<int>() > 2);
  // Another surface is another colour: the comparison can fail.
  folder.prepare(
      "synth blazed --period 900nm --height 300nm --size 2.4um,1um --pixels 24,10 -o h.gsf");
  folder.prepare(
      "map h.gsf --sigma 0.4um --theta-i 35deg --phi-i 10deg --size 40 --exposure 3 "
      "-o other.png");
  CHECK(folder.shedlight("validate other.npy direct.npy --exposure 3 --max-error 1").exit_code ==
        1);
}

TEST_CASE("a volume has the same bytes for any number of threads", "[cli][bake]") {
  const Scratch folder;
  make_volume(folder);
  folder.prepare(bake + "--threads 3 -o w.npy");
  CHECK(folder.read("v.npy") == folder.read("w.npy"));
}

TEST_CASE("what was decided when a volume was baked is refused beside it", "[cli][bake][refusal]") {
  const Scratch folder;
  make_volume(folder);
  for (const std::string option :
       {"--sigma 1um", "--width 3um", "--lambda 400:700:5nm", "--tolerance 1e-3", "--method direct",
        "--surface periodic", "--reduce 2", "--orders-only --period 1um", "--audit 3"})
    check_refused(folder, "map v.npy --theta-i 10deg " + option + " -o m.png", 2,
                  {option.substr(0, option.find(' ')), "volume"});
  check_refused(folder, "map v.npy --theta-i 10deg --quantity radiance -o m.png", 2,
                {"--quantity radiance", "relative"});
  check_refused(folder, "bake v.npy -o w.npy", 2, {"v.npy", "volume already"});
  check_refused(folder, "bake g.gsf --method lambert -o w.npy", 2, {"lambert"});
}

TEST_CASE("a volume that is damaged or alone is refused", "[cli][bake][refusal]") {
  const Scratch folder;
  make_volume(folder);
  const std::string bytes = folder.read("v.npy"), sidecar = folder.read("v.npy.json");
  const auto refused = [&](const std::vector<std::string>& parts) {
    check_refused(folder, "map v.npy --theta-i 10deg -o m.png", 3, parts);
  };
  std::string changed = bytes;
  changed[changed.size() / 2] ^= 1;
  folder.write("v.npy", changed);
  refused({"v.npy"});
  folder.write("v.npy", bytes.substr(0, bytes.size() - 8));
  refused({"v.npy"});
  folder.write("v.npy", bytes);
  std::string other = sidecar;
  other.replace(other.find("\"terms\": "), 9, "\"terms\": 9");
  folder.write("v.npy.json", other);
  refused({"v.npy"});
  folder.write("v.npy.json", "{}");
  refused({"v.npy"});
  std::filesystem::remove(folder / "v.npy.json");
  refused({"v.npy.json"});
}

TEST_CASE("maps of other sizes are not compared, nor maps without an exposure",
          "[cli][bake][refusal]") {
  const Scratch folder;
  make_small(folder);
  folder.prepare("map g.gsf --theta-i 10deg --size 16 -o a.png");
  folder.prepare("map g.gsf --theta-i 10deg --size 20 -o b.png");
  check_refused(folder, "validate a.npy b.npy --exposure 1 --max-error 1", 3, {"16", "20"});
  check_refused(folder, "validate a.npy a.npy --max-error 1", 2, {"--exposure"});
  folder.prepare("validate a.npy a.npy --exposure 1 --max-error 0");
}
