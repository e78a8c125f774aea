// The most memory that a piece of work held.
#pragma once

#include <cstddef>
#include <optional>

namespace evaluation {

/// Gives memory that was freed back to the system, so that the next piece of work takes its own, as
/// in a program that has just begun. Nothing where the C library is not glibc.
void release_freed_memory();

/// Watches the resident memory of the process from its making on.
///
/// Linux only: it sets the high-water mark of /proc/self/status back. Other work in the process
/// counts, too.
class PeakMemory {
 public:
  PeakMemory();
  /// The largest growth since; empty where the system does not tell.
  std::optional<std::size_t> bytes() const;

 private:
  std::optional<std::size_t> before_;
};

}  // namespace evaluation
