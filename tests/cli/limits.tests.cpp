#include <catch2/catch.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"

namespace {

const std::string sweep = "sweep g.gsf -o older.csv --theta-i 75deg ";

}  // namespace

TEST_CASE("a sweep that needs more memory than allowed is refused", "[cli][limit]") {
  const Scratch folder;
  folder.prepare("synth blazed --period 2500nm --height 600nm --size 65um --pixels 650 -o g.gsf");
  for (const std::string method : {"direct", "taylor"})
    check_refused(folder,
                  sweep +
                      "--theta-r -55:-40:0.1deg --lambda 400:700:100nm --memory-limit 1MB "
                      "--method " +
                      method,
                  6, {"g.gsf", "MB", "--memory-limit"});
}

TEST_CASE("a huge range is refused before memory is taken for it", "[cli][limit]") {
  const Scratch folder;
  make_grating(folder);
  for (const std::string method : {"direct", "taylor"})
    check_refused(folder,
                  sweep + "--theta-r -70:-20:0.0001deg --lambda 400:800:0.001nm --method " + method,
                  6, {"g.gsf", "--memory-limit"});
}

TEST_CASE("an axis of more values than anything could hold is refused", "[cli][limit]") {
  const Scratch folder;
  make_grating(folder);
  check_refused(folder, sweep + "--lambda 500nm --theta-r -80:80:0.0000000001deg", 2,
                {"--theta-r", "-80:80:0.0000000001deg"});
  check_refused(folder, sweep + "--theta-r -50deg --lambda 0.4:0.8:0.0000000000001um", 2,
                {"--lambda", "0.4:0.8:0.0000000000001um"});
}

TEST_CASE("a sweep that takes longer than allowed is given up", "[cli][limit]") {
  const Scratch folder;
  folder.prepare("synth blazed --period 2500nm --height 600nm --size 65um --pixels 650 -o g.gsf");
  const std::string line =
      check_refused(folder,
                    sweep +
                        "--theta-r -55:-40:0.01deg --lambda 380:780:1nm --method direct "
                        "--time-limit 1ms",
                    6, {"g.gsf", "--time-limit"});
  CHECK_THAT(line, Catch::Contains("1ms") || Catch::Contains("1 ms") || Catch::Contains("0.001"));
}

TEST_CASE("generous limits change nothing", "[cli][limit]") {
  const Scratch folder;
  make_grating(folder);
  const std::string free = folder.shedlight("sweep g.gsf" + small_scene).out;
  CHECK(free != "");
  CHECK(folder.shedlight("sweep g.gsf" + small_scene + " --memory-limit 1GB --time-limit 10min")
            .out == free);
}
