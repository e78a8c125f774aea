// The options that limit a run: threads, memory, time, and what is made of accuracy not attained.
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <optional>

#include "apps/console.h"
#include "evaluation/sweep.h"

namespace apps {

struct RunOptions {
  RunOptions();

  int threads;  ///< all there are, unless given
  std::optional<std::size_t> memory_limit;
  std::optional<std::chrono::duration<double>> time_limit;
  bool strict = false;

  void add_to(CLI::App* app);
  /// The time runs from the start of the program.
  evaluation::RunLimits limits() const;
  Attainability attainability() const {
    return strict ? Attainability::refuse : Attainability::warn;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace apps
