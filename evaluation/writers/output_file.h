// Outputs that are whole or not there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "evaluation/sha256.h"
#include "nlohmann/json.hpp"

namespace evaluation {

using Json = nlohmann::ordered_json;

/// A file written beside its target and renamed over it at the end. Whatever fails before the end
/// leaves an older target as it was; the temporary is removed.
class OutputFile {
 public:
  /// Opens the temporary, so that a target that cannot be written is known before anything is
  /// computed. Throws Errc::cannot_write naming the target: a folder that is missing or not
  /// writable, a target that is no regular file.
  explicit OutputFile(const std::filesystem::path& target);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  const std::filesystem::path& target() const { return target_; }
  /// Writes all bytes. Throws Errc::cannot_write.
  void write(std::string_view bytes);
  /// Syncs, renames over the target and syncs the folder. Throws Errc::cannot_write.
  void commit();

 private:
  [[noreturn]] void refuse(const std::string& what) const;

  std::filesystem::path target_, temporary_;
  int descriptor_ = -1;
};

/// An output and its sidecar `<output>.json`, which says how it was made.
///
/// The sidecar holds the version, the command, every parameter as resolved, the SHA-256 of the
/// input and of the output, and what the method reports about its error. Both are opened before
/// the work and written after it, the output first: between the two renames the hash tells that
/// they do not belong together.
class OutputWithSidecar {
 public:
  explicit OutputWithSidecar(const std::filesystem::path& target);

  /// Appends to the output. Throws Errc::cannot_write.
  void write(std::string_view bytes);
  /// Puts output and sidecar in place; the output's name and hash are added to it. Returns it.
  Json commit(Json sidecar);
  /// The same, for an output that is there in one piece.
  Json commit(std::string_view bytes, Json sidecar) {
    write(bytes);
    return commit(std::move(sidecar));
  }

 private:
  OutputFile output_, sidecar_;
  Sha256 hash_;
};

/// `<output>.json`
std::filesystem::path sidecar_path(const std::filesystem::path& output);

/// Throws Errc::cannot_write, with both numbers, where the disk of an output has less room.
void require_room(const std::filesystem::path& target, std::uintmax_t bytes);

/// The sidecar of an output; null where there is none. Whether it belongs to it is not looked at.
///
/// Throws Errc::bad_input where it is no JSON object with a hash of the output, or too large.
Json read_sidecar(const std::filesystem::path& output);

/// The same, and throws Errc::bad_input where the hash in it is not the one given.
Json read_sidecar(const std::filesystem::path& output, const std::string& sha256);

}  // namespace evaluation
