// Titles in the headers of files that are read line by line.
#pragma once

#include <string>

namespace evaluation {

/// A title as part of one line, whatever it holds: control characters become blanks.
inline std::string in_one_line(std::string title) {
  for (char& c : title)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return title;
}

}  // namespace evaluation
