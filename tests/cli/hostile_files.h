// Files that declare more than they hold: refused at once, in one line, in little memory.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/refusal.h"
#include "tests/support/refusal_cost.h"

/// Checks that `info` refuses a file in one line, at no more than what it may cost above the start
/// of the program. Returns the line.
inline std::string check_cheaply_refused(const Scratch& folder, const std::string& file,
                                         const std::string& options = "") {
  // AddressSanitizer keeps what was freed, and would be measured in place of the program.
  const Environment frees{{"ASAN_OPTIONS", "quarantine_size_mb=1"}};
  const Outcome start = folder.shedlight(words("--version"), frees);
  const Outcome outcome =
      folder.shedlight(words("info " + file + " --width 1um --height-unit 1nm" + options), frees);
  INFO(file << ": " << outcome.err << outcome.seconds << " s, " << outcome.peak_kib << " KiB");
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.out == "");
  CHECK_THAT(outcome.err, Catch::StartsWith("shedlight: " + file + ": "));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(outcome.seconds <= most_seconds);
  CHECK(outcome.peak_kib - start.peak_kib <= static_cast<long>(most_bytes >> 10));
  return outcome.err;
}

/// A number of `size` bytes, the least significant first.
inline std::string little_endian(std::uint64_t value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> 8 * i & 0xFF);
  return bytes;
}

/// Makes a file four gigabytes long without giving it the room.
inline void stretch(const Scratch& folder, const std::string& file) {
  std::filesystem::resize_file(folder / file, std::uintmax_t{4} << 30);
}
