// What every refusal of the program has in common.
#pragma once

#include <string>
#include <vector>

#include "tests/cli/program.h"

/// Name of an output that is already there when a refused command runs; its sidecar is too.
inline const std::string older_output = "older.csv";

/// Runs a command that must be refused, beside an older output and its sidecar, and checks that
/// - the exit code is the one given, and standard output is empty;
/// - standard error is one line that begins with "shedlight: " and holds each of `named`;
/// - every file in the folder is as it was, to the byte, and there is no new one.
/// Returns the line.
std::string check_refused(const Scratch& folder, const Words& command, int exit_code,
                          const std::vector<std::string>& named, const Environment& changes = {});

inline std::string check_refused(const Scratch& folder, const std::string& command, int exit_code,
                                 const std::vector<std::string>& named) {
  return check_refused(folder, words(command), exit_code, named);
}

/// Checks that standard error is one warning that holds each of `named`, and that the run was done.
void check_warned(const Outcome& outcome, const std::vector<std::string>& named);
