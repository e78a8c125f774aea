#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "tests/cli/gratings.h"
#include "tests/cli/outputs.h"
#include "tests/cli/pictures.h"
#include "tests/cli/refusal.h"
#include "tests/cli/sidecars.h"

namespace {

namespace fs = std::filesystem;

void check_svg(const Scratch& folder, const std::string& name) {
  const std::string svg = folder.read(name);
  CHECK_THAT(svg, Catch::StartsWith("<?xml") && Catch::EndsWith("</svg>\n\n"));
  // The picture stands for itself, and is XML whatever a title holds: UTF-8, or this would throw.
  CHECK_THAT(svg, !Catch::Contains("file:") && !Catch::Contains("/dev/fd"));
  CHECK_NOTHROW(nlohmann::json(svg).dump());
  CHECK_THAT(svg, !Catch::Contains("]]>"));
  const auto is_control = [](char c) {
    return static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t';
  };
  CHECK(std::ranges::none_of(svg, is_control));
}

void check_pdf(const std::string& pdf) {
  CHECK_THAT(pdf, Catch::StartsWith("%PDF-") && Catch::EndsWith("%%EOF\n"));
  CHECK_THAT(pdf, !Catch::Contains("/CreationDate") && !Catch::Contains("/dev/fd"));
}

/// Whether a process is there and not dead already.
bool is_running(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  return std::getline(file, line) && line.find(") Z ") == std::string::npos;
}

/// A gnuplot of our own, before or instead of the real one.
Environment with_gnuplot(const Scratch& folder, const std::string& script) {
  fs::create_directories(folder / "bin");
  folder.write("bin/gnuplot", script);
  fs::permissions(folder / "bin/gnuplot", fs::perms::owner_all);
  return {{"PATH", (folder / "bin").string() + ":/usr/bin:/bin"}};
}

}  // namespace

TEST_CASE("pictures are drawn as the extension of their name says", "[cli][plot]") {
  const Scratch folder;
  make_response(folder);
  for (const std::string& command :
       {std::string("plot R.csv -o p"), std::string("plot R.csv --cut 500nm -o p"),
        std::string("ridges R.csv --plot p"),
        std::string("map g.gsf --theta-i 0deg,30deg --size 64 --surface periodic -o p")}) {
    INFO(command);
    folder.prepare(command + ".svg");
    check_svg(folder, "p.svg");
    folder.prepare(command + ".PDF");
    check_pdf(folder.read("p.PDF"));
    folder.prepare(command);  // as ever
    CHECK(folder.read("p").substr(1, 3) == "PNG");
    const std::string svg = folder.read("p.svg"), pdf = folder.read("p.PDF");
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // PDF would hold the second
    folder.prepare(command + ".svg");
    folder.prepare(command + ".PDF");
    const bool same = folder.read("p.svg") == svg && folder.read("p.PDF") == pdf;
    CHECK(same);
  }
}

TEST_CASE("a picture of another kind is refused", "[cli][plot][refusal]") {
  const Scratch folder;
  make_response(folder);
  for (const std::string command : {"plot R.csv -o ", "ridges R.csv --plot ", "stability --plot ",
                                    "map g.gsf --theta-i 0deg --size 64 -o "})
    check_refused(folder, command + "p.jpg", 2, {"p.jpg", ".png", ".svg", ".pdf"});
}

TEST_CASE("names are shown in every format, never executed", "[cli][plot]") {
  const std::string name =
      GENERATE(as<std::string>(), "''; system(\"touch executed\"); ''.csv",
               "`touch executed` $(touch executed)", "< touch executed #", "| touch executed #",
               "a<b>&c\"d'e ]]> <!-- x", "tab\t bell\a line\n.csv", "{Symbol a}^2_3@x %d \\n ünï",
               "no utf-8 \xff\xfe\x80.csv");
  INFO(name);
  const Scratch folder;
  make_response(folder);
  folder.write(name, folder.read("R.csv"));
  folder.write(name + ".json", folder.read("R.csv.json"));
  for (const std::string format : {".svg", ".pdf", ".png"}) {
    const Outcome outcome =
        folder.shedlight(Words{"plot", name, "--cut", "500nm", "-o", "out" + format});
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
  }
  CHECK_FALSE(folder.holds("executed"));
  CHECK(folder.contents().size() == 12);  // grating, response, its copy, three pictures, sidecars
  check_svg(folder, "out.svg");
  check_pdf(folder.read("out.pdf"));
  check_picture(folder.read("out.png"));
}

