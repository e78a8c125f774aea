#include "evaluation/readers/zip_archive.h"

#include <algorithm>
#include <memory>
#include <new>

#include "brdf/error.h"

namespace evaluation::detail {

ZipArchive::ZipArchive(const FileSource& source) : source_(source) {
  zip_error_init(&error_);
  zip_source_t* const bytes = zip_source_function_create(serve, this, &error_);
  if (!bytes) throw std::bad_alloc();
  archive_ = zip_open_from_source(bytes, ZIP_RDONLY | ZIP_CHECKCONS, &error_);
  if (archive_) return;
  const std::string reason = zip_error_strerror(&error_);
  zip_source_free(bytes);
  zip_error_fini(&error_);
  refuse("no sound zip archive: " + reason);
}

ZipArchive::~ZipArchive() {
  zip_discard(archive_);
  zip_error_fini(&error_);
}

bool ZipArchive::holds(const std::string& entry) const {
  return zip_name_locate(archive_, entry.c_str(), 0) >= 0;
}

std::uint64_t ZipArchive::size(const std::string& entry) const {
  zip_stat_t stat;
  if (zip_stat(archive_, entry.c_str(), 0, &stat) != 0 || !(stat.valid & ZIP_STAT_SIZE))
    refuse("archive has no " + entry);
  if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) && stat.encryption_method != ZIP_EM_NONE)
    refuse(entry + " is encrypted");
  return stat.size;
}

std::string ZipArchive::read(const std::string& entry, std::uint64_t most) const {
  const std::uint64_t expected = size(entry);
  if (expected > most)
    refuse(entry + " has " + std::to_string(expected) + " bytes, at most " + std::to_string(most) +
           " are read");
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
      zip_fopen(archive_, entry.c_str(), 0), zip_fclose);
  if (!file) refuse(entry + " cannot be read: " + zip_strerror(archive_));
  // Pages that are reserved but not filled cost nothing, so a length that the packed bytes do not
  // bear out takes no memory. The read beyond the end is where libzip checks the sum.
  constexpr std::uint64_t piece = 1 << 20;
  std::string bytes;
  bytes.reserve(expected + 1);
  while (true) {
    const std::size_t done = bytes.size();
    bytes.resize(std::min(done + piece, expected + 1));
    const zip_int64_t got = zip_fread(file.get(), bytes.data() + done, bytes.size() - done);
    if (got < 0)
      refuse(entry + " cannot be read: " + zip_error_strerror(zip_file_get_error(file.get())));
    bytes.resize(done + static_cast<std::size_t>(got));
    if (got == 0 || bytes.size() > expected) break;
  }
  if (bytes.size() != expected)
    refuse(entry + " is not as long as the archive says, " + std::to_string(expected) + " bytes");
  return bytes;
}

void ZipArchive::refuse(const std::string& what) const {
  throw brdf::Error(brdf::Errc::bad_input, source_.name() + ": X3P: " + what);
}

zip_int64_t ZipArchive::serve(void* self, void* data, zip_uint64_t count,
                              zip_source_cmd_t command) {
  return static_cast<ZipArchive*>(self)->serve(data, count, command);
}

zip_int64_t ZipArchive::serve(void* data, zip_uint64_t count, zip_source_cmd_t command) {
  switch (command) {
    case ZIP_SOURCE_OPEN:
      position_ = 0;
      return 0;
    case ZIP_SOURCE_READ:
      // No exception may pass through libzip.
      try {
        const std::size_t got = source_.read_at(position_, static_cast<char*>(data), count);
        position_ += got;
        return static_cast<zip_int64_t>(got);
      } catch (const brdf::Error&) {
        zip_error_set(&error_, ZIP_ER_READ, 0);
        return -1;
      }
    case ZIP_SOURCE_SEEK: {
      const zip_int64_t place =
          zip_source_seek_compute_offset(position_, source_.size(), data, count, &error_);
      if (place < 0) return -1;
      position_ = static_cast<std::uint64_t>(place);
      return 0;
    }
    case ZIP_SOURCE_TELL:
      return static_cast<zip_int64_t>(position_);
    case ZIP_SOURCE_STAT: {
      auto* const stat = static_cast<zip_stat_t*>(data);
      zip_stat_init(stat);
      stat->valid = ZIP_STAT_SIZE;
      stat->size = source_.size();
      return sizeof *stat;
    }
    case ZIP_SOURCE_ERROR:
      return zip_error_to_data(&error_, data, count);
    case ZIP_SOURCE_CLOSE:
    case ZIP_SOURCE_FREE:
      return 0;
    case ZIP_SOURCE_SUPPORTS:
      return zip_source_make_command_bitmap(
          ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR,
          ZIP_SOURCE_FREE, ZIP_SOURCE_SEEK, ZIP_SOURCE_TELL, ZIP_SOURCE_SUPPORTS, -1);
    default:
      zip_error_set(&error_, ZIP_ER_OPNOTSUPP, 0);
      return -1;
  }
}

}  // namespace evaluation::detail
