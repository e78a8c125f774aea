#include <catch2/catch.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/tables.h"

namespace {

const std::string sweep =
    "sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.1deg --lambda "
    "400:700:5nm --sigma 16.25um -o R.csv";

}  // namespace

TEST_CASE("the response does not depend on the number of threads or the run", "[cli][invariant]") {
  const Scratch folder;
  make_grating(folder);
  for (const std::string method :
       {" --method taylor", " --method direct --surface periodic", " --method direct"}) {
    folder.prepare(sweep + method);
    const std::string csv = folder.read("R.csv"), sidecar = folder.read("R.csv.json");
    for (const std::string threads : {" --threads 1", " --threads 2", " --threads 5", ""}) {
      INFO(method << threads);
      folder.prepare(sweep + method + threads);
      const bool same = folder.read("R.csv") == csv && folder.read("R.csv.json") == sidecar;
      CHECK(same);
    }
  }
}

TEST_CASE("peaks, period and synth give the same bytes in every run", "[cli][invariant]") {
  const Scratch folder;
  make_response(folder);
  folder.prepare("peaks R.csv -o peaks.csv");
  const auto before = folder.contents();
  const std::string period = folder.shedlight("period R.csv --by peaks --json").out;
  CHECK(period != "");
  for (int run = 0; run < 3; ++run) {
    make_grating(folder);
    folder.prepare("peaks R.csv -o peaks.csv");
    CHECK(folder.shedlight("period R.csv --by peaks --json").out == period);
    const bool same = folder.contents() == before;
    CHECK(same);
  }
}

TEST_CASE("a locale with decimal commas and another time zone change nothing", "[cli][invariant]") {
  const Scratch folder;
  make_grating(folder);
  // Made here: few machines have one. Without the package locales only its name is left to try.
  const std::string locale = "de_DE.UTF-8";
  if (folder.run({"localedef", "-c", "-i", "de_DE", "-f", "UTF-8", "./" + locale}).exit_code != 0)
    WARN("skipped: no locale with decimal commas can be made");
  folder.prepare(sweep);
  const std::string csv = folder.read("R.csv"), sidecar = folder.read("R.csv.json");
  const std::string period = folder.shedlight("period R.csv --by peaks").out;
  for (const std::string zone : {"", "Pacific/Apia", "UTC-14"}) {
    INFO(zone);
    const Environment elsewhere{
        {"LC_ALL", locale}, {"LANG", locale}, {"LOCPATH", folder.path().string()}, {"TZ", zone}};
    CHECK(folder.shedlight(words(sweep), elsewhere).exit_code == 0);
    const bool same = folder.read("R.csv") == csv && folder.read("R.csv.json") == sidecar;
    CHECK(same);
    CHECK(folder.shedlight(words("period R.csv --by peaks"), elsewhere).out == period);
  }
}
