// Files that are cut off, or damaged: they are refused, or read, and nothing else happens.
#pragma once

#include <catch2/catch.hpp>
#include <ctime>
#include <string>

#include "brdf/error.h"
#include "evaluation/peak_memory.h"
#include "evaluation/readers/file_source.h"
#include "evaluation/readers/height_reader.h"

inline evaluation::HeightFile read_bytes(const std::string& bytes,
                                         const evaluation::HeightChoice& choice = {}) {
  return evaluation::read_heights(evaluation::FileSource("file", bytes), choice);
}

/// The message of the refusal; empty where the bytes are read, which a caller checks for.
inline std::string refusal_of(const std::string& bytes,
                              const evaluation::HeightChoice& choice = {}) {
  try {
    read_bytes(bytes, choice);
    return "";
  } catch (const brdf::Error& error) {
    return error.what();
  }
}

/// The beginnings of a file, each a byte longer, up to the last byte.
inline void check_every_cut_refused(const std::string& bytes,
                                    const evaluation::HeightChoice& choice = {}) {
  REQUIRE_NOTHROW(read_bytes(bytes, choice));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    INFO(size << " of " << bytes.size() << " bytes");
    CHECK(refusal_of(bytes.substr(0, size), choice) != "");
  }
}

/// Each byte in turn replaced: any outcome but a refusal or heights ends the test. What sanitizers
/// say is a failure, too. Files that sizes blow up must be refused by the limit.
inline void try_every_byte_changed(const std::string& bytes, evaluation::HeightChoice choice = {}) {
  choice.max_pixels = 1 << 16;
  std::size_t refused = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (const char other : {'\x00', '\x01', '\x7f', '\xff', static_cast<char>(bytes[at] ^ 0x20)}) {
      std::string damaged = bytes;
      damaged[at] = other;
      refused += refusal_of(damaged, choice).empty() ? 0 : 1;
    }
  CHECK(refused > 0);
}

/// What a refused file may cost: a second of the processor, which a busy machine does not stretch,
/// and 64 MB above what was there.
template <class Attempt>
void check_cheap(Attempt attempt) {
  const evaluation::PeakMemory memory;
  const std::clock_t before = std::clock();
  attempt();
  CHECK(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC < 1);
  const auto bytes = memory.bytes();
  REQUIRE(bytes);
  CHECK(*bytes < std::size_t{64} << 20);
}
