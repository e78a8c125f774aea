// How much memory a command may take.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>
#include <string>

namespace apps {

/// What is about to be taken, and for what.
struct MemoryNeed {
  std::string file;  ///< that the command works on
  std::string what;  ///< "the sweep"
  std::size_t bytes;
  std::string advice;  ///< what needs less
};

/// Adds --memory-limit.
void add_memory_limit(CLI::App* app, std::optional<std::size_t>& limit);

/// The limit given, or 80 % of the machine's memory.
std::size_t memory_allowed(const std::optional<std::size_t>& limit);

/// Throws Errc::over_limit where the need is above the limit, or without one above 80 % of the
/// machine's memory.
void require_memory(const MemoryNeed& need, const std::optional<std::size_t>& limit);

}  // namespace apps
