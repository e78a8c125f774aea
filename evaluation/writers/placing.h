// Finished files put in place, several as one.
#pragma once

#include <filesystem>
#include <span>

#include "evaluation/writers/temporary_file.h"

namespace evaluation {

/// A finished file and where it belongs.
struct Placement {
  TemporaryFile* file;
  std::filesystem::path target;
};

/// Syncs the files, puts them in place in their order, and syncs their folders.
///
/// All of them or none: a process of its own renames them, so a signal that ends this one, SIGKILL
/// included, does not come between two of them. A lock on the folders keeps the files of two runs
/// apart. What is left is a crash of the whole machine, after which the hash in a sidecar tells.
///
/// Throws std::system_error.
void place(std::span<const Placement> files);

}  // namespace evaluation
