#include "evaluation/readers/file_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "brdf/error.h"
#include "evaluation/sha256.h"

namespace evaluation {

FileSource::FileSource(const std::filesystem::path& path) : name_(path.string()) {
  // Without O_NONBLOCK a pipe without a writer would wait for ever.
  descriptor_ = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0)
    refuse(errno == ENOENT ? "no such file"
                           : std::string("cannot be read: ") + std::strerror(errno));
  try {
    struct stat status {};
    if (fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode))
      refuse("is not a regular file");
    if (status.st_size <= 0) refuse("file is empty");
    size_ = static_cast<std::uint64_t>(status.st_size);
    written_ = status.st_mtim;
    read_to(std::min<std::uint64_t>(size_, head_bytes));
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

FileSource::FileSource(std::string name, std::string bytes)
    : name_(std::move(name)), size_(bytes.size()), bytes_(std::move(bytes)) {
  if (bytes_.empty()) refuse("file is empty");
}

FileSource::~FileSource() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::string_view FileSource::bytes() const {
  read_to(size_);
  return bytes_;
}

std::string FileSource::take() && {
  read_to(size_);
  return std::move(bytes_);
}

std::size_t FileSource::read_at(std::uint64_t offset, char* to, std::size_t count) const {
  if (offset >= size_) return 0;
  count = std::min<std::uint64_t>(count, size_ - offset);
  if (offset + count <= bytes_.size())
    std::memcpy(to, bytes_.data() + offset, count);
  else
    fetch(offset, to, count);
  return count;
}

std::string FileSource::bytes_of(FileRange range) const {
  if (range.begin >= size_) return {};
  std::string bytes(std::min(range.size, size_ - range.begin), '\0');
  read_at(range.begin, bytes.data(), bytes.size());
  return bytes;
}

std::string FileSource::sha256() const {
  Sha256 hash;
  std::string piece(head_bytes, '\0');
  for (std::uint64_t at = 0; at < size_; at += head_bytes)
    hash.update(std::string_view(piece).substr(0, read_at(at, piece.data(), piece.size())));
  require_unwritten();
  return hash.hex();
}

void FileSource::require_unwritten() const {
  if (!is_on_disk()) return;
  struct stat status {};
  if (fstat(descriptor_, &status) != 0)
    refuse(std::string("cannot be read: ") + std::strerror(errno));
  if (static_cast<std::uint64_t>(status.st_size) != size_ ||
      status.st_mtim.tv_sec != written_.tv_sec || status.st_mtim.tv_nsec != written_.tv_nsec)
    refuse("file has changed while it was read");
}

void FileSource::read_to(std::uint64_t size) const {
  const std::size_t done = bytes_.size();
  if (done >= size) return;
  bytes_.resize(size);
  fetch(done, bytes_.data() + done, size - done);
}

void FileSource::fetch(std::uint64_t offset, char* to, std::size_t count) const {
  while (count > 0) {
    const ssize_t got = pread(descriptor_, to, count, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse(std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0) refuse("file has become shorter while it was read");
    offset += static_cast<std::uint64_t>(got);
    to += got;
    count -= static_cast<std::size_t>(got);
  }
}

void FileSource::refuse(const std::string& what) const {
  throw brdf::Error(brdf::Errc::bad_input, name_ + ": " + what);
}

}  // namespace evaluation
