// What the program returns to the shell.
#pragma once

#include "brdf/error.h"

namespace apps {

enum ExitCode : int {
  exit_done = 0,
  exit_validation_failed = 1,
  exit_usage = 2,
  exit_input_refused = 3,
  exit_cannot_write = 4,
  exit_not_attainable = 5,
  exit_over_limit = 6,
  exit_internal = 70,  ///< a fault of the program itself
};

inline ExitCode exit_code(brdf::Errc code) {
  switch (code) {
    case brdf::Errc::invalid_argument:
      return exit_usage;
    case brdf::Errc::bad_input:
      return exit_input_refused;
    case brdf::Errc::cannot_write:
      return exit_cannot_write;
    case brdf::Errc::not_attainable:
      return exit_not_attainable;
    case brdf::Errc::over_limit:
      return exit_over_limit;
  }
  return exit_internal;
}

/// Thrown by a validation that ran to its end and failed.
struct ValidationFailed {};

}  // namespace apps
