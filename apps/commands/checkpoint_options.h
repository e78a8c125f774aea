// The option of long commands to keep what is done, and to go on from there.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "evaluation/checkpoint.h"
#include "evaluation/writers/output_file.h"

namespace apps {

struct CheckpointOptions {
  std::string file;

  void add_to(CLI::App* app);
  /// Null where none is asked for. request: a sidecar's head and parameters; all that the result
  /// depends on. Says on standard error what was taken over.
  std::shared_ptr<evaluation::Checkpoint> open(evaluation::Json request) const;
};

/// Where there is one. Once the output is in place.
inline void remove(const std::shared_ptr<evaluation::Checkpoint>& checkpoint) {
  if (checkpoint) checkpoint->remove();
}

}  // namespace apps
