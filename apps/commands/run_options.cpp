#include "apps/commands/run_options.h"

#include <algorithm>
#include <thread>

#include "apps/memory_limit.h"
#include "apps/options.h"
#include "apps/quantities.h"

namespace apps {

RunOptions::RunOptions()
    : threads(static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))) {}

void RunOptions::add_to(CLI::App* app) {
  add_parsed(app, "--threads", threads, count_between(1, 1024),
             "threads (default: all); the result does not depend on them", "N");
  add_memory_limit(app, memory_limit);
  add_parsed(app, "--time-limit", time_limit, parse_duration, "give up after this", "TIME");
  app->add_flag("--strict", strict,
                "fail with 5 where accuracy or sampling cannot be attained, instead of warning");
}

evaluation::RunLimits RunOptions::limits() const {
  evaluation::RunLimits limits;
  limits.threads = threads;
  if (time_limit) limits.time = {start_, *time_limit};
  return limits;
}

}  // namespace apps
