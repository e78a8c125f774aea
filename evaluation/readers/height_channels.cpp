#include "evaluation/readers/height_channels.h"

#include <charconv>
#include <vector>

#include "brdf/error.h"
#include "evaluation/lengths.h"

namespace evaluation {
namespace {

using brdf::Errc;
using brdf::Error;

template <class Fits>
std::vector<std::size_t> places(std::span<const HeightChannel> channels, Fits fits) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (fits(channels[i])) found.push_back(i);
  return found;
}

/// The index of a number from 1; the count of channels where it is none of them.
std::size_t numbered(const std::string& wish, std::size_t count) {
  std::size_t number = 0;
  const char* end = wish.data() + wish.size();
  const auto [after, ec] = std::from_chars(wish.data(), end, number);
  return ec == std::errc{} && after == end && number >= 1 && number <= count ? number - 1 : count;
}

}  // namespace

std::string listed(std::span<const HeightChannel> channels) {
  std::string list;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const HeightChannel& channel = channels[i];
    list.append(i == 0 ? "" : ", ").append(std::to_string(i + 1));
    if (!channel.title.empty()) list.append(" \"").append(channel.title).append("\"");
    list.append(" (").append(channel.unit.empty() ? "no unit" : channel.unit).append(")");
  }
  return list;
}

std::size_t chosen_channel(std::span<const HeightChannel> channels,
                           const std::optional<std::string>& wish, const std::string& name) {
  if (channels.empty()) throw Error(Errc::bad_input, name + ": holds no channel with heights");
  const std::string there_are = "; there are " + listed(channels);
  if (wish) {
    const auto titled = places(channels, [&](const HeightChannel& c) { return c.title == *wish; });
    if (titled.size() == 1) return titled[0];
    if (titled.size() > 1)
      throw Error(Errc::invalid_argument, name + ": --channel " + *wish + " is the title of " +
                                              std::to_string(titled.size()) +
                                              " channels, give the number" + there_are);
    const std::size_t index = numbered(*wish, channels.size());
    if (index == channels.size())
      throw Error(Errc::invalid_argument,
                  name + ": --channel " + *wish + ": no such channel" + there_are);
    return index;
  }
  if (channels.size() == 1) return 0;
  const auto lengths = places(
      channels, [](const HeightChannel& channel) { return length_unit(channel.unit).has_value(); });
  if (lengths.size() == 1) return lengths[0];
  throw Error(Errc::bad_input, name + ": " + std::to_string(lengths.size()) + " of " +
                                   std::to_string(channels.size()) +
                                   " channels hold lengths, give --channel" + there_are);
}

}  // namespace evaluation
