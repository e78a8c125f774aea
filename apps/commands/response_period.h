// The period of a response: all its lobes at once, or its brightest angles.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "apps/response_input.h"
#include "evaluation/period/ridge_cells.h"

namespace apps {

/// What of a response the period is taken from.
enum class PeriodBy {
  lobes,  ///< the model of all lobes, whose sidecar says how they came about
  peaks,  ///< the brightest angle of each wavelength
};

struct ResponsePeriodOptions {
  ResponseOptions response;
  std::optional<PeriodBy> by;
  std::optional<evaluation::Relief> relief;

  /// Adds all options but the file.
  void add_to(CLI::App* app);
};

/// The period with all that is known of it. Throws Errc::not_attainable, naming the reason, where
/// the response cannot tell.
evaluation::Json response_period(const ResponsePeriodOptions& options);

/// The same for people.
std::string response_period_text(const evaluation::Json& result);

}  // namespace apps
