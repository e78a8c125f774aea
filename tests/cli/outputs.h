// What is left in a folder when a run ends before its time.
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/program.h"

using Contents = std::map<std::string, std::string>;

/// Waits for a process that a killed run may have left to finish the renaming: it holds the folder.
inline void wait_for_renaming(const Scratch& folder) {
  const int descriptor = open(folder.path().c_str(), O_RDONLY | O_DIRECTORY);
  flock(descriptor, LOCK_EX);
  close(descriptor);
}

/// The temporary names in a folder.
inline std::vector<std::string> temporaries(const Scratch& folder) {
  std::vector<std::string> names;
  for (const auto& [name, bytes] : folder.contents())
    if (name.find(".tmp") != name.npos) names.push_back(name);
  return names;
}

/// Whether a condition comes true within ten seconds.
template <class Condition>
bool wait_until(const Condition& condition) {
  for (int i = 0; i < 10'000 && !condition(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return condition();
}

/// Waits for at least so many temporary names.
inline bool wait_for_temporaries(const Scratch& folder, std::size_t count) {
  return wait_until([&] { return temporaries(folder).size() >= count; });
}

/// Preloads a system with the faults named (faulty_system.cpp).
inline Environment with_faults(const std::string& faults) {
  // AddressSanitizer wants to be first.
  return {{"LD_PRELOAD", SHEDLIGHT_FAULTY_SYSTEM},
          {"SHEDLIGHT_FAULT", faults},
          {"ASAN_OPTIONS", "verify_asan_link_order=0"}};
}
