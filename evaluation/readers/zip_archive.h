// Entries of a zip archive, through libzip.
#pragma once

#include <zip.h>

#include <cstdint>
#include <string>

#include "evaluation/readers/file_source.h"

namespace evaluation::detail {

/// The bytes of the archive are read as libzip asks for them. Throws Errc::bad_input where it is no
/// sound archive, or has several entries of a name.
class ZipArchive {
 public:
  explicit ZipArchive(const FileSource& source);
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;
  ~ZipArchive();

  bool holds(const std::string& entry) const;
  /// The length of an entry when it is unpacked, by the archive's directory. Throws where there is
  /// no such entry, or it is encrypted.
  std::uint64_t size(const std::string& entry) const;
  /// An entry unpacked. Throws where it is longer or shorter than its directory says, its checksum
  /// is wrong, or it is longer than `most` bytes, before any are taken.
  std::string read(const std::string& entry, std::uint64_t most) const;

  [[noreturn]] void refuse(const std::string& what) const;

 private:
  static zip_int64_t serve(void* self, void* data, zip_uint64_t count, zip_source_cmd_t command);
  zip_int64_t serve(void* data, zip_uint64_t count, zip_source_cmd_t command);

  const FileSource& source_;
  std::uint64_t position_ = 0;
  zip_error_t error_;
  zip_t* archive_ = nullptr;
};

}  // namespace evaluation::detail
