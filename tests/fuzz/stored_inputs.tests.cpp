// Inputs that once broke a reader, and a sample of those that fuzzing found, read again.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/fuzz/targets.h"

TEST_CASE("stored inputs are read or refused by their reader", "[input][regression]") {
  namespace fs = std::filesystem;
  int inputs = 0;
  for (const auto& entry : fs::recursive_directory_iterator(SHEDLIGHT_FUZZ_INPUTS)) {
    if (!entry.is_regular_file()) continue;
    INFO(entry.path().string());
    std::stringstream bytes;
    bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    const std::string name = entry.path().parent_path().filename().string();
    for (const fuzz::Target& target : fuzz::targets())
      if (target.name == name) {
        CHECK_NOTHROW(target.run(bytes.str()));
        ++inputs;
      }
  }
  CHECK(inputs > 0);
}
