// A file that is read no further than its decoder asks for.
#pragma once

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <string>
#include <string_view>

namespace evaluation {

/// A stretch of a file.
struct FileRange {
  std::uint64_t begin = 0, size = 0;
};

/// A regular file, opened, or bytes in memory: its size and beginning are known before the rest is
/// read, so that a header can be refused without the memory for what follows it.
class FileSource {
 public:
  /// Throws Errc::bad_input where it is missing, no regular file, empty or unreadable.
  explicit FileSource(const std::filesystem::path& path);
  /// What another program would have in a file of that name.
  FileSource(std::string name, std::string bytes);
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;
  ~FileSource();

  const std::string& name() const { return name_; }
  std::uint64_t size() const { return size_; }
  /// No for bytes that were given in memory.
  bool is_on_disk() const { return descriptor_ >= 0; }
  /// The first bytes, fewer where the file is shorter. At most `head_bytes`.
  std::string_view head() const { return std::string_view(bytes_).substr(0, head_bytes); }
  /// The whole file, read when first asked for. Throws Errc::bad_input where it cannot be read, or
  /// has become shorter.
  std::string_view bytes() const;
  /// The same, given away: nothing is left here.
  std::string take() &&;
  /// Copies what there is from `offset` on, without keeping it; returns how many bytes, fewer than
  /// `count` only at the end of the file. Throws Errc::bad_input where it cannot be read.
  std::size_t read_at(std::uint64_t offset, char* to, std::size_t count) const;
  /// A copy of what there is of a range, without keeping it. Throws as `read_at`.
  std::string bytes_of(FileRange range) const;
  /// SHA-256 of the whole file in lower-case hexadecimal, without keeping it. Throws as `read_at`,
  /// and where the file has been written to since it was opened.
  std::string sha256() const;

  /// Longer than the header of any format.
  static constexpr std::size_t head_bytes = 1 << 16;

 private:
  [[noreturn]] void refuse(const std::string& what) const;
  void read_to(std::uint64_t size) const;
  void require_unwritten() const;
  void fetch(std::uint64_t offset, char* to, std::size_t count) const;

  std::string name_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  timespec written_{};  ///< when the file was last, as it was opened
  mutable std::string bytes_;
};

}  // namespace evaluation
