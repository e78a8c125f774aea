// The serialised objects of Gwyddion's native files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace evaluation::detail {

/// One item of an object: its bytes are those of the value alone.
struct GwyItem {
  std::string_view key;
  char type;                     ///< b c i q d s o, and C I Q D S O for arrays of them
  std::string_view bytes;        ///< a string without its NUL, an array without its count
  std::string_view object = {};  ///< name of the type of an object
};

/// One pass over the items of an object, little-endian: key, NUL, type, value. Every size is held
/// against what is left; objects in it are stepped over, not entered. Refers to its bytes.
///
/// Each item takes bytes of the file, so that a pass takes no more time than reading them.
class GwyItems {
 public:
  GwyItems(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  /// Empty at the end. Throws Errc::bad_input where an item does not fit or its type is unknown.
  std::optional<GwyItem> next();

  /// The object at the beginning, for the file itself.
  GwyItem object();
  bool at_end() const { return rest_.empty(); }

 private:
  [[noreturn]] void refuse(const std::string& what) const;
  std::string_view take(std::uint64_t count);
  std::string_view text();
  std::uint32_t count();
  /// The bytes of a value, stepped over.
  std::string_view value(char type);

  std::string_view rest_;
  const std::string& name_;
};

}  // namespace evaluation::detail
