#include "evaluation/peak_memory.h"

#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace evaluation {
namespace {

/// A line "VmHWM:   1234 kB" of /proc/self/status, in bytes.
std::optional<std::size_t> status(const std::string& key) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;) {
    std::size_t kilobytes = 0;
    if (word == key && file >> kilobytes) return kilobytes * 1024;
  }
  return std::nullopt;
}

/// "5" resets the high-water mark (Linux, Documentation/filesystems/proc.rst).
bool reset_high_water_mark() {
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  return file.good();
}

}  // namespace

void release_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

PeakMemory::PeakMemory() {
  release_freed_memory();
  if (reset_high_water_mark()) before_ = status("VmHWM:");
}

std::optional<std::size_t> PeakMemory::bytes() const {
  const std::optional<std::size_t> now = status("VmHWM:");
  if (!before_ || !now) return std::nullopt;
  return *now - std::min(*now, *before_);
}

}  // namespace evaluation
