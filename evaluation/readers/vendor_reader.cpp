#include "evaluation/readers/vendor_reader.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "brdf/error.h"
#include "evaluation/private_folder.h"
#include "evaluation/readers/file_bytes.h"
#include "evaluation/readers/gwy_reader.h"

namespace evaluation::detail {
namespace {

namespace fs = std::filesystem;
using brdf::Errc;
using brdf::Error;

constexpr std::chrono::seconds longest_run{60};

/// Of the formats that Gwyddion 2.62 reads, those that hold height fields (gwyddion --help lists
/// none; the list is in its user guide, "Supported File Formats").
constexpr std::array vendor_extensions{
    ".afm", ".al3d", ".ardf", ".bcr",  ".bcrf", ".dat", ".ezd", ".flt", ".hdf5", ".ibw",
    ".jpk", ".lext", ".mdt",  ".mi",   ".mtrx", ".nid", ".nhf", ".oir", ".opd",  ".opdx",
    ".par", ".plu",  ".plux", ".poir", ".psi",  ".sm3", ".sm4", ".spm", ".stp",  ".sur",
    ".sxm", ".top",  ".tap",  ".vk3",  ".vk4",  ".vk6", ".wip", ".xqd", ".zmg",  ".zon"};

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// Starts a program of the PATH in a process group of its own, deaf and mute; 0 where there is
/// none.
pid_t started(std::vector<std::string> command, const fs::path& home) {
  const char* path = std::getenv("PATH");
  std::vector<std::string> environment{std::string("PATH=") + (path ? path : "/usr/bin:/bin"),
                                       "HOME=" + home.string(), "LC_ALL=C"};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, command[0].c_str(), &actions, &attributes,
                                  pointers(command).data(), pointers(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return failed == 0 ? child : 0;
}

/// Waits for a program to end, and ends it where it takes too long. Whether it ended by itself.
bool has_ended(pid_t child) {
  const auto deadline = std::chrono::steady_clock::now() + longest_run;
  int status = 0;
  for (;;) {
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child || (ended < 0 && errno != EINTR)) return true;
    if (std::chrono::steady_clock::now() > deadline) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(-child, SIGKILL);
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return false;
}

}  // namespace

bool is_vendor_name(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  // Nanoscope numbers its files.
  const bool is_number =
      extension.size() == 4 && std::all_of(extension.begin() + 1, extension.end(),
                                           [](unsigned char c) { return std::isdigit(c) != 0; });
  return is_number || std::ranges::find(vendor_extensions, extension) != vendor_extensions.end();
}

RawHeights decode_through_gwyddion(const fs::path& path, const HeightRequest& request) {
  const std::string name = path.string();
  const auto refuse = [&](const std::string& what) {
    throw Error(Errc::bad_input, name + ": not a known format; " + what);
  };
  const PrivateFolder folder;
  const fs::path converted = folder / "converted.gwy";
  // From the root: a name that begins with - would be an option.
  const pid_t child =
      started({"gwyddion", "--convert-to-gwy=" + converted.string(), fs::absolute(path).string()},
              folder.path());
  if (child == 0)
    refuse(
        "vendor files are read through Gwyddion, which is not installed (apt-get install "
        "gwyddion)");
  if (!has_ended(child))
    refuse("Gwyddion did not convert it within " + std::to_string(longest_run.count()) + " s");
  if (!fs::exists(converted)) refuse("Gwyddion does not know it either");
  RawHeights raw = decode_gwy(FileSource(name, read_file_bytes(converted)), request);
  raw.format = "converted by Gwyddion, 64 bit float";
  return raw;
}

}  // namespace evaluation::detail
