// Titles in the headers of files that are read line by line.
#pragma once

#include <string>

namespace evaluation {

/// A title in UTF-8 as part of one line, whatever it holds: control characters become blanks, and
/// what is longer than a line of a header should be is cut between two characters.
inline std::string in_one_line(std::string title) {
  constexpr std::size_t longest = 1000;
  if (title.size() > longest) {
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(title[end]) & 0xC0) == 0x80) --end;
    title.resize(end);
  }
  for (char& c : title)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return title;
}

}  // namespace evaluation
