// The manual page and the shell's completion, made of what the options say of themselves.
#include <catch2/catch.hpp>

#include "tests/cli/program.h"

namespace {

/// What bash offers for the last of the words, with the completion loaded.
std::string completed(const Scratch& folder, const std::string& last_words) {
  folder.write("completion", folder.shedlight("completion bash").out);
  folder.write(
      "ask",
      "source completion\nCOMP_WORDS=(shedlight " + last_words +
          ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_shedlight\necho \"${COMPREPLY[@]}\"\n");
  return folder.run({"bash", "ask"}).out;
}

}  // namespace

TEST_CASE("the manual names every command and its options", "[cli][help]") {
  const Scratch folder;
  const Outcome manual = folder.shedlight("manual");
  REQUIRE(manual.exit_code == 0);
  CHECK(manual.out.starts_with(".TH SHEDLIGHT 1"));
  for (const std::string section : {"NAME", "SYNOPSIS", "COMMANDS", "EXIT STATUS"})
    CHECK(manual.out.find(".SH " + section + "\n") != std::string::npos);
  for (const std::string command : {"synth", "sweep", "period", "convert", "completion"})
    CHECK(manual.out.find(".SS " + command + "\n") != std::string::npos);
  CHECK(manual.out.find("\\-\\-height\\-range") != std::string::npos);
  // An apostrophe or a point at the beginning of a line would be a request to roff.
  for (std::size_t at = 0; (at = manual.out.find("\n'", at)) != std::string::npos; ++at)
    FAIL("a line begins with an apostrophe: " << manual.out.substr(at, 40));
}

TEST_CASE("bash completes commands, options and named values", "[cli][help]") {
  const Scratch folder;
  CHECK(completed(folder, "swe") == "sweep\n");
  CHECK(completed(folder, "sweep g.gsf --height-r") == "--height-range\n");
  CHECK(completed(folder, "sweep g.gsf --level pl") == "plane\n");
  CHECK(completed(folder, "sweep g") == "\n");  // left to the completion of files
}

TEST_CASE("another shell is refused with those there are", "[cli][help]") {
  const Scratch folder;
  const Outcome outcome = folder.shedlight("completion fish");
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.err.find("bash") != std::string::npos);
}
