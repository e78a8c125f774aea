// Preloaded into the program under test: a system that does what real ones hardly ever do.
// SHEDLIGHT_FAULT holds the names of the faults.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

bool has(const char* fault) {
  const char* faults = std::getenv("SHEDLIGHT_FAULT");
  return faults != nullptr && std::strstr(faults, fault) != nullptr;
}

/// The program itself, whatever process it forks.
const pid_t program = getpid();

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

int open_or_fail(const char* name, const char* path, int flags, mode_t mode) {
  if (has("no unnamed files") && (flags & O_TMPFILE) == O_TMPFILE) {
    errno = EOPNOTSUPP;
    return -1;
  }
  return real<int(const char*, int, ...)>(name)(path, flags, mode);
}

}  // namespace

extern "C" int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = va_arg(rest, mode_t);
  va_end(rest);
  return open_or_fail("open", path, flags, mode);
}

extern "C" ssize_t write(int descriptor, const void* bytes, size_t count) {
  if (has("slow writes")) {
    usleep(2'000);
    // Small ones stay whole: the stream that scripts of gnuplot go through knows no parts.
    if (count > 4096) count /= 8;
  }
  return real<ssize_t(int, const void*, size_t)>("write")(descriptor, bytes, count);
}

namespace {

/// Files that were synced, by their number; the process that renames has inherited them.
std::array<ino_t, 64> synced;
std::size_t synced_count = 0;

/// Renames that a power cut would undo: the folder was not synced since. Shared with the process
/// that renames.
std::atomic<int>& unsynced_renames =
    *new (mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
               MAP_SHARED | MAP_ANONYMOUS, -1, 0)) std::atomic<int>(0);

struct PowerCutAtTheEnd {
  ~PowerCutAtTheEnd() {
    if (getpid() == program && has("power cuts") && unsynced_renames != 0) _exit(99);
  }
} const at_the_end;

}  // namespace

extern "C" int fsync(int descriptor) {
  struct stat status {};
  const bool is_known = fstat(descriptor, &status) == 0;
  if (is_known && S_ISDIR(status.st_mode)) unsynced_renames = 0;
  if (is_known && synced_count < synced.size()) synced[synced_count++] = status.st_ino;
  return real<int(int)>("fsync")(descriptor);
}

namespace {

bool is_unsynced(const char* path) {
  struct stat status {};
  return stat(path, &status) == 0 && std::find(synced.begin(), synced.begin() + synced_count,
                                               status.st_ino) == synced.begin() + synced_count;
}

}  // namespace

extern "C" int rename(const char* from, const char* to) noexcept {
  if (has("slow renames")) usleep(20'000);
  if (has("power cuts") && is_unsynced(from)) {
    errno = EIO;
    return -1;
  }
  const int result = real<int(const char*, const char*)>("rename")(from, to);
  if (result == 0) ++unsynced_renames;
  if (has("killed at the first rename")) kill(program, SIGKILL);
  return result;
}
