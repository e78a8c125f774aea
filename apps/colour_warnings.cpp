#include "apps/colour_warnings.h"

#include <fmt/format.h>

#include "apps/console.h"
#include "apps/quantities.h"
#include "brdf/error.h"

namespace apps {

void warn_of_coverage(const evaluation::SpectralCoverage& coverage, const std::string& file) {
  if (!coverage.spans_visible())
    message(
        fmt::format("warning: {}: wavelengths from {} to {} nm leave out a part of 400 to "
                    "700 nm: the colours lack it",
                    file, coverage.first_nm, coverage.last_nm));
  if (!coverage.is_fine())
    message(
        fmt::format("warning: {}: wavelengths up to {:.6g} nm apart: colours need steps of at "
                    "most 10 nm, better 5",
                    file, coverage.largest_step_nm));
}

void warn_of_clipped(std::size_t clipped, std::size_t all, const std::string& what,
                     const std::string& space, const std::string& file) {
  if (clipped == 0) return;
  message(fmt::format("warning: {}: {} of {} {} lie outside {} and were clipped", file, clipped,
                      all, what, space));
}

double parse_exposure(const std::string& option, const std::string& text) {
  const double exposure = parse_number(option, text);
  if (!(exposure > 0))
    throw brdf::Error(brdf::Errc::invalid_argument, option + " " + text + ": must be > 0");
  return exposure;
}

}  // namespace apps
