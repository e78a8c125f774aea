#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/cli/gratings.h"
#include "tests/cli/pictures.h"
#include "tests/cli/refusal.h"

namespace {

Words around(const std::string& before, const std::string& name, const std::string& after) {
  Words command = words(before) + name;
  for (const std::string& word : words(after)) command.push_back(word);
  return command;
}

}  // namespace

TEST_CASE("a response is drawn as a PNG", "[cli][plot]") {
  const Scratch folder;
  make_response(folder);
  const Outcome outcome = folder.shedlight("plot R.csv -o R.png");
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == "");
  CHECK(outcome.err == "");
  check_picture(folder.read("R.png"));
  CHECK(folder.contents().size() == 6);  // grating, response, picture, and their sidecars
}

TEST_CASE("a response without a period is drawn with a warning", "[cli][plot]") {
  const Scratch folder;
  folder.write("R.csv", "lambda_nm,-50,-49,-48\n500,3,2,1\n510,1,2,3\n");
  const Outcome outcome = folder.shedlight("plot R.csv --theta-i 75deg -o R.png");
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.err, Catch::Matches("shedlight: warning: [^\n]*\n"));
  check_picture(folder.read("R.png"));
}

TEST_CASE("responses of one row, one column, one cell or no light are drawn", "[cli][plot]") {
  const Scratch folder;
  for (const std::string csv :
       {"lambda_nm,-50,-49,-48\n500,1,2,1\n", "lambda_nm,-50\n500,1\n510,2\n",
        "lambda_nm,-50\n500,1\n", "lambda_nm,-50,-49\n500,0,0\n510,0,0\n"}) {
    folder.write("R.csv", csv);
    const Outcome outcome = folder.shedlight("plot R.csv --theta-i 75deg -o R.png");
    INFO(csv << outcome.err);
    CHECK(outcome.exit_code == 0);
    check_picture(folder.read("R.png"));
  }
}

TEST_CASE("a file name is shown, never executed", "[cli][plot]") {
  const std::string name = GENERATE(
      as<std::string>(),  //
      "it's \"quoted\".gsf", "two '' and three ''' together.gsf",
      "''; system(\"touch executed\"); ''.gsf", "'''; system(\"touch executed\"); '''.gsf",
      "'; system 'touch executed'; '.gsf", "'.system(\"touch executed\").'.gsf",
      "x\"; !touch executed; \".gsf", "`touch executed`.gsf", "$(touch executed).gsf",
      "two\nlines'\n!touch executed\n.gsf", "a_{b}^c @x &{y} \\n \\\".gsf", "%s %d %n 100%.gsf",
      "| touch executed #.gsf", "> executed #.gsf", "< touch executed #.gsf");
  INFO(name);
  const Scratch folder;
  make_grating(folder);
  folder.write(name, folder.read("g.gsf"));
  const std::string csv = name + ".csv", png = name + ".png";
  CHECK(folder.shedlight(around("sweep", name, small_scene) + "-o" + csv).exit_code == 0);
  const Outcome outcome = folder.shedlight(around("plot", csv, "-o") + png);
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  CHECK_FALSE(folder.holds("executed"));
  // The grating, its copy, the response, the picture, three sidecars; nothing under another name.
  CHECK(folder.contents().size() == 7);
  REQUIRE(folder.holds(png));
  check_picture(folder.read(png));
}

TEST_CASE("the picture is the same in every run", "[cli][plot][invariant]") {
  const Scratch folder;
  make_response(folder);
  folder.prepare("plot R.csv -o A.png");
  folder.prepare("plot R.csv -o B.png");
  const bool same = folder.read("A.png") == folder.read("B.png");
  CHECK(same);
}

TEST_CASE("several responses are drawn at one wavelength", "[cli][plot]") {
  const Scratch folder;
  make_response(folder);
  folder.prepare("sweep g.gsf" + small_scene + " --replicas 3,1 -o three.csv");
  for (const std::string scale : {"", " --scale linear", " --scale log"}) {
    const Outcome outcome = folder.shedlight("plot R.csv three.csv --cut 500nm -o cut.png" + scale);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err == "");
    check_picture(folder.read("cut.png"));
  }
  // Another curve, another scale: another picture.
  folder.prepare("plot R.csv --cut 500nm -o one.png");
  folder.prepare("plot R.csv --cut 500nm --scale log -o log.png");
  const std::string one = folder.read("one.png");
  CHECK((one != folder.read("log.png")));
  CHECK((one != folder.read("cut.png")));
}

TEST_CASE("a cut that cannot be drawn is refused", "[cli][plot][refusal]") {
  const Scratch folder;
  make_response(folder);
  folder.prepare("sweep g.gsf" + small_scene + " --quantity power -o power.csv");
  check_refused(folder, "plot R.csv power.csv -o older.csv", 2, {"--cut"});
  check_refused(folder, "plot R.csv --scale log -o older.csv", 2, {"--scale", "--cut"});
  check_refused(folder, "plot R.csv --cut 300nm -o older.csv", 2, {"300", "R.csv", "400"});
  check_refused(folder, "plot R.csv --cut 500 -o older.csv", 2, {"--cut", "unit"});
  check_refused(folder, "plot R.csv power.csv --cut 500nm -o older.csv", 3,
                {"power.csv", "abs(a)^2", "relative reflectance"});
  check_refused(folder, "plot R.csv missing.csv --cut 500nm -o older.csv", 3, {"missing.csv"});
  check_refused(folder, "plot R.csv power.csv --cut 500nm -o power.csv", 2, {"power.csv"});
}
