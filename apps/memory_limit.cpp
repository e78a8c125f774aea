#include "apps/memory_limit.h"

#include <fmt/format.h>
#include <unistd.h>

#include "apps/options.h"
#include "apps/quantities.h"
#include "brdf/error.h"

namespace apps {
namespace {

/// Physical memory, or all there is to address where the system does not say.
std::size_t physical_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
  if (pages <= 0 || page <= 0) return std::size_t(-1);
  return static_cast<std::size_t>(pages) * static_cast<std::size_t>(page);
}

}  // namespace

void add_memory_limit(CLI::App* app, std::optional<std::size_t>& limit) {
  add_parsed(app, "--memory-limit", limit, parse_bytes,
             "refuse what needs more (default 80 % of the machine's)", "BYTES");
}

std::size_t memory_allowed(const std::optional<std::size_t>& limit) {
  return limit.value_or(physical_memory() / 10 * 8);
}

void require_memory(const MemoryNeed& need, const std::optional<std::size_t>& limit) {
  const std::size_t allowed = memory_allowed(limit);
  if (need.bytes > allowed)
    throw brdf::Error(
        brdf::Errc::over_limit,
        fmt::format("{}: {} needs about {:.3g} MB, the limit is {:.3g} MB (--memory-limit); {}",
                    need.file, need.what, static_cast<double>(need.bytes) / 1e6,
                    static_cast<double>(allowed) / 1e6, need.advice));
}

}  // namespace apps
