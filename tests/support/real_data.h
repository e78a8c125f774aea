// The folder of real scans, which is no part of the repository.
#pragma once

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

/// The folder named by SHEDLIGHT_REAL_DATA. Where it is not set the test says so and is counted as
/// skipped, but fails where the environment says CI.
inline std::optional<std::filesystem::path> real_data() {
  if (const char* folder = std::getenv("SHEDLIGHT_REAL_DATA")) return folder;
  if (std::getenv("CI") != nullptr) FAIL("SHEDLIGHT_REAL_DATA must be set in CI");
  WARN("skipped: SHEDLIGHT_REAL_DATA is not set");
  return std::nullopt;
}
