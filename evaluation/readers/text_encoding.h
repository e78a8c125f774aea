// Texts of other systems as UTF-8.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "evaluation/readers/file_source.h"

namespace evaluation::detail {

/// A text without its byte order mark, UTF-16 of either order turned into UTF-8; a text without a
/// mark is taken as it is. What is no UTF-16 becomes U+FFFD, which is no part of any number.
/// Refers to its file, of which no more than a piece is held.
class Utf8Pieces {
 public:
  explicit Utf8Pieces(const FileSource& source);

  /// What comes next, until it is asked for again; empty at the end. Throws Errc::bad_input where
  /// the file cannot be read.
  std::string_view next();

 private:
  const FileSource* source_;
  std::uint64_t at_ = 0;
  std::optional<std::endian> utf16_;
  std::string bytes_, text_;
  std::size_t left_over_ = 0;  ///< bytes at the end of a piece that are half of a character
};

}  // namespace evaluation::detail
