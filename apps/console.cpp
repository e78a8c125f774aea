#include "apps/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

#include "brdf/error.h"

namespace apps {

void message(const std::string& text) {
  std::string line = text;
  std::replace(line.begin(), line.end(), '\n', ' ');
  line = fmt::format("shedlight: {}\n", line);
  // Where standard error takes nothing there is nobody to tell.
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void print(std::string_view result) {
  if (std::fwrite(result.data(), 1, result.size(), stdout) != result.size() ||
      std::fflush(stdout) != 0)
    throw brdf::Error(brdf::Errc::cannot_write, "standard output cannot be written");
}

void report_unattained(const std::string& line, Attainability attainability) {
  if (attainability == Attainability::refuse)
    throw brdf::Error(brdf::Errc::not_attainable, line + " (--strict)");
  message("warning: " + line);
}

evaluation::Progress progress_line(std::string_view what) {
  if (isatty(STDERR_FILENO) == 0) return {};
  struct State {
    std::string what;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    int shown = -1;
  };
  const auto state = std::make_shared<State>(State{std::string(what)});
  return [state](double done) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - state->start;
    const int percent = static_cast<int>(100 * done);
    const bool last = done >= 1;
    if (spent.count() < 1 || (percent == state->shown && !last)) return;
    state->shown = percent;
    std::fputs(fmt::format("\r{} {:3d} %  {:.0f} s{}", state->what, percent, spent.count(),
                           last ? "\n" : "")
                   .c_str(),
               stderr);
    std::fflush(stderr);
  };
}

}  // namespace apps
