// Files that have no name, or one that tells whether they were left behind.
#pragma once

#include <filesystem>
#include <string>

namespace evaluation {

/// A file in a folder, gone with the process until it is renamed to where it belongs.
///
/// It has no name where the file system knows such files (O_TMPFILE), and
/// `.shedlight-<16 hex digits>.tmp` elsewhere. A lock on it lasts as long as the run that writes
/// it: one without was left behind, and the next run in that folder removes it.
class TemporaryFile {
 public:
  /// Throws std::system_error where the folder takes no new file.
  explicit TemporaryFile(const std::filesystem::path& folder);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  int descriptor() const { return descriptor_; }

  // What a forked process may call: system calls alone. 0, or the number of the error.
  int give_name() const noexcept;
  int rename_to(const char* target) const noexcept;
  /// A second name, for a target that must not be there yet.
  int link_to(const char* target) const noexcept;
  void remove_name() const noexcept;

  /// Somebody else has renamed it, or is about to: from here on the name is not removed.
  void let_go() noexcept;

 private:
  bool open_named();

  std::string name_, source_;  ///< source: where the kernel shows a file without a name
  int descriptor_ = -1;
  int registered_ = -1;  ///< place among the names that a signal removes; -1 without
};

/// Removes the names of all temporary files of this process. Only system calls: for handlers of
/// signals that end it.
void remove_temporary_names() noexcept;

}  // namespace evaluation
