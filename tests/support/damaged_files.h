// Files that are cut off, or damaged: they are refused, or read, and nothing else happens.
#pragma once

#include <catch2/catch.hpp>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "brdf/error.h"
#include "evaluation/peak_memory.h"
#include "evaluation/readers/file_source.h"
#include "evaluation/readers/height_formats.h"
#include "evaluation/readers/height_reader.h"
#include "tests/support/refusal_cost.h"

inline evaluation::HeightFile read_bytes(const std::string& bytes,
                                         const evaluation::HeightChoice& choice = {}) {
  return evaluation::read_heights(evaluation::FileSource("file", bytes), choice);
}

inline evaluation::HeightRequest request_for(std::optional<std::string> channel = {}) {
  return {std::move(channel), 1 << 20};
}

/// As stored, by the format that recognises the content.
inline evaluation::RawHeights decoded(const evaluation::FileSource& source,
                                      const evaluation::HeightRequest& request = request_for()) {
  const evaluation::HeightFormat* format = evaluation::height_format_of(source.head());
  if (!format || !format->is_built_in)
    throw brdf::Error(brdf::Errc::bad_input, source.name() + ": no format that is built in");
  return format->decode(source, request);
}

inline evaluation::RawHeights decoded(const std::filesystem::path& path,
                                      const evaluation::HeightRequest& request = request_for()) {
  return decoded(evaluation::FileSource(path), request);
}

inline evaluation::RawHeights decoded_bytes(
    const std::string& bytes, const evaluation::HeightRequest& request = request_for()) {
  return decoded(evaluation::FileSource("file", bytes), request);
}

/// The message that refuses an attempt; empty where it is done.
template <class Attempt>
std::string refusal_in(Attempt attempt) {
  try {
    attempt();
    return "";
  } catch (const brdf::Error& error) {
    return error.what();
  }
}

/// Of bytes that are to be heights, with their scale.
inline std::string refusal_of(const std::string& bytes,
                              const evaluation::HeightChoice& choice = {}) {
  return refusal_in([&] { read_bytes(bytes, choice); });
}

/// Of bytes that are to be decoded, whatever their scale.
inline std::string decoder_refusal(const std::string& bytes,
                                   const evaluation::HeightRequest& request = request_for()) {
  return refusal_in([&] { decoded_bytes(bytes, request); });
}

/// One line that holds the part.
inline void check_names(const std::string& refusal, const std::string& part) {
  CHECK_THAT(refusal, Catch::Contains(part));
  CHECK(refusal.find('\n') == std::string::npos);
}

/// Checks that a file that is read whole is refused in one line when cut after any of its bytes.
inline void check_refused_wherever_cut(const std::string& bytes,
                                       const evaluation::HeightRequest& request = request_for()) {
  REQUIRE(decoder_refusal(bytes, request) == "");
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    INFO("cut after " << size << " of " << bytes.size() << " bytes");
    const std::string refusal = decoder_refusal(bytes.substr(0, size), request);
    CHECK(refusal != "");
    CHECK(refusal.find('\n') == std::string::npos);
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

/// Checks that a refusal costs no more than it may.
template <class Attempt>
void check_cheap(Attempt attempt) {
  const evaluation::PeakMemory memory;
  const std::clock_t before = std::clock();
  attempt();
  CHECK(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC < most_seconds);
  const auto bytes = memory.bytes();
  REQUIRE(bytes);
  CHECK(*bytes < most_bytes);
}
