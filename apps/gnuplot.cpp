#include "apps/gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "brdf/error.h"
#include "evaluation/readers/file_bytes.h"

extern char** environ;

namespace apps {

namespace fs = std::filesystem;
using brdf::Errc;
using brdf::Error;

const char* const dark_to_light =
    "set palette defined (0 '#000004', 1 '#2c115f', 2 '#721f81', 3 '#b73779', 4 '#f1605d', "
    "5 '#feb078', 6 '#fcfdbf')\n";

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "shedlight-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw Error(Errc::cannot_write, name + ": cannot be made: " + std::strerror(errno));
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

// In single quotes nothing is special but the quote itself;
// gnuplot 5.4 misreads runs of doubled quotes, so each is joined on in double quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'')
      result += "'.\"'\".'";
    else
      result += c == '\n' ? ' ' : c;
  }
  return result + "'";
}

std::pair<double, double> grid(const evaluation::Axis& axis) {
  if (axis.size() < 2) return {axis.front(), 1.0};
  return {axis.front(), (axis.back() - axis.front()) / static_cast<double>(axis.size() - 1)};
}

void set_range(Gnuplot& gp, const char* name, const evaluation::Axis& axis) {
  const auto [first, step] = grid(axis);
  const double half = std::abs(step) / 2;
  gp << fmt::format("set {} [{:.17g}:{:.17g}]\n", name, first - half, axis.back() + half);
}

std::string series(Gnuplot& gp, const std::vector<std::pair<double, double>>& points,
                   const std::string& file) {
  return gp.binFile1d(points, "record", file);
}

namespace {

void run_gnuplot(const std::string& script, const std::string& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::string name = "gnuplot", defaults = "-d", file = script;
  char* arguments[] = {name.data(), defaults.data(), file.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0)
    throw Error(Errc::cannot_write, std::string("gnuplot cannot be started (") +
                                        std::strerror(failed) +
                                        "); pictures need it: apt-get install gnuplot-nox");
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  std::stringstream said;
  said << std::ifstream(log).rdbuf();
  throw Error(Errc::cannot_write, "gnuplot failed: " + said.str());
}

}  // namespace

std::string draw_png(PictureSize size,
                     const std::function<void(Gnuplot&, const TemporaryFolder&)>& commands) {
  const TemporaryFolder folder;
  const std::string png = folder.file("picture.png");
  const std::string script = folder.file("plot.gp");
  {
    Gnuplot gp(">" + script);
    gp << fmt::format("set terminal pngcairo noenhanced size {},{} font 'sans,13'\n", size.width,
                      size.height);
    gp << "set output " << quoted(png) << "\n";
    commands(gp, folder);
    gp << "set output\n";
  }
  run_gnuplot(script, folder.file("gnuplot.log"));
  std::error_code ec;
  if (const auto bytes = fs::file_size(png, ec); ec || bytes == 0)
    throw Error(Errc::cannot_write, "gnuplot drew no picture");
  return evaluation::read_file_bytes(png);
}

}  // namespace apps
