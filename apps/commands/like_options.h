// The option of `shedlight sweep` that takes method and knobs from a table of `shedlight tradeoff`.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>

#include "evaluation/tradeoff/trial.h"
#include "evaluation/writers/output_file.h"

namespace apps {

struct LikeOptions {
  std::string file;  ///< empty where none is given
  std::size_t row = 0;
  evaluation::Trial trial;  ///< once read

  void add_to(CLI::App* app);
  void read();
  /// "frontier.csv: row 12"
  std::string place() const { return file + ": row " + std::to_string(row); }
  evaluation::Json parameters() const { return {{"file", file}, {"row", row}}; }
};

}  // namespace apps
