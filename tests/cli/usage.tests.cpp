#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"

namespace {

const std::string scene = " --theta-i 75deg --theta-r -50:-25:1deg --lambda 500:600:10nm";
const std::string sweep = "sweep g.gsf" + scene + " -o older.csv";

}  // namespace

TEST_CASE("the number of terms and a tolerance exclude each other", "[cli][refusal]") {
  const Scratch folder;
  make_grating(folder);
  check_refused(folder, sweep + " --terms 21 --tolerance 1e-6", 2, {"--terms", "--tolerance"});
}

TEST_CASE("a tolerance outside 0 to 1 is refused", "[cli][refusal]") {
  const Scratch folder;
  make_grating(folder);
  for (const std::string tolerance : {"1", "2"})
    check_refused(folder, sweep + " --tolerance " + tolerance, 2, {"--tolerance", tolerance});
}

TEST_CASE("a surface that a method has not is refused with a method that has it",
          "[cli][refusal]") {
  const Scratch folder;
  make_grating(folder);
  check_refused(folder, sweep + " --method taylor --surface isolated", 2,
                {"taylor", "isolated", "--method direct"});
}

TEST_CASE("an unknown name is refused with the names there are", "[cli][refusal]") {
  const Scratch folder;
  make_response(folder);
  check_refused(folder, sweep + " --method magic", 2, {"magic", "direct", "taylor"});
  check_refused(folder, sweep + " --surface magic", 2, {"magic", "isolated", "periodic"});
  check_refused(folder, sweep + " --quantity magic", 2,
                {"magic", "power", "relative", "brdf", "radiance"});
  check_refused(folder, sweep + " --layout magic", 2, {"magic", "matrix", "long"});
  check_refused(folder, sweep + " --preset magic", 2, {"magic", "thesis"});
  check_refused(folder, sweep + " --level magic", 2, {"magic", "none", "mean", "plane"});
  check_refused(folder, "peaks R.csv --refine magic -o older.csv", 2, {"magic", "grid"});
}

TEST_CASE("options of a series have no meaning for the direct sum", "[cli][refusal]") {
  const Scratch folder;
  make_grating(folder);
  check_refused(folder, sweep + " --method direct --terms 21", 2, {"--terms", "direct"});
  check_refused(folder, sweep + " --method direct --window-radius 4", 2,
                {"--window-radius", "direct"});
}

TEST_CASE("an option is not taken as the value of another", "[cli][refusal]") {
  const Scratch folder;
  make_response(folder);
  check_refused(folder, "sweep g.gsf" + scene + " -o --strict", 2, {"--strict"});
  check_refused(folder, "sweep g.gsf --output --strict" + scene, 2, {"--strict"});
  check_refused(folder, "sweep g.gsf --theta-i --phi-i 5deg --theta-r -5deg --lambda 1um", 2,
                {"--theta-i", "--phi-i"});
  check_refused(folder, sweep + " --threads --strict", 2, {"--threads", "--strict"});
  check_refused(folder, "plot R.csv -o --theta-i 75deg", 2, {"--theta-i"});
  check_refused(folder, sweep + " --method --strict", 2, {"method", "--strict"});
}

TEST_CASE("a stray number is not taken as a file", "[cli][refusal]") {
  const Scratch folder;
  make_response(folder);
  check_refused(folder, "sweep -5" + scene + " -o older.csv", 2, {"-5"});
  check_refused(folder, sweep + " -5", 2, {"-5"});
  check_refused(folder, "info -5", 2, {"-5"});
  check_refused(folder, "peaks R.csv -5 -o older.csv", 2, {"-5"});
  check_refused(folder, "validate R.csv -5 --max-error 1", 2, {"-5"});
  check_refused(folder, "period -5", 2, {"-5"});
}

TEST_CASE("an empty file name is refused", "[cli][refusal]") {
  const Scratch folder;
  make_grating(folder);
  check_refused(folder, words("info") + "", 2, {"file"});
  check_refused(folder, words("sweep g.gsf" + scene + " -o") + "", 2, {"--output"});
}

TEST_CASE("width and pixel exclude each other", "[cli][refusal]") {
  const Scratch folder;
  make_grating(folder);
  check_refused(folder, sweep + " --width 65um --pixel 100nm", 2, {"--width", "--pixel"});
  check_refused(folder, "info g.gsf --pixel 100nm --width 65um", 2, {"--width", "--pixel"});
  check_refused(folder, "info g.gsf --pixel 1um,2um,3um", 2, {"--pixel", "1um,2um,3um"});
}

TEST_CASE("an option given twice is refused", "[cli][refusal]") {
  const Scratch folder;
  make_grating(folder);
  check_refused(folder, sweep + " --theta-i 70deg", 2, {"--theta-i"});
}

TEST_CASE("an output that is the input is refused under any of its names", "[cli][refusal]") {
  const Scratch folder;
  make_response(folder);
  std::filesystem::create_symlink("g.gsf", folder / "link.gsf");
  std::filesystem::create_symlink("R.csv", folder / "link.csv");
  std::filesystem::create_directory(folder / "sub");
  const std::string absolute = (folder / "g.gsf").string();
  for (const std::string& name : Words{"g.gsf", "./g.gsf", "sub/../g.gsf", "link.gsf", absolute})
    check_refused(folder, "sweep g.gsf" + scene + " -o " + name, 2, {name, "input"});
  check_refused(folder, "sweep link.gsf" + scene + " -o g.gsf", 2, {"g.gsf", "input"});
  for (const std::string name : {"R.csv", "./R.csv", "link.csv"}) {
    check_refused(folder, "peaks R.csv -o " + name, 2, {name, "input"});
    check_refused(folder, "plot R.csv -o " + name, 2, {name, "input"});
  }
}

TEST_CASE("an output whose sidecar would be the input is refused", "[cli][refusal]") {
  const Scratch folder;
  make_response(folder);
  folder.write("scan.json", folder.read("g.gsf"));
  folder.write("table.json", folder.read("R.csv"));
  check_refused(folder, "sweep scan.json" + scene + " -o scan", 2, {"scan.json", "input"});
  check_refused(folder, "peaks table.json --theta-i 75deg -o table", 2, {"table.json", "input"});
  check_refused(folder, "plot table.json --theta-i 75deg -o ./table", 2, {"table.json", "input"});
}

TEST_CASE("an output that is the sidecar of the input is refused", "[cli][refusal]") {
  const Scratch folder;
  make_response(folder);
  check_refused(folder, "peaks R.csv -o R.csv.json", 2, {"R.csv.json", "input"});
  check_refused(folder, "plot R.csv -o R.csv.json", 2, {"R.csv.json", "input"});
}
