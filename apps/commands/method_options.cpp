#include "apps/commands/method_options.h"

#include "brdf/error.h"
#include "evaluation/methods.h"

namespace apps {

std::string amplitude_methods() {
  std::string names;
  for (const evaluation::Method& method : evaluation::methods())
    names.append(names.empty() ? "" : "|").append(method.name);
  return names;
}

void require_tolerance(const std::string& option, double tolerance) {
  if (!(tolerance > 0 && tolerance < 1))
    throw brdf::Error(brdf::Errc::invalid_argument,
                      option + " " + brdf::text(tolerance) + ": must lie between 0 and 1");
}

}  // namespace apps
