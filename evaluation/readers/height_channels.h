// The channels of a file that holds several pictures.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace evaluation {

/// A channel as its file names it.
struct HeightChannel {
  std::string title;      ///< empty where it has none
  std::string unit = {};  ///< of its values, as the file writes it; empty where it has none
};

/// The channels for people, numbered from 1: `1 "Topography" (m), 2 "Phase" (deg)`.
std::string listed(std::span<const HeightChannel> channels);

/// The index of the channel that is read: the one of that title, or of that number in the list
/// from 1; without a wish the only one there is, or the only one whose unit is a length.
///
/// Throws Errc::invalid_argument for a wish that no channel or several meet, Errc::bad_input where
/// there is no channel, or one has to be wished for; both with the list.
std::size_t chosen_channel(std::span<const HeightChannel> channels,
                           const std::optional<std::string>& wish, const std::string& name);

}  // namespace evaluation
