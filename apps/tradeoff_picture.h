// The picture of a trade-off: error against time, with the frontier.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "apps/picture_format.h"
#include "evaluation/tradeoff/tradeoff.h"

namespace apps {

struct TradeoffPicture {
  std::span<const evaluation::TradeoffRow> rows;
  std::vector<std::size_t> chosen;  ///< rows to be ringed
  std::string title;
};

/// One panel for each surface model, on logarithmic axes: seconds to plan and evaluate the request,
/// worst error of the amplitude. The bytes of a file.
std::string draw(const TradeoffPicture& picture, PictureFormat format);

}  // namespace apps
