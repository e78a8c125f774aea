// Finished parts of a computation that outlive it.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace evaluation {

/// Keeps chunks of a result; `Checkpoint` does on disk. load and store may be called from many
/// threads, for different chunks.
class ChunkStore {
 public:
  virtual ~ChunkStore() = default;
  /// Before anything else: how many chunks there are, and the bytes of the largest.
  virtual void open(std::size_t count, std::size_t bytes) = 0;
  /// Whether chunk i is known; if so, it is copied.
  virtual bool load(std::size_t i, std::span<std::byte> chunk) const = 0;
  virtual void store(std::size_t i, std::span<const std::byte> chunk) = 0;
  /// What is left when a run ends before its time: "... keeps what is done".
  virtual std::string kept() const = 0;
};

/// Takes a chunk from the store, or computes it and stores it. store: null to compute always.
template <class T, class Compute>
void once(ChunkStore* store, std::size_t i, std::span<T> chunk, const Compute& compute) {
  const auto bytes = std::as_writable_bytes(chunk);
  if (store != nullptr && store->load(i, bytes)) return;
  compute();
  if (store != nullptr) store->store(i, bytes);
}

}  // namespace evaluation
