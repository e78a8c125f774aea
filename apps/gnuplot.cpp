#include "apps/gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "apps/process.h"
#include "brdf/error.h"

extern char** environ;

namespace apps {

using brdf::Errc;
using brdf::Error;

const char* const dark_to_light =
    "set palette defined (0 '#000004', 1 '#2c115f', 2 '#721f81', 3 '#b73779', 4 '#f1605d', "
    "5 '#feb078', 6 '#fcfdbf')\n";

namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw Error(Errc::cannot_write, what);
}

/// A limit on the size of files holds for those in memory too, and gnuplot-iostream keeps quiet.
void require_whole(const MemoryFile& file, std::size_t bytes) {
  if (file.bytes().size() != bytes) refuse("the data of a picture do not fit into a file");
}

/// The last line of each script.
constexpr std::string_view last_line = "set output\n";

}  // namespace

MemoryFile::MemoryFile() : descriptor_(memfd_create("picture", 0)) {
  if (descriptor_ < 0)
    refuse(std::string("no memory for the files of a picture: ") + std::strerror(errno));
}

MemoryFile::~MemoryFile() {
  close(descriptor_);
}

std::string MemoryFile::bytes() const {
  std::string all;
  std::array<char, 1 << 16> buffer;
  for (ssize_t count; (count = pread(descriptor_, buffer.data(), buffer.size(),
                                     static_cast<off_t>(all.size()))) > 0;)
    all.append(buffer.data(), static_cast<std::size_t>(count));
  return all;
}

std::string Drawing::series(const std::vector<std::pair<double, double>>& points) {
  const MemoryFile& file = data_.emplace_back();
  std::string command = binFile1d(points, "record", file.path());
  require_whole(file, points.size() * 2 * sizeof(double));
  return command;
}

std::string Drawing::image(const std::vector<std::vector<double>>& rows) {
  const MemoryFile& file = data_.emplace_back();
  std::string command = binFile2d(rows, "array", file.path());
  require_whole(file, rows.size() * rows.front().size() * sizeof(double));
  return command;
}

std::string Drawing::file(std::string_view bytes) {
  const MemoryFile& file = data_.emplace_back();
  std::ofstream(file.path(), std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  require_whole(file, bytes.size());
  return quoted(file.path());
}

const MemoryFile& Drawing::script() {
  *this << last_line << std::flush;
  if (!script_->bytes().ends_with(last_line))
    refuse("the commands of a picture do not fit into a file");
  return *script_;
}

// Text that is no UTF-8, and control characters, have no place in an SVG.
// In single quotes nothing is special but the quote itself;
// gnuplot 5.4 misreads runs of doubled quotes, so each is joined on in double quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  const std::string json = evaluation::json_text(text);
  for (const char c : evaluation::Json::parse(json).get<std::string>()) {
    if (c == '\'')
      result += "'.\"'\".'";
    else
      result += static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? ' ' : c;
  }
  return result + "'";
}

std::pair<double, double> grid(const evaluation::Axis& axis) {
  if (axis.size() < 2) return {axis.front(), 1.0};
  return {axis.front(), (axis.back() - axis.front()) / static_cast<double>(axis.size() - 1)};
}

void set_range(Drawing& gp, const char* name, const evaluation::Axis& axis) {
  const auto [first, step] = grid(axis);
  const double half = std::abs(step) / 2;
  gp << fmt::format("set {} [{:.17g}:{:.17g}]\n", name, first - half, axis.back() + half);
}

