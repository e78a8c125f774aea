#include "apps/process.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

#include "evaluation/writers/temporary_file.h"

namespace apps {
namespace {

constexpr pid_t starting = -1;
std::atomic<pid_t> running_child = 0;
constexpr int ending[] = {SIGINT, SIGTERM, SIGHUP};

extern "C" void end_cleanly(int signal) {
  evaluation::remove_temporary_names();
  pid_t child = running_child;
  for (; child == starting; child = running_child) usleep(100);  // by another thread: it goes on
  if (child > 0) kill(child, SIGKILL);
  raise(signal);  // SA_RESETHAND: now it kills, once the handler returns
}

/// A signal that is ignored stays so: nohup, and what a shell starts in the background.
void end_by(int signal) {
  struct sigaction action {};
  if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = end_cleanly;
  action.sa_flags = SA_RESETHAND;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void prepare_process() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0)  // opening takes the lowest that is free
      open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  for (const int signal : ending) end_by(signal);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGCHLD, SIG_DFL);  // who ignores it learns no child's status
}

EndedWithUs::EndedWithUs(const std::function<pid_t()>& start) {
  sigset_t held, before;
  sigemptyset(&held);
  for (const int signal : ending) sigaddset(&held, signal);
  pthread_sigmask(SIG_BLOCK, &held, &before);
  running_child = starting;
  try {
    child_ = start();
  } catch (...) {
    running_child = 0;
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    throw;
  }
  running_child = child_;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

EndedWithUs::~EndedWithUs() {
  running_child = 0;
}

}  // namespace apps
