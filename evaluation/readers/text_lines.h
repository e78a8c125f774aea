// The lines of a text file, with the place for every refusal.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "evaluation/readers/text_encoding.h"

namespace evaluation::detail {

/// One pass over the lines of a text in UTF-8 or UTF-16, of which no more than a line and a piece
/// are held. A copy goes on from the same line. Refers to its file.
class TextLines {
 public:
  explicit TextLines(const FileSource& source) : pieces_(source), name_(&source.name()) {}

  /// Steps to the next line; false at the end. Throws Errc::bad_input for a line beyond
  /// `longest_line` and where the file cannot be read.
  bool next();
  /// Without its end, LF or CR LF. Holds until the next step.
  std::string_view line() const;

  /// Throws Errc::bad_input: "NAME: line 3: " + what.
  [[noreturn]] void refuse(const std::string& what) const;

  /// In UTF-8. Some 80,000 numbers of 17 digits with sign, exponent and separator; cells of a byte
  /// become numbers of eight.
  static constexpr std::size_t longest_line = std::size_t{1} << 21;

 private:
  Utf8Pieces pieces_;
  const std::string* name_;
  std::string buffer_;
  std::size_t begin_ = 0, size_ = 0, behind_ = 0;  ///< of the line; where the next one begins
  std::uint64_t number_ = 0;
};

}  // namespace evaluation::detail
