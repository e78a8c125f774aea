// The table of figures against their targets.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>
#include <vector>

namespace benchmarks {

/// printf into a string.
[[gnu::format(printf, 1, 2)]] inline std::string format(const char* pattern, ...) {
  char buffer[512];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(buffer, sizeof buffer, pattern, arguments);
  va_end(arguments);
  return buffer;
}

class RatioTable {
 public:
  void at_least(const std::string& what, double measured, double target, const std::string& unit,
                const std::string& from) {
    const bool met = measured >= target;
    add(what, format("%.3g %s", measured, unit.c_str()), format(">= %.6g %s", target, unit.c_str()),
        met, met ? "" : format(" (%.0f %% of it)", 100 * measured / target), from);
  }
  void at_most(const std::string& what, double measured, double target, const std::string& unit,
               const std::string& from) {
    const bool met = measured <= target;
    add(what, format("%.3g %s", measured, unit.c_str()), format("<= %.3g %s", target, unit.c_str()),
        met, met ? "" : format(" (%.2f times it)", measured / target), from);
  }
  void skipped(const std::string& what, const std::string& why) {
    rows_.push_back("| " + what + " | | | skipped | " + why + " |");
  }

  void print() const {
    std::puts("| what | measured | target | verdict | from |\n|---|---|---|---|---|");
    for (const std::string& row : rows_) std::puts(row.c_str());
    std::printf("\n%d of %zu missed.\n", missed_, rows_.size());
  }
  int missed() const { return missed_; }

 private:
  void add(const std::string& what, const std::string& measured, const std::string& target,
           bool met, const std::string& shortfall, const std::string& from) {
    if (!met) ++missed_;
    rows_.push_back("| " + what + " | " + measured + " | " + target + " | " +
                    (met ? "met" : "MISSED" + shortfall) + " | " + from + " |");
    std::fprintf(stderr, "%s\n", rows_.back().c_str());
  }

  std::vector<std::string> rows_;
  int missed_ = 0;
};

}  // namespace benchmarks
