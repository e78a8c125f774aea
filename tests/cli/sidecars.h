// What stands beside an output.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "tests/cli/program.h"

inline nlohmann::json sidecar_of(const Scratch& folder, const std::string& output) {
  return nlohmann::json::parse(folder.read(output + ".json"));
}

/// SHA-256 by coreutils.
inline std::string sha256sum(const Scratch& folder, const std::string& file) {
  const Outcome outcome = folder.run({"sha256sum", file});
  if (outcome.exit_code != 0) throw std::runtime_error(outcome.err);
  return outcome.out.substr(0, 64);
}
