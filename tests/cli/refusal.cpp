#include "tests/cli/refusal.h"

#include <algorithm>
#include <catch2/catch.hpp>

namespace {

std::string joined(const Words& command) {
  std::string text;
  for (const std::string& word : command) text += "[" + word + "] ";
  return text;
}

void check_one_line(const std::string& err, const std::string& beginning,
                    const std::vector<std::string>& named) {
  CHECK_THAT(err, Catch::StartsWith(beginning));
  CHECK_THAT(err, Catch::EndsWith("\n"));
  CHECK(std::count(err.begin(), err.end(), '\n') == 1);
  for (const std::string& part : named) CHECK_THAT(err, Catch::Contains(part));
}

std::vector<std::string> names(const std::map<std::string, std::string>& contents) {
  std::vector<std::string> result;
  for (const auto& [name, bytes] : contents) result.push_back(name);
  return result;
}

}  // namespace

std::string check_refused(const Scratch& folder, const Words& command, int exit_code,
                          const std::vector<std::string>& named, const Environment& changes) {
  const std::string older_sidecar = older_output + ".json";
  if (!folder.holds(older_output)) folder.write(older_output, "lambda_nm,1,2\n500,1,2\n");
  if (!folder.holds(older_sidecar)) folder.write(older_sidecar, "{\"older\": true}\n");
  const auto before = folder.contents();
  const Outcome outcome = folder.shedlight(command, changes);
  const auto after = folder.contents();

  INFO(joined(command) << "\n" << outcome.err);
  CHECK(outcome.exit_code == exit_code);
  CHECK(outcome.out == "");
  check_one_line(outcome.err, "shedlight: ", named);
  CHECK(names(after) == names(before));
  for (const auto& [name, bytes] : before) {
    INFO(name);
    // Not compared inside CHECK: it would print the bytes.
    const bool same = after.contains(name) && after.at(name) == bytes;
    CHECK(same);
  }
  return outcome.err;
}

void check_warned(const Outcome& outcome, const std::vector<std::string>& named) {
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  check_one_line(outcome.err, "shedlight: warning: ", named);
}
