// A TIFF opened by libtiff: where its bytes come from, and where its complaints go.
#pragma once

#include <tiffio.h>

#include <cstdarg>
#include <cstdint>
#include <string>

#include "evaluation/readers/file_source.h"

namespace evaluation::detail {

/// Nothing is printed, no table longer than the file is allocated, and the bytes are read as
/// libtiff asks for them. Throws Errc::bad_input where the first directory cannot be read.
class TiffFile {
 public:
  explicit TiffFile(const FileSource& source);
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;
  ~TiffFile();

  TIFF* get() const { return tiff_; }
  const FileSource& source() const { return source_; }

  /// A tag, or the default that the standard gives it; refused where there is neither.
  template <class T>
  T field(ttag_t tag, const char* tag_name) const {
    T value{};
    if (!TIFFGetFieldDefaulted(tiff_, tag, &value)) refuse(std::string("has no ") + tag_name);
    return value;
  }

  [[noreturn]] void refuse(const std::string& what) const;
  /// With what libtiff said first.
  [[noreturn]] void refuse_read(const std::string& what) const;
  /// Refuses where libtiff went on with a guess: for a tag that it could not read, a table of
  /// strips that cannot be right, bytes beyond the end.
  void require_no_guess() const;

 private:
  static int on_error(TIFF*, void* data, const char*, const char* format, va_list values);
  static int on_warning(TIFF*, void* data, const char*, const char* format, va_list values);
  static tmsize_t read(thandle_t data, void* to, tmsize_t count);
  static toff_t seek(thandle_t data, toff_t offset, int whence);

  const FileSource& source_;
  TIFF* tiff_ = nullptr;
  std::uint64_t position_ = 0;
  std::string message_, guess_;
};

}  // namespace evaluation::detail
