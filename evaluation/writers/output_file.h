// Outputs that are whole or not there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evaluation/sha256.h"
#include "evaluation/writers/temporary_file.h"
#include "nlohmann/json.hpp"

namespace evaluation {

using Json = nlohmann::ordered_json;

/// A file that appears at its target whole, or not at all: until then it has no name, or a
/// temporary one in the same folder. Whatever fails before the end leaves an older target as it
/// was.
class OutputFile {
 public:
  /// Opens the file, so that a target that cannot be written is known before anything is
  /// computed. Throws Errc::cannot_write naming the target: a folder that is missing or not
  /// writable, a target that is no regular file.
  explicit OutputFile(const std::filesystem::path& target);

  const std::filesystem::path& target() const { return target_; }
  /// Writes all bytes. Throws Errc::cannot_write.
  void write(std::string_view bytes);

  /// Puts the finished file in place. Throws Errc::cannot_write.
  void commit() {
    OutputFile* const file = this;
    commit_together({&file, 1});
  }
  /// Puts finished files in place as one (`place` in placing.h). Throws Errc::cannot_write.
  static void commit_together(std::span<OutputFile* const> files);

 private:
  [[noreturn]] void refuse(const std::string& what) const;
  std::filesystem::path resolved() const;
  std::filesystem::path folder() const;

  std::filesystem::path target_;
  std::optional<TemporaryFile> file_;
};

/// An output and its sidecar `<output>.json`, which says how it was made.
///
/// The sidecar holds the version, the command, every parameter as resolved, the SHA-256 of the
/// input and of the output, and what the method reports about its error. Both are opened before
/// the work and put in place together after it.
class OutputWithSidecar {
 public:
  explicit OutputWithSidecar(const std::filesystem::path& target);

  /// Appends to the output. Throws Errc::cannot_write.
  void write(std::string_view bytes);
  /// Puts output and sidecar in place; the output's name and hash are added to it. Returns it.
  /// beside: finished files that belong to them.
  Json commit(Json sidecar, std::vector<OutputFile*> beside = {});
  /// The same, for an output that is there in one piece.
  Json commit(std::string_view bytes, Json sidecar, std::vector<OutputFile*> beside = {}) {
    write(bytes);
    return commit(std::move(sidecar), std::move(beside));
  }

 private:
  OutputFile output_, sidecar_;
  Sha256 hash_;
};

/// JSON as it is written, indented. Bytes of a file name that are no UTF-8 become U+FFFD.
std::string json_text(const Json& json);

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
