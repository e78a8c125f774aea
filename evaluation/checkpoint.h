// A computation's finished chunks on disk, from which another run goes on.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "evaluation/chunk_store.h"
#include "nlohmann/json.hpp"

namespace evaluation {

/// What a run found in its checkpoint.
struct Resumed {
  std::size_t chunks, taken_over, damaged;
};

/// A file with the request and a slot for each chunk.
///
/// Three lines: `shedlight checkpoint 1`, the SHA-256 of the next line, and a JSON object with
/// `request`, `chunks` and `bytes`. Then the slots, each the SHA-256 (64 hexadecimal digits) of its
/// number and bytes, and the bytes as they lie in memory, little-endian. A slot of zeros is empty.
/// A chunk whose hash is wrong is computed anew, so a crash in the middle of writing costs that
/// chunk. Chunks are written as they are done, and synced every five seconds.
class Checkpoint final : public ChunkStore {
 public:
  /// request: every parameter that the chunks depend on. report: told what was found, where the
  /// file was there before.
  Checkpoint(std::filesystem::path file, nlohmann::ordered_json request,
             std::function<void(const Resumed&)> report);
  Checkpoint(const Checkpoint&) = delete;
  Checkpoint& operator=(const Checkpoint&) = delete;
  ~Checkpoint() override;

  /// Makes the file, or takes over what is in it. Throws Errc::bad_input, naming the file, where it
  /// is no checkpoint, has another request (the first difference is named with both values), or is
  /// in use by another run; Errc::cannot_write.
  void open(std::size_t count, std::size_t bytes) override;
  bool load(std::size_t i, std::span<std::byte> chunk) const override;
  void store(std::size_t i, std::span<const std::byte> chunk) override;
  std::string kept() const override;

  /// Removes the file, once what it was for is in place.
  void remove();

 private:
  std::string head(std::size_t count, std::size_t bytes) const;
  void make(const std::string& head) const;
  void lock();
  void require_head(const std::string& head) const;
  Resumed find_valid(std::size_t count);
  off_t place(std::size_t i) const;
  [[noreturn]] void refuse(const std::string& what) const;

  std::filesystem::path file_;
  nlohmann::ordered_json request_;
  std::function<void(const Resumed&)> report_;
  int descriptor_ = -1;
  std::size_t head_bytes_ = 0, bytes_ = 0;
  std::vector<bool> valid_;
  std::atomic<std::chrono::steady_clock::time_point> synced_;
};

}  // namespace evaluation
