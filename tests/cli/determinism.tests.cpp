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

TEST_CASE("a locale with decimal commas changes nothing", "[cli][invariant]") {
  const Scratch folder;
  make_grating(folder);
  std::vector<std::string> comma_locales;
  for (const std::string& locale : lines_of(folder.run({"locale", "-a"}).out))
    for (const std::string language : {"de_", "fr_", "it_", "nl_", "ru_"})
      if (locale.starts_with(language)) comma_locales.push_back(locale);
  if (comma_locales.empty()) WARN("skipped: no locale with decimal commas is installed");
  // A locale that is not installed must do no harm either.
  comma_locales.push_back("de_DE.UTF-8");
  folder.prepare(sweep);
  const std::string csv = folder.read("R.csv");
  const std::string period = folder.shedlight("period R.csv --by peaks").out;
  for (const std::string& locale : comma_locales) {
    INFO(locale);
    const Environment german{{"LC_ALL", locale}, {"LANG", locale}};
    CHECK(folder.shedlight(words(sweep), german).exit_code == 0);
    const bool same = folder.read("R.csv") == csv;
    CHECK(same);
    CHECK(folder.shedlight(words("period R.csv --by peaks"), german).out == period);
  }
}
