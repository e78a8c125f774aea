#include <catch2/catch.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"

namespace {

const std::string synth = "synth blazed --size 9um --pixels 9 -o older.csv";
const std::string scene = " --theta-i 75deg --theta-r -50:-25:1deg --lambda 380:780:1nm";
const std::string sweep = "sweep g.gsf -o older.csv";
const std::string peaks = "peaks R.csv --theta-i 75deg -o older.csv ";

/// A command without the option under test, the option, a number, and a unit it could have.
struct Case {
  std::string command, option, number, unit;
};

/// Every option that takes a quantity.
const std::vector<Case> quantities{
    {synth + " --height 1um", "--period", "2500", "nm"},
    {synth + " --period 1um", "--height", "600", "nm"},
    {"synth flat --pixels 9 -o older.csv", "--size", "65", "um"},
    {"info x.png", "--width", "65", "um"},
    {"info x.png", "--pixel", "48.8", "nm"},
    {"info x.png", "--height-range", "434.7", "nm"},
    {"info x.gsf", "--height-unit", "1", "nm"},
    {sweep + " --theta-r -50deg --lambda 1um", "--theta-i", "75", "deg"},
    {sweep + " --theta-i 75deg --lambda 1um", "--theta-r", "-50", "deg"},
    {sweep + " --theta-i 75deg --theta-r -50deg", "--lambda", "380", "nm"},
    {sweep + scene, "--phi-i", "90", "deg"},
    {sweep + scene, "--phi-r", "90", "deg"},
    {sweep + scene, "--sigma", "16.25", "um"},
    {sweep + scene, "--width", "65", "um"},
    {sweep + scene, "--memory-limit", "100", "MB"},
    {sweep + scene, "--time-limit", "10", "s"},
    {peaks, "--period-guess", "2500", "nm"},
    {peaks, "--period-range", "1:2", "um"},
    {peaks, "--window", "-50:-40", "deg"},
    {"period R.csv", "--theta-i", "75", "deg"},
    {"period R.csv", "--phi-i", "90", "deg"},
    {"period R.csv", "--phi-r", "90", "deg"},
    {"plot R.csv -o older.csv", "--sigma", "16.25", "um"},
};

}  // namespace

TEST_CASE("a number without its unit is refused with the units it could have", "[cli][units]") {
  const Scratch folder;
  for (const Case& c : quantities)
    check_refused(folder, c.command + " " + c.option + " " + c.number, 2,
                  {c.option, c.number.substr(0, c.number.find(':')), c.unit});
}

TEST_CASE("ranges without a unit are refused with the units they could have", "[cli][units]") {
  const Scratch folder;
  check_refused(folder, sweep + " --theta-i 75deg --lambda 1um --theta-r -50:-25:0.05", 2,
                {"--theta-r", "-50", "deg", "rad"});
  check_refused(folder, sweep + " --theta-i 75deg --theta-r -50deg --lambda 380:780:1", 2,
                {"--lambda", "380", "nm", "um"});
}

TEST_CASE("an unknown unit is refused with the units there are", "[cli][units]") {
  const Scratch folder;
  for (const Case& c : quantities)
    check_refused(folder, c.command + " " + c.option + " " + c.number + "furlong", 2,
                  {c.option, "furlong", c.unit});
  // The unit of another quantity is none of an angle's, nor of a length's.
  check_refused(folder, sweep + " --theta-r -5deg --lambda 1um --theta-i 75nm", 2, {"75nm", "deg"});
  check_refused(folder, sweep + " --theta-r -5deg --theta-i 75deg --lambda 5deg", 2,
                {"5deg", "nm"});
}

TEST_CASE("what is no finite number is refused wherever a number stands", "[cli][units]") {
  const Scratch folder;
  for (const Case& c : quantities)
    for (const std::string number : {"nan", "inf", "-inf", "", "1e999", "abc", "0x10"})
      check_refused(folder, words(c.command) + c.option + (number + c.unit), 2, {c.option});
  for (const Case& c : quantities)
    check_refused(folder, words(c.command) + c.option + "", 2, {c.option});
  for (const std::string option : {"--tolerance", "--window-radius", "--terms", "--threads"})
    for (const std::string number : {"nan", "inf", "", "abc", "1e999", "3nm"})
      check_refused(folder, words(sweep + scene) + option + number, 2, {option});
}

TEST_CASE("quantities that must be positive are refused at zero and below", "[cli][units]") {
  const Scratch folder;
  make_response(folder);
  folder.write("x.gsf", folder.read("g.gsf"));
  const std::string grating = "synth blazed --size 9um --pixels 9 -o older.csv";
  for (const std::string sign : {"0", "-3"}) {
    check_refused(folder, "info x.gsf --pixel " + sign + "um", 2, {"x.gsf", "pixel", sign});
    check_refused(folder, sweep + scene + " --window-radius " + sign, 2, {"radius", sign});
    for (const std::string option : {"--width", "--height-unit"})
      check_refused(folder, "info x.gsf " + option + " " + sign + "um", 2, {option, sign});
    check_refused(folder, sweep + scene + " --sigma " + sign + "um", 2, {"sigma", sign});
    check_refused(folder, sweep + scene + " --memory-limit " + sign + "MB", 2,
                  {"--memory-limit", sign});
    check_refused(folder, sweep + scene + " --time-limit " + sign + "s", 2, {"--time-limit", sign});
    for (const std::string option : {"--terms", "--threads", "--reduce", "--tolerance"})
      check_refused(folder, sweep + scene + " " + option + " " + sign, 2, {option, sign});
    check_refused(folder, "peaks R.csv -o older.csv --period-guess " + sign + "um", 2, {sign});
    check_refused(folder, "peaks R.csv -o older.csv --sigma " + sign + "um", 2, {"sigma", sign});
    check_refused(folder, grating + " --period 1um --height " + sign + "um", 2, {"height", sign});
    check_refused(folder, grating + " --height 1um --period " + sign + "um", 2, {"period", sign});
    check_refused(folder, "synth flat --pixels 9 -o older.csv --size " + sign + "um", 2,
                  {"--size", sign});
    check_refused(folder, "synth flat --size 9um -o older.csv --pixels " + sign, 2,
                  {"--pixels", sign});
  }
}

TEST_CASE("the units of a length give the same numbers", "[cli][units]") {
  const Scratch folder;
  make_grating(folder);
  const std::string first =
      folder.shedlight("info g.gsf --json --width 65um --height-unit 1nm").out;
  CHECK(first != "");
  for (const std::string width : {"65000nm", "0.065mm", "6.5e-5m", "65\xC2\xB5m", "65e6pm"})
    CHECK(folder.shedlight("info g.gsf --json --height-unit 1e-9m --width " + width).out == first);
}
