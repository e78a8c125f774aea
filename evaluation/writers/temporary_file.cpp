#include "evaluation/writers/temporary_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>
#include <string_view>
#include <system_error>

namespace evaluation {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = ".shedlight-", suffix = ".tmp";
constexpr std::size_t digits = 16;

std::string new_name() {
  std::random_device device;
  const auto number = static_cast<std::uint64_t>(device()) << 32 | device();
  char text[digits + 1];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
  return std::string(prefix) + text + std::string(suffix);
}

bool is_ours(std::string_view name) {
  return name.size() == prefix.size() + digits + suffix.size() && name.starts_with(prefix) &&
         name.ends_with(suffix) &&
         name.substr(prefix.size(), digits).find_first_not_of("0123456789abcdef") == name.npos;
}

/// What runs that were killed have left. A file that a run is still writing is locked by it.
void remove_left_behind(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (!is_ours(entry.path().filename().native())) continue;
    const int file = open(entry.path().c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    if (flock(file, LOCK_EX | LOCK_NB) == 0) unlink(entry.path().c_str());
    close(file);
  }
}

/// The names that a signal removes. Handlers may neither lock nor allocate, so the places are
/// fixed; a name that finds none is left to the next run.
struct Registered {
  std::atomic<bool> taken = false, set = false;
  std::array<char, PATH_MAX> name;
};
std::array<Registered, 16> registered_names;

int register_name(const std::string& name) {
  if (name.size() >= PATH_MAX) return -1;
  for (std::size_t i = 0; i < registered_names.size(); ++i) {
    Registered& place = registered_names[i];
    if (place.taken.exchange(true)) continue;
    std::memcpy(place.name.data(), name.c_str(), name.size() + 1);
    place.set = true;
    return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

void remove_temporary_names() noexcept {
  for (const Registered& place : registered_names)
    if (place.set) unlink(place.name.data());
}

TemporaryFile::TemporaryFile(const fs::path& folder) {
  remove_left_behind(folder);
  name_ = (folder / new_name()).string();
  descriptor_ = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
  source_ = "/proc/self/fd/" + std::to_string(descriptor_);
  if (descriptor_ >= 0 && access(source_.c_str(), F_OK) == 0) {
    flock(descriptor_, LOCK_EX);
    return;
  }
  if (descriptor_ >= 0) close(descriptor_);
  source_.clear();
  while (!open_named()) name_ = (folder / new_name()).string();
  registered_ = register_name(name_);
}

/// Whether the file is there and locked: another run may take it for left behind in between.
bool TemporaryFile::open_named() {
  descriptor_ = open(name_.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0666);
  if (descriptor_ < 0 && errno == EEXIST) return false;
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category());
  flock(descriptor_, LOCK_EX);
  struct stat status {};
  if (fstat(descriptor_, &status) == 0 && status.st_nlink > 0) return true;
  close(descriptor_);
  return false;
}

TemporaryFile::~TemporaryFile() {
  if (source_.empty()) {
    remove_name();
    let_go();
  }
  close(descriptor_);
}

int TemporaryFile::give_name() const noexcept {
  if (source_.empty()) return 0;
  const bool given =
      linkat(AT_FDCWD, source_.c_str(), AT_FDCWD, name_.c_str(), AT_SYMLINK_FOLLOW) == 0;
  return given ? 0 : errno;
}

int TemporaryFile::rename_to(const char* target) const noexcept {
  return rename(name_.c_str(), target) == 0 ? 0 : errno;
}

int TemporaryFile::link_to(const char* target) const noexcept {
  return link(name_.c_str(), target) == 0 ? 0 : errno;
}

void TemporaryFile::remove_name() const noexcept {
  unlink(name_.c_str());
}

void TemporaryFile::let_go() noexcept {
  if (registered_ < 0) return;
  Registered& place = registered_names[static_cast<std::size_t>(registered_)];
  place.set = false;
  place.taken = false;
  registered_ = -1;
}

}  // namespace evaluation
