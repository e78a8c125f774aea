#include "apps/commands/checkpoint_options.h"

#include <fmt/format.h>

#include "apps/console.h"
#include "apps/options.h"

namespace apps {

void CheckpointOptions::add_to(CLI::App* app) {
  add_parsed(app, "--checkpoint", file, parse_path,
             "keep what is done in this file, and go on from it where it is there; it is removed "
             "once the output is in place",
             "FILE");
}

std::shared_ptr<evaluation::Checkpoint> CheckpointOptions::open(evaluation::Json request) const {
  if (file.empty()) return nullptr;
  // The same heights under another name are the same request.
  if (request.contains("input")) request["input"].erase("file");
  const auto report = [file = file](const evaluation::Resumed& found) {
    message(fmt::format("{}: {} of {} chunks taken over, {} damaged", file, found.taken_over,
                        found.chunks, found.damaged));
  };
  return std::make_shared<evaluation::Checkpoint>(file, std::move(request), report);
}

}  // namespace apps
