// What the program says on standard error, and what --strict makes of it.
#pragma once

#include <string>
#include <string_view>

#include "evaluation/sweep.h"

namespace apps {

/// Results go to standard output, messages here: one line each, whatever a file name holds.
void message(const std::string& text);

/// Writes results to standard output. Throws Errc::cannot_write where that fails (a full disk).
void print(std::string_view result);

/// What to do about accuracy or physics that cannot be had.
enum class Attainability {
  warn,
  refuse,  ///< --strict
};

/// A warning, or with `refuse` Errc::not_attainable with the same line.
void report_unattained(const std::string& line, Attainability attainability);

/// A progress line on a terminal; nothing elsewhere, nor in the first second.
evaluation::Progress progress_line(std::string_view what);

}  // namespace apps
