#include "apps/commands/like_options.h"

#include "apps/options.h"
#include "apps/quantities.h"
#include "evaluation/readers/file_bytes.h"
#include "evaluation/tradeoff/tradeoff.h"

namespace apps {

void LikeOptions::add_to(CLI::App* app) {
  add_parsed(
      app, "--like", file,
      [this](const std::string& option, const std::string& text) {
        const std::size_t colon = text.rfind(':');
        if (colon == std::string::npos)
          throw brdf::Error(brdf::Errc::invalid_argument,
                            option + " " + text + ": must be FILE:ROW, as frontier.csv:12");
        row = static_cast<std::size_t>(parse_count(option, text.substr(colon + 1), 1, 1000000));
        return parse_path(option, text.substr(0, colon));
      },
      "method and knobs of that row of a table of tradeoff", "FILE:ROW");
}

void LikeOptions::read() {
  trial = evaluation::trial_from_csv(evaluation::read_file_bytes(file), file, row);
}

}  // namespace apps
