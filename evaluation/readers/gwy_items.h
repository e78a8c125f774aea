// The serialised objects of Gwyddion's native files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "evaluation/readers/file_source.h"

namespace evaluation::detail {

/// One item of an object: its range is that of the value alone.
struct GwyItem {
  std::string key;
  char type;                ///< b c i q d s o, and C I Q D S O for arrays of them
  FileRange value;          ///< a string without its NUL, an array without its count
  std::string object = {};  ///< name of the type of an object
};

/// One pass over the items of an object, little-endian: key, NUL, type, value. Every size is held
/// against what is left; objects in it are stepped over, not entered. Refers to its file.
///
/// Values are stepped over without being read, but for texts, whose ends must be found.
class GwyItems {
 public:
  GwyItems(const FileSource& source, FileRange object)
      : source_(source), at_(object.begin), end_(object.begin + object.size) {}

  /// Empty at the end. Throws Errc::bad_input where an item does not fit, its type is unknown, its
  /// key is longer than `longest_name` or a text in it than `longest_text`.
  std::optional<GwyItem> next();

  /// The object at the beginning, for the file itself.
  GwyItem object();
  bool at_end() const { return at_ == end_; }

 private:
  [[noreturn]] void refuse(const std::string& what) const;
  /// What is at hand from a place on: at least `least` bytes, fewer only at the end.
  std::string_view at_hand(std::uint64_t at, std::size_t least);
  FileRange take(std::uint64_t count);
  char character();
  std::uint32_t count();
  FileRange text(std::uint64_t longest);
  std::string name();
  /// A value, stepped over.
  FileRange value(char type);

  const FileSource& source_;
  std::uint64_t at_, end_;
  std::string window_;
  std::uint64_t window_at_ = 0;
};

/// A name, title or unit in the file. Throws Errc::bad_input where it is longer than
/// `longest_name`.
std::string gwy_name(const FileSource& source, FileRange name);

/// Longer than any that Gwyddion writes.
constexpr std::uint64_t longest_name = 1 << 16, longest_text = 1 << 24;

[[noreturn]] void refuse_gwy(const std::string& name, const std::string& what);

}  // namespace evaluation::detail