namespace {

/// Starts it with its messages in a log. Throws Errc::cannot_write.
pid_t start_gnuplot(const std::string& script, const std::string& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  // Signals as ever: writing too much must end it, which here is ignored, and none is held.
  sigset_t fatal, none;
  sigemptyset(&fatal);
  sigaddset(&fatal, SIGXFSZ);
  sigemptyset(&none);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigdefault(&attributes, &fatal);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  std::string name = "gnuplot", defaults = "-d", file = script;
  char* arguments[] = {name.data(), defaults.data(), file.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &actions, &attributes, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (failed != 0)
    refuse(std::string("gnuplot cannot be started (") + std::strerror(failed) +
           "); pictures need it: apt-get install gnuplot-nox");
  return child;
}

void run_gnuplot(const std::string& script) {
  const MemoryFile log;
  pid_t child = 0;
  {
    const EndedWithUs gnuplot([&] { return start_gnuplot(script, log.path()); });
    child = gnuplot.child();
    siginfo_t ended;  // until its number may be another's
    while (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT) < 0 &&
           errno == EINTR) {
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    refuse(fmt::format("gnuplot was killed by signal {} {}", WTERMSIG(status), log.bytes()));
  if (WEXITSTATUS(status) != 0) refuse("gnuplot failed: " + log.bytes());
}

/// All three look the same at 72 units of SVG or PDF an inch: pngcairo takes a point of a font for
/// 4/3 pixels as the others do not, and pdfcairo halves widths and lengths of dashes.
std::string terminal(PictureSize size, PictureFormat format) {
  switch (format) {
    case PictureFormat::png:
      return fmt::format("pngcairo noenhanced size {},{} font 'sans,13'", size.width, size.height);
    case PictureFormat::svg:
      return fmt::format(
          "svg noenhanced size {},{} font 'sans-serif,13' fontscale 1.3333 background '#ffffff'",
          size.width, size.height);
    case PictureFormat::pdf:
      return fmt::format(
          "pdfcairo noenhanced size {:.4f}in,{:.4f}in font 'sans,13' fontscale 1 linewidth 2 "
          "dashlength 2",
          size.width / 72.0, size.height / 72.0);
  }
  return {};
}

/// The svg terminal draws points half as large again, and viewers smooth the cells of an image.
std::string like_png(std::string_view svg) {
  constexpr std::string_view point = "<use xlink:href='#gpPt", scale = " scale(", image = "<image ";
  constexpr double points = 2.0 / 3;
  std::string result;
  while (!svg.empty()) {
    const std::size_t end = std::min(svg.find('\n'), svg.size() - 1) + 1;
    std::string_view line = svg.substr(0, end);
    svg.remove_prefix(end);
    const bool is_point = line.find(point) != line.npos;
    if (const std::size_t at = line.find(scale); is_point && at != line.npos) {
      const std::size_t number = at + scale.size(), close = line.find(')', number);
      result.append(line.substr(0, number))
          .append(fmt::format("{:.2f}", points * std::atof(line.data() + number)));
      line.remove_prefix(close);
    } else if (line.starts_with(image)) {
      result.append(image).append("style='image-rendering:pixelated' ");
      line.remove_prefix(image.size());
    } else if (const std::size_t mark = line.find("]]>"); mark != line.npos) {
      result.append(line.substr(0, mark)).append("]]&gt;");  // the terminal lets '>' stand
      line.remove_prefix(mark + 3);
    }
    result.append(line);
  }
  return result;
}

/// The same picture has the same bytes. Blanks keep the places in the file, which it lists.
void remove_date(std::string& pdf) {
  const std::size_t first = pdf.rfind("/CreationDate (");
  if (first == pdf.npos) return;
  const std::size_t last = pdf.find(')', first);
  if (last != pdf.npos) pdf.replace(first, last + 1 - first, last + 1 - first, ' ');
}

}  // namespace

std::string draw(PictureSize size, PictureFormat format,
                 const std::function<void(Drawing&)>& commands) {
  const MemoryFile picture;
  Drawing drawing;
  drawing << "set terminal " << terminal(size, format) << "\nset output " << quoted(picture.path())
          << "\n";
  commands(drawing);
  run_gnuplot(drawing.script().path());
  std::string bytes = picture.bytes();
  if (bytes.empty()) refuse("gnuplot drew no picture");
  if (format == PictureFormat::svg) return like_png(bytes);
  if (format == PictureFormat::pdf) remove_date(bytes);
  return bytes;
}

}  // namespace apps
