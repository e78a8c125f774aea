#include "tests/cli/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

extern char** environ;

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& what, int error) {
  throw std::system_error(error, std::generic_category(), what);
}

/// A file in memory that catches what a program writes: it never blocks, as a pipe would.
class Catcher {
 public:
  Catcher() : descriptor_(memfd_create("caught", MFD_CLOEXEC)) {
    if (descriptor_ < 0) fail("memfd_create", errno);
  }
  Catcher(const Catcher&) = delete;
  Catcher& operator=(const Catcher&) = delete;
  ~Catcher() { close(descriptor_); }

  int descriptor() const { return descriptor_; }
  std::string text() const {
    std::string all;
    char buffer[1 << 16];
    off_t at = 0;
    for (ssize_t count; (count = pread(descriptor_, buffer, sizeof buffer, at)) > 0; at += count)
      all.append(buffer, static_cast<std::size_t>(count));
    return all;
  }

 private:
  int descriptor_;
};

std::vector<std::string> environment_with(const Environment& changes) {
  std::vector<std::string> result;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (!changes.contains(text.substr(0, text.find('=')))) result.push_back(text);
  }
  for (const auto& [name, value] : changes)
    if (value) result.push_back(name + "=" + *value);
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

Words with_program(Words arguments) {
  arguments.insert(arguments.begin(), SHEDLIGHT_PROGRAM);
  return arguments;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("no file " + path.string());
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

}  // namespace

struct Running::Streams {
  Catcher out, err;
};

Running::Running(Words command, const fs::path& folder, const Environment& changes,
                 const std::string& out_file)
    : streams_(std::make_unique<Streams>()) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  if (out_file.empty())
    posix_spawn_file_actions_adddup2(&actions, streams_->out.descriptor(), STDOUT_FILENO);
  else
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_file.c_str(), O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, streams_->err.descriptor(), STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::vector<std::string> variables = environment_with(changes);
  const int failed = posix_spawnp(&process_, command.front().c_str(), &actions, nullptr,
                                  pointers(command).data(), pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) fail(command.front(), failed);
}

Running::~Running() {
  if (process_ == 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

void Running::signal(int number) const {
  kill(process_, number);
}

Outcome Running::wait() {
  int status = 0;
  rusage usage{};
  while (wait4(process_, &status, 0, &usage) < 0)
    if (errno != EINTR) fail("wait4", errno);
  process_ = 0;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return {code, streams_->out.text(), streams_->err.text(),
          seconds(usage.ru_utime) + seconds(usage.ru_stime), usage.ru_maxrss};
}

Words words(const std::string& command) {
  Words result;
  std::istringstream stream(command);
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

Words operator+(Words command, const std::string& argument) {
  command.push_back(argument);
  return command;
}

std::string Scratch::read(const std::string& name) const {
  return bytes_of(path() / name);
}

bool Scratch::holds(const std::string& name) const {
  return fs::exists(fs::symlink_status(path() / name));
}

std::map<std::string, std::string> Scratch::contents() const {
  std::map<std::string, std::string> all;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path())) {
    std::string& bytes = all[entry.path().lexically_relative(path()).string()];
    if (entry.is_symlink())
      bytes = "-> " + fs::read_symlink(entry.path()).string();
    else if (entry.is_regular_file())
      bytes = bytes_of(entry.path());
  }
  return all;
}

Running Scratch::start(const Words& arguments, const Environment& changes) const {
  return {with_program(arguments), path(), changes, ""};
}

Outcome Scratch::shedlight(const Words& arguments, const Environment& changes) const {
  return start(arguments, changes).wait();
}

Outcome Scratch::shedlight_into(const std::string& file, const std::string& arguments) const {
  return Running(with_program(words(arguments)), path(), {}, file).wait();
}

Outcome Scratch::run(const Words& command) const {
  return Running(command, path(), {}, "").wait();
}

void Scratch::prepare(const std::string& arguments) const {
  const Outcome outcome = shedlight(arguments);
  if (outcome.exit_code != 0)
    throw std::runtime_error("preparing with '" + arguments + "' failed: " + outcome.err);
}