TEST_CASE("gnuplot is asked for nothing but the script", "[cli][plot]") {
  const Scratch folder;
  make_response(folder);
  folder.write(".gnuplot", "system('touch executed')\n");
  Environment environment = with_gnuplot(
      folder, "#!/bin/sh\necho \"$#\" \"$1\" >arguments\nexec /usr/bin/gnuplot \"$@\"\n");
  environment["HOME"] = folder.path().string();
  CHECK(folder.shedlight(words("plot R.csv -o R.png"), environment).exit_code == 0);
  CHECK(folder.read("arguments") == "2 -d\n");
  CHECK_FALSE(folder.holds("executed"));
}

TEST_CASE("without gnuplot, or where it dies, the CSV is there", "[cli][plot][output]") {
  const Scratch folder;
  make_response(folder);
  for (const std::string script : {"#!/bin/sh\nkill -9 $$\n", "#!/bin/sh\necho no >&2; exit 3\n",
                                   "#!/bin/sh\nexit 0\n", "none"}) {
    INFO(script);
    Environment environment = with_gnuplot(folder, script);
    if (script == "none") environment["PATH"] = (folder / "nowhere").string();
    const Outcome outcome =
        folder.shedlight(words("ridges R.csv -o ridges.csv --plot ridges.png"), environment);
    CHECK(outcome.exit_code == 4);
    CHECK_THAT(outcome.err, Catch::Matches("shedlight: [^\n]*gnuplot[^\n]*\n"));
    CHECK(sidecar_of(folder, "ridges.csv").at("output").at("sha256") ==
          sha256sum(folder, "ridges.csv"));
    CHECK_FALSE(folder.holds("ridges.png"));
    fs::remove(folder / "ridges.csv");
  }
}

TEST_CASE("nothing of a picture stays behind where a run is killed", "[cli][plot][fault]") {
  const Scratch folder;
  make_response(folder);
  fs::create_directory(folder / "tmp");
  Environment environment = with_gnuplot(folder, "#!/bin/sh\necho $$ >started\nexec sleep 100\n");
  environment["TMPDIR"] = (folder / "tmp").string();
  for (const int signal : {SIGTERM, SIGKILL}) {
    Running run = folder.start(words("plot R.csv -o R.png"), environment);
    REQUIRE(wait_until([&] { return folder.holds("started") && !folder.read("started").empty(); }));
    run.signal(signal);
    CHECK(run.wait().exit_code == 128 + signal);
    const pid_t gnuplot = std::stoi(folder.read("started"));
    if (signal == SIGTERM)  // gnuplot went first, where there was time to end it
      CHECK(wait_until([&] { return !is_running(gnuplot); }));
    else
      kill(gnuplot, SIGKILL);
    fs::remove(folder / "started");
    CHECK(fs::is_empty(folder / "tmp"));
    CHECK_FALSE(folder.holds("R.png"));
    CHECK(temporaries(folder).empty());
  }
}

TEST_CASE("a picture that a limit on files cuts off is an error", "[cli][plot][fault]") {
  const Scratch folder;
  make_response(folder);
  const auto limited = [&](const std::string& bytes) {
    return folder.run(
        {"prlimit", "--fsize=" + bytes, SHEDLIGHT_PROGRAM, "plot", "R.csv", "-o", "R.png"});
  };
  // Script, data, picture.
  for (const std::string bytes : {"100", "3000", "20000"}) {
    const Outcome outcome = limited(bytes);
    INFO(bytes << outcome.err);
    CHECK(outcome.exit_code == 4);
    CHECK_THAT(outcome.err, Catch::Matches("shedlight: [^\n]*\n"));
    CHECK_FALSE(folder.holds("R.png"));
  }
}
