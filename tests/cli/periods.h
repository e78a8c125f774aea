// The JSON of `shedlight period`.
#pragma once

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

/// What a period that must be given says of itself.
inline nlohmann::json period(const Scratch& folder, const std::string& arguments) {
  const Outcome outcome = folder.shedlight("period " + arguments + " --json");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  return nlohmann::json::parse(outcome.out);
}
