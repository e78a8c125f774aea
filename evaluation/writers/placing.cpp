#include "evaluation/writers/placing.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <list>
#include <set>
#include <system_error>
#include <thread>

namespace evaluation {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(int error) {
  throw std::system_error(error, std::generic_category());
}

/// A folder that is held while files are renamed in it. One that may be written but not read, or
/// that knows no locks, is not held, and the hash in the sidecar has to do.
class HeldFolder {
 public:
  explicit HeldFolder(const fs::path& folder)
      : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    // Runs hold it for a moment; a script may hold it for the whole run, as `flock FOLDER` does.
    constexpr auto patience = std::chrono::seconds(5);
    const auto end = std::chrono::steady_clock::now() + patience;
    while (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK &&
           std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  HeldFolder(const HeldFolder&) = delete;
  HeldFolder& operator=(const HeldFolder&) = delete;
  ~HeldFolder() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  void release() const { flock(descriptor_, LOCK_UN); }
  void sync() const { fsync(descriptor_); }

 private:
  int descriptor_;
};

/// 0, or the number of the error. Only system calls.
int name_and_rename(std::span<const Placement> files) noexcept {
  int error = 0;
  for (const Placement& each : files)
    if (error == 0) error = each.file->give_name();
  for (const Placement& each : files)
    if (error == 0) error = each.file->rename_to(each.target.c_str());
  if (error != 0)
    for (const Placement& each : files) each.file->remove_name();
  return error;
}

/// The same in a process that signals to this one, or to its group, do not reach.
int in_own_process(std::span<const Placement> files) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  const pid_t child = fork();
  if (child == 0) {
    setsid();
    _exit(name_and_rename(files));
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (child < 0) return name_and_rename(files);  // no room for a process: better so than not
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : EINTR;
}

}  // namespace

void place(std::span<const Placement> files) {
  for (const Placement& each : files)
    if (fsync(each.file->descriptor()) != 0) fail(errno);
  std::set<fs::path> folders;  // in one order for all runs: no two of them wait for each other
  for (const Placement& each : files) folders.insert(fs::absolute(each.target).parent_path());
  std::list<HeldFolder> held;
  for (const fs::path& folder : folders) held.emplace_back(folder);
  for (const Placement& each : files) each.file->let_go();
  if (const int error = in_own_process(files); error != 0) fail(error);
  for (const HeldFolder& folder : held) folder.release();
  for (const HeldFolder& folder : held) folder.sync();
}

}  // namespace evaluation
