// The most memory that this process has held.
#pragma once

#include <cstddef>
#include <fstream>
#include <optional>
#include <string>

namespace benchmarks {

namespace detail {

/// A line of /proc/self/status in bytes; nothing where there is no such file.
inline std::optional<double> status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kib = 0; word == name + ":" && status >> kib) return 1024 * kib;
  return std::nullopt;
}

}  // namespace detail

inline std::optional<double> resident_bytes() {
  return detail::status_bytes("VmRSS");
}

/// Since the start of the process: measure before anything larger has run.
inline std::optional<double> peak_resident_bytes() {
  return detail::status_bytes("VmHWM");
}

}  // namespace benchmarks
